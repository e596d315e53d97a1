#include "postprocess/repair.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include "mesh/edge_table.h"
#include "mesh/topology.h"

namespace voroprobe
{

namespace
{

namespace pmp = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = TriangleMesh::Face;

struct Soup
{
    std::vector<Kernel::Point_3> points;
    std::vector<std::vector<std::size_t>> polygons;
};

Face sorted(Face face)
{
    std::sort(face.begin(), face.end());
    return face;
}

TriangleMesh without_useless_faces(const TriangleMesh& mesh, std::size_t& dropped)
{
    std::vector<bool> kept;
    std::set<Face> seen;
    for (const Face& face : mesh.faces)
        kept.push_back(!names_a_vertex_twice(face) && seen.insert(sorted(face)).second);
    dropped = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), false));
    return with_faces(mesh, kept); // takes vertices on no face out as well
}

Soup soup_of(const TriangleMesh& mesh)
{
    Soup soup;
    for (const Point3& p : mesh.vertices)
        soup.points.emplace_back(p.x, p.y, p.z);
    for (const Face& face : mesh.faces)
        soup.polygons.push_back({face[0], face[1], face[2]});
    return soup;
}

TriangleMesh mesh_of(const Surface& surface)
{
    TriangleMesh mesh;
    std::vector<std::uint32_t> number(surface.num_vertices() + surface.number_of_removed_vertices());
    for (const auto vertex : surface.vertices())
    {
        const auto& p = surface.point(vertex);
        number[vertex.idx()] = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back({p.x(), p.y(), p.z()});
    }
    for (const auto face : surface.faces())
    {
        Face corners{};
        std::size_t i = 0;
        for (const auto vertex : CGAL::vertices_around_face(surface.halfedge(face), surface))
            corners[i++] = number[vertex.idx()];
        mesh.faces.push_back(corners);
    }
    return mesh;
}

//! Faces that have an edge in another direction than `before` had it, by their order, which stays.
std::size_t count_turned(const std::vector<Kernel::Point_3>& before_points, const Soup& before,
                         const Surface& after)
{
    const auto winding = [](const Kernel::Point_3& a, const Kernel::Point_3& b, const Kernel::Point_3& c)
    { return CGAL::cross_product(b - a, c - a); };
    std::size_t turned = 0;
    std::size_t f = 0;
    for (const auto face : after.faces())
    {
        if (f == before.polygons.size())
            break; // what follows closes holes
        const auto& polygon = before.polygons[f++];
        std::array<Kernel::Point_3, 3> corners;
        std::size_t i = 0;
        for (const auto vertex : CGAL::vertices_around_face(after.halfedge(face), after))
            corners[i++] = after.point(vertex);
        const auto was =
            winding(before_points[polygon[0]], before_points[polygon[1]], before_points[polygon[2]]);
        turned += CGAL::scalar_product(was, winding(corners[0], corners[1], corners[2])) < 0.0 ? 1 : 0;
    }
    return turned;
}

void close_holes(Surface& surface, const RepairOptions& options, RepairResult& result)
{
    std::vector<Surface::Halfedge_index> rims;
    pmp::extract_boundary_cycles(surface, std::back_inserter(rims));
    for (const auto rim : rims)
    {
        std::vector<Surface::Face_index> patch;
        const bool small =
            !options.max_hole_rim || pmp::face_border_length(rim, surface) <= *options.max_hole_rim;
        if (small)
            pmp::triangulate_hole(surface, rim, std::back_inserter(patch));
        ++(patch.empty() ? result.holes_left : result.holes_closed);
    }
}

} // namespace

RepairResult repair(const TriangleMesh& mesh, const RepairOptions& options)
{
    RepairResult result;
    const TriangleMesh clean = without_useless_faces(mesh, result.faces_dropped);
    const Soup before = soup_of(clean);
    Soup soup = before;
    pmp::orient_polygon_soup(soup.points, soup.polygons);
    result.vertices_split = soup.points.size() - before.points.size();
    Surface surface;
    pmp::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, surface);
    close_holes(surface, options, result);
    if (CGAL::is_closed(surface))
        pmp::orient_to_bound_a_volume(surface);
    result.faces_turned = count_turned(before.points, before, surface);
    result.mesh = mesh_of(surface);
    return result;
}

} // namespace voroprobe
