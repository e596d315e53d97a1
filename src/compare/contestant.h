#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/stage_clock.h"
#include "mesh/triangle_mesh.h"
#include "volume/level.h"
#include "volume/volume.h"

namespace voroprobe
{

//! What every contestant is asked to do: the same volume, the same surface and, where it takes any, the same
//! criteria. CGAL means the same by them: the radius of the surface Delaunay ball, the distance from
//! circumcenter to ball center, the angles of the facet. Lengths in scan units.
struct MeshingTask
{
    std::shared_ptr<const Volume> volume; //!< grid frame
    double isovalue;                      //!< beyond the samples is outside
    InsideIs inside = InsideIs::kAbove;   //!< which side of the isovalue; samples equal to it are inside
    double min_facet_angle_deg;
    double max_facet_radius;
    double max_facet_distance;
    double floor_radius; //!< ours only, CGAL has nothing like it
    double reach;        //!< ours only, too: spacing of probes
    double peer_error_bound =
        1e-3; //!< CGAL's own: error of its intersections, as a share of the domain's radius
    std::size_t target_vertices = 0; //!< of contestants that are told how many
    double target_edge_length = 0.0; //!< of contestants that are told how long
    std::size_t threads = 1;         //!< of contestants that can use more than one
};

//! A mesher that took its input in and waits to be timed. Only mesh() is on the clock: copying the samples
//! into a format of the contestant's own before, and the result out of it after, is not.
class Contestant
{
public:
    virtual ~Contestant() = default;

    //! Everything from samples in memory to a finished mesh in the contestant's own data structure. Begins
    //! its stages.
    virtual void mesh(StageClock& clock) = 0;

    //! The mesh that mesh() made, grid frame. Vertices on no face are left out.
    [[nodiscard]] virtual TriangleMesh result() const = 0;
};

//! Voroprobe, the inventory included.
std::unique_ptr<Contestant> make_voroprobe(const MeshingTask& task);

//! Our refinement alone, as the others refine: no inventory, so that no surface is looked for, held apart
//! from another or given its handles.
std::unique_ptr<Contestant> make_voroprobe_refinement(const MeshingTask& task);

//! Where the surface mesher gets its first points.
enum class FirstPoints
{
    kDefault, //!< CGAL's: 20 rays from the middle of the bounding sphere
    kSeeded   //!< and as many on every connected set of inside samples
};

//! CGAL 5.5 make_surface_mesh.
std::unique_ptr<Contestant> make_surface_mesher(const MeshingTask& task, FirstPoints points);

//! Where Mesh_3 gets its first points.
enum class Mesh3Seeding
{
    kDefault, //!< CGAL's: rays from the middle of the domain
    kScan     //!< rays from every connected set of inside voxels: initialize_triangulation_from_gray_image
};

//! CGAL 5.5 make_mesh_3, sequential, facet criteria only.
std::unique_ptr<Contestant> make_mesh_3(const MeshingTask& task, Mesh3Seeding seeding);

//! VTK's FlyingEdges. The volume is surrounded by a layer of outside samples, so that the surface is closed;
//! vertices in that layer are then moved onto the border, where the object ends. The cap is that of marching
//! squares.
std::unique_ptr<Contestant> make_marching_cubes(const MeshingTask& task);

//! The same, then VTK's quadric decimation to `target_vertices`.
std::unique_ptr<Contestant> make_decimated(const MeshingTask& task);

//! The same, then VTK's windowed-sinc smoothing with the settings of 3D Slicer's closed surfaces (factor
//! 0.5).
std::unique_ptr<Contestant> make_smoothed(const MeshingTask& task);

//! The same, then CGAL's isotropic remeshing (three rounds) to `target_edge_length`.
std::unique_ptr<Contestant> make_remeshed(const MeshingTask& task);

//! OpenVDB's volumeToMesh without adaptivity on the volume as a dense grid, with the border as for marching
//! cubes; quads are cut along their shorter diagonal.
std::unique_ptr<Contestant> make_openvdb(const MeshingTask& task);

//! A mesh made elsewhere, grid frame: it takes no time.
std::unique_ptr<Contestant> make_given(TriangleMesh mesh);

} // namespace voroprobe
