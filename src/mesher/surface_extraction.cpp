#include "mesher/surface_extraction.h"

#include <utility>
#include <vector>

#include "mesher/boundary_complex.h"
#include "mesher/component_origins.h"
#include "mesher/contact_separation.h"
#include "mesher/open_border.h"
#include "mesher/pinched_edges.h"

namespace voroprobe
{
namespace
{

ContactReport take_apart(const RestrictedDelaunay& restricted, BoundaryComplex& complex)
{
    const auto pinched = split_pinched_edges(restricted, complex);
    return separate_contacts(restricted, complex, pinched);
}

std::vector<SurfaceId> surfaces_of_faces(const SurfaceOracle& oracle, const BoundaryComplex& complex)
{
    std::vector<SurfaceId> surfaces;
    surfaces.reserve(complex.mesh.faces.size());
    for (const std::uint32_t origin : complex.origin_of_face)
    {
        const BoundaryFace& face = complex.faces[origin];
        surfaces.push_back(oracle.surface_between(face.inside->info().region,
                                                  face.inside->neighbor(face.index)->info().region));
    }
    return surfaces;
}

} // namespace

ExtractedSurface extract_surface(const RestrictedDelaunay& restricted, RegionSettlement& settlement,
                                 const MeshingOptions& options, MeshingStatistics& statistics)
{
    statistics.facets_at_floor = restricted.count_unresolved_facets();
    BoundaryComplex complex = collect_boundary(restricted, settlement.table());
    ContactReport contacts = take_apart(restricted, complex);
    while (!contacts.unseparated.empty()) // each time fewer changes are left to undo, or inside cells
    {
        if (!settlement.undo_handles_at(contacts.unseparated))
        {
            statistics.contacts_carved += contacts.unseparated.size();
            settlement.carve(contacts.unseparated);
        }
        complex = collect_boundary(restricted, settlement.table());
        contacts = take_apart(restricted, complex);
    }
    statistics.contacts_separated = contacts.separated;
    settlement.count(statistics);
    statistics.isolated_vertices_abandoned =
        count_abandoned_vertices(complex, restricted.vertex_index_bound());
    std::vector<SurfaceId> surface_of_face = surfaces_of_faces(restricted.oracle(), complex);
    std::vector<FoundPiece> pieces = find_pieces(complex, surface_of_face);
    count_found_pieces(pieces, statistics);
    ExtractedSurface extracted{std::move(complex.mesh), std::move(surface_of_face), std::move(pieces)};
    if (!options.close_border)
        open_border(restricted.oracle(), extracted);
    return extracted;
}

} // namespace voroprobe
