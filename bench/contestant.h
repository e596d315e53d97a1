#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "volume/volume.h"

namespace voroprobe::bench
{

//! What every contestant is asked to do: the same volume, the same surface, the same criteria. CGAL means the
//! same by them: the radius of the surface Delaunay ball, the distance from circumcenter to ball center, the
//! angles of the facet.
struct MeshingTask
{
    std::shared_ptr<const Volume> volume; //!< grid frame
    double isovalue;                      //!< inside: sample >= isovalue; beyond the samples is outside
    double min_facet_angle_deg;
    double max_facet_radius;   //!< scan units
    double max_facet_distance; //!< scan units
    double floor_radius;       //!< scan units; ours only, CGAL has nothing like it
    double peer_error_bound;   //!< CGAL's own: error of its intersections, as a share of the domain's radius
};

//! A mesher that took its input in and waits to be timed. Only mesh() is on the clock: copying the samples
//! into a format of the contestant's own before, and the result out of it after, is not.
class Contestant
{
public:
    virtual ~Contestant() = default;

    //! Everything from samples in memory to a finished mesh in the contestant's own data structure.
    virtual void mesh() = 0;

    //! The mesh that mesh() made, grid frame. Vertices on no face are left out.
    [[nodiscard]] virtual TriangleMesh result() const = 0;
};

std::unique_ptr<Contestant> make_voroprobe(const MeshingTask& task);

//! CGAL 5.5 make_surface_mesh, default initial points and `kSeedsPerRegion` more on every connected set of
//! inside samples.
std::unique_ptr<Contestant> make_surface_mesher(const MeshingTask& task);

//! CGAL 5.5 make_mesh_3, sequential, facet criteria only, default initial points.
std::unique_ptr<Contestant> make_mesh_3_default(const MeshingTask& task);

//! The same after CGAL's own search for components, initialize_triangulation_from_gray_image.
std::unique_ptr<Contestant> make_mesh_3_scan(const MeshingTask& task);

//! A contestant by name.
struct Entry
{
    std::string name;
    std::function<std::unique_ptr<Contestant>(const MeshingTask&)> make;
};

//! All of them, ours first.
inline std::vector<Entry> all_contestants()
{
    return {{"voroprobe", make_voroprobe},
            {"surface_mesher", make_surface_mesher},
            {"mesh_3", make_mesh_3_default},
            {"mesh_3_scan", make_mesh_3_scan}};
}

} // namespace voroprobe::bench
