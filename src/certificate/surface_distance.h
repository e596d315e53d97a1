#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "certificate/face_tree.h"
#include "certificate/nearest_crossing.h"
#include "mesh/triangle_mesh.h"
#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! Distances of sampled points of one surface to another, scan units.
struct DirectedDistance
{
    std::size_t samples = 0;
    double max = 0.0;
    Point3 max_at;     //!< the sample it was found at
    double mean = 0.0; //!< over samples spread evenly by area
    double root_mean_square = 0.0;
    double percentile_95 = 0.0;
    std::vector<double> spread; //!< of the samples spread evenly by area, ascending
};

//! Infinite where one of the two is empty and the other is not.
struct SurfaceDistance
{
    DirectedDistance from_mesh;    //!< of points of the mesh to the surface; each an upper bound
    DirectedDistance from_surface; //!< of points of the surface to the mesh; each exact

    [[nodiscard]] double max() const;
    [[nodiscard]] double mean() const; //!< of the two means
};

//! How many points to take, and where.
struct SamplingOptions
{
    //! Points of the mesh: half of them vertices, middles of sides and centroids, half spread by area.
    std::size_t mesh_samples = 20000;

    //! Points of the surface wanted; from half as many (fewer on surfaces that next to no line meets) to as
    //! many.
    std::size_t surface_samples = 10000;

    //! Same seed, same samples.
    std::uint64_t seed = 0;

    //! Whether caps on the border of the domain are part of the surface.
    BorderCaps caps = BorderCaps::kCounted;

    //! Where the surface is looked for, oracle frame. Unset: the oracle's domain.
    std::optional<Box3> box = std::nullopt;
};

//! Points of the surface: crossings of axis-parallel lines, one at a random place in every cell of a regular
//! lattice, along each axis in turn. Every part of the surface gets 1 to 1.7 times the points of the part
//! that gets fewest per area. Deterministic, on all cores.
std::vector<Point3> sample_surface(const SurfaceOracle& oracle, const SamplingOptions& options);

//! Both ways. `surface_points`: points of the surface to take whatever the lines meet, such as one of each
//! component. Frame: the oracle's. The largest distance is that of the samples: between them there may be a
//! larger one. Deterministic whatever the number of cores.
SurfaceDistance surface_distance(const TriangleMesh& mesh, const SurfaceOracle& oracle,
                                 const SamplingOptions& options = {},
                                 std::span<const Point3> surface_points = {});

//! The same for a mesh whose tree there is.
SurfaceDistance surface_distance(const FaceTree& tree, const SurfaceOracle& oracle,
                                 const SamplingOptions& options, std::span<const Point3> surface_points);

} // namespace voroprobe
