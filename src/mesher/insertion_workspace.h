#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesher/delaunay.h"

namespace voroprobe
{

//! What insertions take from and what they leave to be looked at. RestrictedDelaunay has one; where threads
//! insert side by side, each subdomain has one of its own, with a stock.
struct InsertionWorkspace
{
    //! What a subdomain's insertions are made of, taken from the triangulation beforehand: threads cannot
    //! share its containers.
    struct Stock
    {
        std::vector<DelaunayCell> cells;
        std::vector<VertexHandle> vertices;
        std::uint32_t first_index = 0;          //!< of the vertices made in a round
        std::vector<VertexHandle> new_vertices; //!< of a round
        std::vector<FacetId> new_facets;        //!< of a round, some of them gone since, or twice
        //! The newest cell at each sentinel: all subdomains have those in common, and leave them as they are.
        std::array<DelaunayCell, kSentinelCount> cell_of_sentinel{};
    };

    bool has_stock = false;
    Stock stock;

    std::vector<FacetId> free_facets;
    std::vector<FacetId> changed_facets; //!< by the last insertion, or by asking about even facets
    std::vector<VertexHandle> unchecked_vertices;
    std::vector<VertexHandle> unprobed_vertices;
    std::vector<DelaunayCell> postponed_cells; //!< with facets not asked about; some are gone since
    std::vector<DelaunayCell> star;            //!< scratch: the new cells of an insertion

    std::size_t insertions = 0;
    std::size_t queries = 0; //!< about dual edges
    std::size_t region_lookups = 0;
};

} // namespace voroprobe
