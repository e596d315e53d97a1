#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/vec3.h"

namespace voroprobe
{

//! Which isolated vertices are initialized before the next refinement (Feree & Alliez 2009, Sec. 5).
enum class IsolatedVertices
{
    kOneAtATime, //!< the complete version of the paper: fewest vertices
    kAllAtOnce   //!< fewer refinement rounds
};

//! How the mesher gets its first point on each component.
enum class Seeding
{
    kInventory, //!< probe the domain, isolated vertices, then what the oracle's inventory lists; as kProbe
                //!< where the oracle has none
    kProbe,    //!< the paper: probe the domain, isolated vertices, then the Voronoi cells; and the inventory,
               //!< where there is one, for what that leaves
    kIsolated, //!< its partial version: probe the domain, isolated vertices (Sec. 5)
    kRandom    //!< as CGAL does: rays from the center of the domain, then refinement alone (Sec. 3)
};

//! A closed ball, radius > 0.
struct Ball
{
    Point3 center;
    double radius;
};

//! What the mesh has to satisfy. Lengths in scan units.
struct MeshingOptions
{
    //! Largest surface Delaunay ball radius, > 0: bounds the edge lengths by twice this.
    double max_facet_radius;

    //! Largest distance between a facet's circumcenter and the center of its surface Delaunay ball, > 0.
    //! Unset: no distance criterion.
    std::optional<double> max_facet_distance = std::nullopt;

    //! Smallest accepted facet angle, degrees, in [0, 30]; above 30 refinement need not terminate
    //! (Boissonnat & Oudot 2005).
    double min_facet_angle_deg = 30.0;

    //! Facets whose surface Delaunay ball is no larger than this are not refined for the sake of topology, >
    //! 0. Ends the chase at the creases of the trilinear interpolant and at contacts of zero reach; a quarter
    //! of a voxel is sensible.
    double floor_radius;

    //! A strict lower bound of the surface's reach, > 0: sets the spacing of probes. Components closer or
    //! thinner may be missed.
    double reach_lower_bound;

    //! A radius of at least the reach such that the volume within every component holds a ball of it: every
    //! point of the domain is then within this of a probe, rather than within the reach. Unset: the reach.
    std::optional<double> component_radius = std::nullopt;

    //! Stop probing once so many components are meshed. Unset: probe the whole domain.
    std::optional<std::size_t> component_count = std::nullopt;

    //! The domain, if it is a ball rather than the oracle's box: it must hold the object.
    std::optional<Ball> domain_ball = std::nullopt;

    //! Spend no probes where the oracle certifies that there is no surface. The promise is the same, the cost
    //! follows the surface's area and not the domain's volume.
    bool certified_skipping = true;

    //! Points near components that need not be looked for, oracle frame. One farther from the surface than
    //! the reach is counted and left out.
    std::vector<Point3> seeds = {};

    //! Seeding::kRandom: how many points, and the seed of the generator.
    std::size_t random_points = 20;
    std::uint64_t random_seed = 0;

    //! Begin components with persistent facets, whose surface Delaunay balls are under half the largest
    //! radius, rather than with large ones first (Feree & Alliez 2009, Definition 10).
    bool persistent_initialization = false;

    Seeding seeding = Seeding::kInventory;

    IsolatedVertices isolated_vertices = IsolatedVertices::kAllAtOnce;

    //! Keep the faces that close the object where it leaves the domain.
    bool close_border = true;

    //! Threads that refine side by side, 0 for all there are. The mesh is the same for any number.
    std::size_t threads = 1;

    //! Refinement stops there with a flagged partial result. Unset: no bound.
    std::optional<std::size_t> max_vertices = std::nullopt;

    //! Seconds after which the run stops with a flagged partial result, >= 0. Unset: no bound.
    std::optional<double> max_seconds = std::nullopt;
};

//! \throw UsageError that names the first option out of its range, its value, and the range.
void check_options(const MeshingOptions& options);

} // namespace voroprobe
