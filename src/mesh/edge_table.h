#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>

#include "mesh/triangle_mesh.h"
#include "support/grouping.h"

namespace voroprobe
{

//! Degenerate faces: those without three different vertices, whatever the coordinates.
inline bool names_a_vertex_twice(const TriangleMesh::Face& face)
{
    return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
}

//! The sides of all faces, those over the same edge next to each other. Sides from a vertex to itself are
//! left out. Memory: 24 bytes a face and 4 a vertex.
class EdgeTable
{
public:
    //! One side of a face: it starts at corner `corner` (3 * face + 0, 1 or 2) and joins a vertex to a larger
    //! one, `to`, or runs the other way.
    struct Side
    {
        std::uint32_t to;
        std::uint32_t corner;

        friend auto operator<=>(const Side&, const Side&) = default;
    };

    //! \pre faces name existing vertices. Cost: close to linear; about 60 ms for a million faces.
    explicit EdgeTable(const TriangleMesh& mesh);

    //! Calls `visit(std::span<const Side>)` once for every edge, in the order of their smaller vertices;
    //! sides come by corner.
    template <typename Visitor>
    void for_each_edge(Visitor visit) const
    {
        for (std::size_t v = 0; v < vertex_count_; ++v)
        {
            const std::span<const Side> sides = sides_.of(v);
            for (std::size_t begin = 0, end = begin; begin < sides.size(); begin = end)
            {
                while (end < sides.size() && sides[end].to == sides[begin].to)
                    ++end;
                visit(sides.subspan(begin, end - begin));
            }
        }
    }

private:
    Grouping<Side> sides_; //!< by their smaller vertex
    std::size_t vertex_count_;
};

} // namespace voroprobe
