#include "mesher/surface_extraction.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "mesher/boundary_complex.h"
#include "mesher/component_origins.h"
#include "mesher/contact_separation.h"
#include "mesher/pinched_edges.h"
#include "mesher/relabelling.h"

namespace voroprobe
{
namespace
{

// Vertices within this many floor radii of a side of the domain lie on it: far above rounding, below what
// could be seen.
constexpr double kOnSideInFloors = 0.05;

//! Whether the whole face lies on one side of the box.
bool lies_on_side(const TriangleMesh& mesh, const TriangleMesh::Face& face, const Box3& box, double tolerance)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        for (const double side : {box.min[axis], box.max[axis]})
        {
            if (std::all_of(face.begin(), face.end(),
                            [&](std::uint32_t vertex)
                            { return std::abs(mesh.vertices[vertex][axis] - side) <= tolerance; }))
                return true;
        }
    }
    return false;
}

//! Drops the faces on the domain's border, and then the vertices on no face.
void open_border(const Box3& domain, double tolerance, TriangleMesh& mesh)
{
    std::vector<TriangleMesh::Face> kept;
    std::copy_if(mesh.faces.begin(), mesh.faces.end(), std::back_inserter(kept),
                 [&](const TriangleMesh::Face& face)
                 { return !lies_on_side(mesh, face, domain, tolerance); });
    constexpr auto kUnused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> new_index(mesh.vertices.size(), kUnused);
    std::vector<Point3> used;
    for (TriangleMesh::Face& face : kept)
    {
        for (std::uint32_t& corner : face)
        {
            if (new_index[corner] == kUnused)
            {
                new_index[corner] = static_cast<std::uint32_t>(used.size());
                used.push_back(mesh.vertices[corner]);
            }
            corner = new_index[corner];
        }
    }
    mesh.faces = std::move(kept);
    mesh.vertices = std::move(used);
}

ContactReport take_apart(const RestrictedDelaunay& restricted, BoundaryComplex& complex)
{
    const auto pinched = split_pinched_edges(restricted.oracle(), complex);
    return separate_contacts(restricted, complex, pinched);
}

//! Gives the Delaunay cells around the vertices to the outside: the surface no longer passes there.
void carve(const RestrictedDelaunay& restricted, const std::vector<VertexHandle>& vertices)
{
    std::vector<DelaunayCell> star;
    for (const VertexHandle vertex : vertices)
    {
        star.clear();
        restricted.triangulation().incident_cells(vertex, std::back_inserter(star));
        for (const DelaunayCell delaunay_cell : star)
        {
            if (!is_inside(delaunay_cell->info().region))
                continue;
            delaunay_cell->info().region = kOuterRegion;
            for (int i = 0; i < 4; ++i)
                delaunay_cell->vertex(i)->info().pinched = true; // as far as is known
        }
    }
}

} // namespace

TriangleMesh extract_surface(RestrictedDelaunay& restricted, const MeshingOptions& options,
                             MeshingStatistics& statistics)
{
    statistics.facets_at_floor = restricted.count_unresolved_facets();
    statistics.cells_relabelled = relabel_pinched_cells(restricted, options);
    BoundaryComplex complex = collect_boundary(restricted);
    ContactReport contacts = take_apart(restricted, complex);
    while (!contacts.unseparated.empty()) // each time fewer inside cells are left
    {
        statistics.contacts_carved += contacts.unseparated.size();
        carve(restricted, contacts.unseparated);
        complex = collect_boundary(restricted);
        contacts = take_apart(restricted, complex);
    }
    statistics.contacts_separated = contacts.separated;
    count_component_origins(complex, statistics);
    TriangleMesh mesh = std::move(complex.mesh);
    if (!options.close_border)
        open_border(restricted.oracle().domain(), kOnSideInFloors * options.floor_radius, mesh);
    return mesh;
}

} // namespace voroprobe
