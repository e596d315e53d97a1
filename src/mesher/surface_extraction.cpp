#include "mesher/surface_extraction.h"

#include <cstdint>
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

//! Drops the faces on the domain's border, and then the vertices on no face.
void open_border(const BoundaryComplex& complex, TriangleMesh& mesh)
{
    std::vector<TriangleMesh::Face> kept;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    {
        if (!complex.faces[complex.origin_of_face[f]].on_border)
            kept.push_back(mesh.faces[f]);
    }
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

} // namespace

TriangleMesh extract_surface(RestrictedDelaunay& restricted, const MeshingOptions& options,
                             MeshingStatistics& statistics)
{
    statistics.facets_at_floor = restricted.count_unresolved_facets();
    statistics.cells_relabelled = relabel_pinched_cells(restricted, options);
    BoundaryComplex complex = collect_boundary(restricted);
    const auto pinched = split_pinched_edges(restricted.oracle(), complex);
    const ContactReport contacts = separate_contacts(restricted, complex, pinched);
    statistics.contacts_separated = contacts.separated;
    statistics.contacts_unseparated = contacts.unseparated;
    count_component_origins(complex, statistics);
    TriangleMesh mesh = std::move(complex.mesh);
    if (!options.close_border)
        open_border(complex, mesh);
    return mesh;
}

} // namespace voroprobe
