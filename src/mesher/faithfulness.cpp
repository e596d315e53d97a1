#include "mesher/faithfulness.h"

namespace voroprobe
{

std::vector<SurfaceId> find_missing_surfaces(const RestrictedDelaunay& restricted)
{
    std::vector<bool> has_facet(restricted.oracle().surface_count(), false);
    if (has_facet.empty())
        return {};
    for (FacetId id = 0; id < restricted.facet_slots(); ++id)
    {
        const RestrictedFacet& facet = restricted.facet(id);
        if (!facet.odd())
            continue;
        const SurfaceId surface = restricted.surface(facet);
        if (surface != kNoSurface)
            has_facet[static_cast<std::size_t>(surface)] = true;
    }
    std::vector<SurfaceId> missing;
    for (std::size_t surface = 0; surface < has_facet.size(); ++surface)
    {
        if (!has_facet[surface])
            missing.push_back(static_cast<SurfaceId>(surface));
    }
    return missing;
}

std::vector<Point3> find_unfaithful_places(const RestrictedDelaunay& restricted)
{
    std::vector<Point3> places;
    for (FacetId id = 0; id < restricted.facet_slots(); ++id)
    {
        const RestrictedFacet& facet = restricted.facet(id);
        if (facet.crossing_count == 0)
            continue;
        const bool faithful = facet.odd() ? restricted.is_faithful(facet)
                                          : facet.delaunay_cell->info().region ==
                                                facet.delaunay_cell->neighbor(facet.index)->info().region;
        if (!faithful)
            places.push_back(facet.center);
    }
    return places;
}

std::size_t seed_surfaces(const std::vector<SurfaceId>& surfaces, std::size_t most,
                          const SurfaceOracle& oracle, Refinement& refinement)
{
    std::size_t inserted = 0;
    VertexHandle last;
    for (const std::vector<Point3>& points : oracle.points_on(surfaces, most))
    {
        for (const Point3& p : points)
        {
            const VertexHandle vertex = refinement.insert(p, VertexOrigin::kInventory, last);
            if (vertex == VertexHandle())
                continue; // a vertex already
            last = vertex;
            ++inserted;
        }
    }
    return inserted;
}

} // namespace voroprobe
