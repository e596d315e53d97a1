#include "mesher/rim_corners.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "mesh/edge_table.h"

namespace voroprobe
{
namespace
{

using Face = TriangleMesh::Face;

//! An end within this share of its edge from the rim's corner moves there, against slivers.
constexpr double kNearCorner = 0.3;

//! Within this share of an edge from a vertex of the rim there is a corner already.
constexpr double kSameCorner = 0.01;

//! Vertices within this share of the box's diagonal of a side lie on it: above the rounding of crossings.
constexpr double kOnSide = 1e-9;

class RimCorners
{
public:
    RimCorners(const Box3& box, CapFinder& caps, CappedMesh& capped) : box_(box), caps_(caps), capped_(capped)
    {
    }

    //! Of a face with several edges to divide one at a time.
    void add()
    {
        while (add_one_for_each_face())
        {
        }
    }

private:
    //! Whether there were any.
    bool add_one_for_each_face()
    {
        std::vector<std::uint32_t> rim;
        rim_.clear();
        EdgeTable(capped_.mesh)
            .for_each_edge(
                [&](std::span<const EdgeTable::Side> sides)
                {
                    if (sides.size() != 1)
                        return;
                    const std::uint32_t corner = sides.front().corner;
                    rim.push_back(corner);
                    rim_.push_back(capped_.mesh.faces[corner / 3][corner % 3]);
                });
        std::vector<bool> is_divided(capped_.mesh.faces.size(), false);
        bool any = false;
        for (const std::uint32_t side : rim)
        {
            const std::size_t f = side / 3;
            const auto corner = is_divided[f] ? std::nullopt : corner_of_rim(f, side % 3);
            if (!corner || is_taken(*corner, f, side % 3))
                continue;
            is_divided[f] = any = true;
            if (!draw_end_to(*corner, f, side % 3))
                divide(f, side % 3, *corner);
        }
        return any;
    }

    //! The side of the box across an axis that p lies on.
    [[nodiscard]] std::optional<double> side(const Point3& p, std::size_t axis) const
    {
        const double rounding = kOnSide * box_.diagonal();
        for (const double side : {box_.min[axis], box_.max[axis]})
            if (std::abs(p[axis] - side) <= rounding)
                return side;
        return std::nullopt;
    }

    //! Between corners k and k + 1 of a face, if these lie on neighbouring sides of the box and on none
    //! together.
    [[nodiscard]] std::optional<Point3> corner_of_rim(std::size_t f, std::size_t k)
    {
        const Face& face = capped_.mesh.faces[f];
        const Point3 a = capped_.mesh.corner(face, k);
        const Point3 b = capped_.mesh.corner(face, (k + 1) % 3);
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (side(a, axis) && side(a, axis) == side(b, axis))
                return std::nullopt;
        for (std::size_t along = 0; along < 3; ++along)
        {
            const std::size_t u = (along + 1) % 3;
            const std::size_t v = (along + 2) % 3;
            const bool a_first = side(a, u) && side(b, v);
            if (!a_first && !(side(b, u) && side(a, v)))
                continue;
            Point3 on_box_edge = 0.5 * (a + b);
            on_box_edge[u] = *side(a_first ? a : b, u);
            on_box_edge[v] = *side(a_first ? b : a, v);
            Vec3 direction;
            direction[along] = 1.0;
            const auto crossing = caps_.nearest(on_box_edge, direction, distance(a, b));
            if (crossing && !crossing->on_border)
                return crossing->point;
        }
        return std::nullopt;
    }

    //! Whether another vertex of the rim is there: where the rim runs to and fro between two sides.
    [[nodiscard]] bool is_taken(const Point3& corner, std::size_t f, std::size_t k) const
    {
        const TriangleMesh& mesh = capped_.mesh;
        const std::uint32_t a = mesh.faces[f][k];
        const std::uint32_t b = mesh.faces[f][(k + 1) % 3];
        const double same = kSameCorner * distance(mesh.vertices[a], mesh.vertices[b]);
        return std::any_of(rim_.begin(), rim_.end(),
                           [&](std::uint32_t vertex) {
                               return vertex != a && vertex != b &&
                                      distance(mesh.vertices[vertex], corner) < same;
                           });
    }

    [[nodiscard]] std::size_t sides(const Point3& p) const
    {
        return std::size_t{side(p, 0).has_value()} + std::size_t{side(p, 1).has_value()} +
               std::size_t{side(p, 2).has_value()};
    }

    //! Moves an end of the edge between corners k and k + 1 there if it is near, and no corner itself.
    //! Returns whether it is.
    bool draw_end_to(const Point3& corner, std::size_t f, std::size_t k)
    {
        const Face& face = capped_.mesh.faces[f];
        const double near =
            kNearCorner * distance(capped_.mesh.corner(face, k), capped_.mesh.corner(face, (k + 1) % 3));
        for (const std::uint32_t end : {face[k], face[(k + 1) % 3]})
        {
            Point3& at = capped_.mesh.vertices[end];
            if (distance(at, corner) > near || sides(at) > 1)
                continue;
            at = corner;
            return true;
        }
        return false;
    }

    //! Across the edge between corners k and k + 1.
    void divide(std::size_t f, std::size_t k, const Point3& corner)
    {
        const Face face = capped_.mesh.faces[f];
        const std::uint32_t a = face[k];
        const std::uint32_t b = face[(k + 1) % 3];
        const std::uint32_t c = face[(k + 2) % 3];
        const Point3 on_edge = 0.5 * (capped_.place_on_it[a] + capped_.place_on_it[b]);
        const std::uint32_t middle = capped_.add_vertex(corner, on_edge, SurfacePart::kRim);
        rim_.push_back(middle);
        capped_.mesh.faces[f] = {a, middle, c};
        capped_.mesh.faces.push_back({middle, b, c});
        capped_.surface_of_face.push_back(capped_.surface_of_face[f]);
    }

    const Box3& box_;
    CapFinder& caps_;
    CappedMesh& capped_;
    std::vector<std::uint32_t> rim_; //!< vertices
};

} // namespace

void add_rim_corners(const Box3& domain, CapFinder& caps, CappedMesh& capped)
{
    RimCorners(domain, caps, capped).add();
}

} // namespace voroprobe
