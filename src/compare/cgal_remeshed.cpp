// Marching cubes, then Botsch and Kobbelt's isotropic remeshing as CGAL does it.
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "compare/contestant.h"
#include "compare/marching_cubes.h"

namespace voroprobe
{

namespace
{

namespace pmp = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr unsigned int kRounds = 3;

//! Where the mesh is not manifold, vertices are doubled.
Surface to_surface(const TriangleMesh& mesh)
{
    std::vector<Kernel::Point_3> points;
    points.reserve(mesh.vertices.size());
    for (const Point3& p : mesh.vertices)
        points.emplace_back(p.x, p.y, p.z);
    std::vector<std::array<std::size_t, 3>> polygons;
    polygons.reserve(mesh.faces.size());
    for (const TriangleMesh::Face& face : mesh.faces)
        polygons.push_back({face[0], face[1], face[2]});
    pmp::orient_polygon_soup(points, polygons);
    Surface surface;
    pmp::polygon_soup_to_polygon_mesh(points, polygons, surface);
    return surface;
}

TriangleMesh to_mesh(const Surface& surface)
{
    TriangleMesh mesh;
    std::vector<std::uint32_t> number(surface.number_of_vertices() + surface.number_of_removed_vertices());
    for (const Surface::Vertex_index vertex : surface.vertices())
    {
        number[vertex] = static_cast<std::uint32_t>(mesh.vertices.size());
        const Kernel::Point_3& p = surface.point(vertex);
        mesh.vertices.push_back({p.x(), p.y(), p.z()});
    }
    for (const Surface::Face_index face : surface.faces())
    {
        TriangleMesh::Face corners{};
        std::size_t i = 0;
        for (const Surface::Vertex_index vertex : surface.vertices_around_face(surface.halfedge(face)))
            corners[i++] = number[vertex];
        mesh.faces.push_back(corners);
    }
    return mesh;
}

class Remeshed final : public Contestant
{
public:
    explicit Remeshed(const MeshingTask& task)
        : edge_length_(task.target_edge_length), field_(padded(make_peer_field(task)))
    {
    }

    void mesh(StageClock& clock) override
    {
        surface_ = to_surface(marching_cubes(field_, clock));
        clock.begin("remeshing");
        pmp::isotropic_remeshing(surface_.faces(), edge_length_, surface_,
                                 pmp::parameters::number_of_iterations(kRounds));
    }

    [[nodiscard]] TriangleMesh result() const override { return to_mesh(surface_); }

private:
    double edge_length_;
    PeerField field_;
    Surface surface_;
};

} // namespace

std::unique_ptr<Contestant> make_remeshed(const MeshingTask& task)
{
    return std::make_unique<Remeshed>(task);
}

} // namespace voroprobe
