#include "certificate/self_intersections.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>
#include <tbb/concurrent_vector.h>
#include <tbb/parallel_for.h>

#include "certificate/flat_stars.h"

namespace voroprobe
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Segment = Kernel::Segment_3;
using Face = TriangleMesh::Face;

//! Decides about pairs of faces. May be asked from several threads at once.
class FacePairs
{
public:
    explicit FacePairs(const TriangleMesh& mesh)
    {
        points_.reserve(mesh.vertices.size());
        for (const Point3& p : mesh.vertices)
            points_.emplace_back(p.x, p.y, p.z);
    }

    [[nodiscard]] bool has_area(const Face& face) const
    {
        return !CGAL::collinear(points_[face[0]], points_[face[1]], points_[face[2]]);
    }

    //! \pre both have area.
    [[nodiscard]] bool meet_elsewhere(Face a, Face b) const
    {
        switch (shared_corners_first(a, b))
        {
        case 0:
            return meet_apart(a, b);
        case 1:
            return meet_beyond_corner(a, b);
        case 2:
            return is_folded(a, b);
        default:
            return true; // one upon the other
        }
    }

private:
    //! Turns the faces so that shared corners come first and in the same order; returns their number.
    static std::size_t shared_corners_first(Face& a, Face& b)
    {
        std::size_t shared = 0;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = shared; j < 3; ++j)
                if (a[i] == b[j])
                {
                    std::swap(a[i], a[shared]);
                    std::swap(b[j], b[shared]);
                    ++shared;
                    break;
                }
        return shared;
    }

    [[nodiscard]] Triangle triangle(const Face& face) const
    {
        return {points_[face[0]], points_[face[1]], points_[face[2]]};
    }

    //! On which side of the plane of `face` a point lies.
    [[nodiscard]] CGAL::Orientation side(const Face& face, std::uint32_t vertex) const
    {
        return CGAL::orientation(points_[face[0]], points_[face[1]], points_[face[2]], points_[vertex]);
    }

    //! Of faces without a common corner. Faces of one plane, as those of caps are, would cost CGAL's general
    //! answer its exact arithmetic.
    [[nodiscard]] bool meet_apart(const Face& a, const Face& b) const
    {
        const auto sides = [&](const Face& plane, const Face& face) {
            return std::array{side(plane, face[0]), side(plane, face[1]), side(plane, face[2])};
        };
        const auto of_b = sides(a, b);
        const bool to_one_side = of_b[0] == of_b[1] && of_b[1] == of_b[2];
        if (to_one_side)
            return of_b[0] == CGAL::COPLANAR && overlap_in_plane(a, b);
        const auto of_a = sides(b, a);
        if (of_a[0] == of_a[1] && of_a[1] == of_a[2])
            return false;
        return CGAL::do_intersect(triangle(a), triangle(b));
    }

    [[nodiscard]] CGAL::Orientation turn(std::uint32_t p, std::uint32_t q, std::uint32_t r) const
    {
        return CGAL::coplanar_orientation(points_[p], points_[q], points_[r]);
    }

    //! Of faces of one plane: convex, they are apart where the other lies beyond a side of one.
    [[nodiscard]] bool overlap_in_plane(const Face& a, const Face& b) const
    {
        return !has_separating_side(a, b) && !has_separating_side(b, a);
    }

    [[nodiscard]] bool has_separating_side(const Face& face, const Face& other) const
    {
        const CGAL::Orientation beyond = -turn(face[0], face[1], face[2]);
        for (std::size_t i = 0; i < 3; ++i)
            if (std::all_of(other.begin(), other.end(),
                            [&](std::uint32_t vertex)
                            { return turn(face[i], face[(i + 1) % 3], vertex) == beyond; }))
                return true;
        return false;
    }

    //! Of faces that share corner 0. What they have in common is convex and holds that corner: if it is more,
    //! it is a segment from there on, or a sector.
    [[nodiscard]] bool meet_beyond_corner(const Face& a, const Face& b) const
    {
        const CGAL::Orientation first = side(a, b[1]);
        const CGAL::Orientation second = side(a, b[2]);
        if (first == CGAL::COPLANAR && second == CGAL::COPLANAR)
            return is_in_sector(a, b[1]) || is_in_sector(a, b[2]) || is_in_sector(b, a[1]) ||
                   is_in_sector(b, a[2]);
        if (first == CGAL::COPLANAR || second == CGAL::COPLANAR)
            return is_in_sector(a, first == CGAL::COPLANAR ? b[1] : b[2]);
        if (first == second || side(b, a[1]) == side(b, a[2]))
            return false;
        return CGAL::do_intersect(Segment(points_[a[1]], points_[a[2]]), triangle(b)) ||
               CGAL::do_intersect(Segment(points_[b[1]], points_[b[2]]), triangle(a));
    }

    //! Whether a point of the plane of `face` lies between its sides from corner 0, prolonged, or on them.
    [[nodiscard]] bool is_in_sector(const Face& face, std::uint32_t vertex) const
    {
        const CGAL::Orientation beyond = -turn(face[0], face[1], face[2]);
        return turn(face[0], face[1], vertex) != beyond && turn(face[0], vertex, face[2]) != beyond;
    }

    //! Faces that share the edge of corners 0 and 1 meet elsewhere only where one is folded onto the other.
    [[nodiscard]] bool is_folded(const Face& a, const Face& b) const
    {
        const Point& p = points_[a[0]];
        const Point& q = points_[a[1]];
        const Point& r = points_[a[2]];
        const Point& s = points_[b[2]];
        return CGAL::coplanar(p, q, r, s) && CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
    }

    std::vector<Point> points_;
};

//! Shared corners, at any place of the faces.
template <typename Test>
bool any_shared_corner(const Face& a, const Face& b, const Test& test)
{
    return std::any_of(a.begin(), a.end(),
                       [&](std::uint32_t v) { return (v == b[0] || v == b[1] || v == b[2]) && test(v); });
}

} // namespace

std::vector<FacePair> self_intersections(const TriangleMesh& mesh)
{
    return self_intersections(FaceTree(mesh));
}

std::vector<FacePair> self_intersections(const FaceTree& tree)
{
    const TriangleMesh& mesh = tree.mesh();
    const FacePairs pairs(mesh);
    const std::vector<std::uint8_t> flat = find_flat_stars(mesh);
    const auto is_flat = [&](std::uint32_t vertex) { return flat[vertex] != 0; };
    tbb::concurrent_vector<FacePair> found;
    std::vector<std::uint8_t> has_area(mesh.faces.size());
    const auto judge_face = [&](std::uint32_t f)
    {
        const Face& face = mesh.faces[f];
        has_area[f] = std::any_of(face.begin(), face.end(), is_flat) || pairs.has_area(face);
        if (has_area[f] == 0)
            found.emplace_back(f, f);
    };
    const auto judge_pair = [&](std::uint32_t f, std::uint32_t g)
    {
        const Face& a = mesh.faces[f];
        const Face& b = mesh.faces[g];
        if (any_shared_corner(a, b, is_flat) || has_area[f] == 0 || has_area[g] == 0)
            return;
        if (pairs.meet_elsewhere(a, b))
            found.push_back(std::minmax(f, g));
    };
    tbb::parallel_for(std::uint32_t{0}, static_cast<std::uint32_t>(mesh.faces.size()), judge_face);
    tbb::parallel_for(std::size_t{0}, tree.block_count(),
                      [&](std::size_t block) { tree.for_each_meeting_pair(block, judge_pair); });
    std::vector<FacePair> sorted(found.begin(), found.end());
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

std::size_t take_flat_faces(std::vector<FacePair>& pairs)
{
    return std::erase_if(pairs, [](const FacePair& pair) { return pair.first == pair.second; });
}

bool first_faces_intersect(const TriangleMesh& mesh, std::size_t count)
{
    const FacePairs pairs(mesh);
    std::vector<Box3> boxes(mesh.faces.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        for (std::size_t i = 0; i < 3; ++i)
            boxes[f].include(mesh.corner(mesh.faces[f], i));
    const auto meet = [&](std::size_t f, std::size_t g)
    {
        return !intersection(boxes[f], boxes[g]).empty() && pairs.has_area(mesh.faces[g]) &&
               pairs.meet_elsewhere(mesh.faces[f], mesh.faces[g]);
    };
    for (std::size_t f = 0; f < count; ++f)
    {
        if (!pairs.has_area(mesh.faces[f]))
            return true;
        for (std::size_t g = f + 1; g < mesh.faces.size(); ++g)
            if (meet(f, g))
                return true;
    }
    return false;
}

} // namespace voroprobe
