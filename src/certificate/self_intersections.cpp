#include "certificate/self_intersections.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>
#include <tbb/concurrent_vector.h>
#include <tbb/parallel_for.h>

namespace voroprobe
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Segment = Kernel::Segment_3;
using FaceBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;
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

    [[nodiscard]] CGAL::Bbox_3 box(const Face& face) const { return triangle(face).bbox(); }

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

//! Boxes are searched for overlaps in so many strips across the mesh, in parallel.
constexpr std::size_t kStrips = 32;

//! The places across which the mesh is cut, ascending: about as many boxes begin in each strip.
std::vector<double> cuts_between_strips(const std::vector<FaceBox>& boxes, int axis)
{
    std::vector<double> begins;
    begins.reserve(boxes.size());
    for (const FaceBox& box : boxes)
        begins.push_back(box.min_coord(axis));
    std::sort(begins.begin(), begins.end());
    std::vector<double> cuts;
    for (std::size_t i = 1; i < kStrips && !begins.empty(); ++i)
        cuts.push_back(begins[i * begins.size() / kStrips]);
    return cuts;
}

//! The strip that a coordinate lies in.
std::size_t strip_of(const std::vector<double>& cuts, double x)
{
    return static_cast<std::size_t>(std::upper_bound(cuts.begin(), cuts.end(), x) - cuts.begin());
}

int longest_axis(const TriangleMesh& mesh)
{
    const Vec3 extent = bounding_box(mesh).extent();
    if (extent.x >= extent.y && extent.x >= extent.z)
        return 0;
    return extent.y >= extent.z ? 1 : 2;
}

//! Calls `visit(f, g)` for every pair of faces whose boxes meet, from several threads at once.
template <typename Visitor>
void for_each_meeting_pair(const std::vector<FaceBox>& boxes, int axis, const Visitor& visit)
{
    const std::vector<double> cuts = cuts_between_strips(boxes, axis);
    std::vector<std::vector<FaceBox>> strips(cuts.size() + 1);
    for (const FaceBox& box : boxes)
    {
        const std::size_t last = strip_of(cuts, box.max_coord(axis));
        for (std::size_t strip = strip_of(cuts, box.min_coord(axis)); strip <= last; ++strip)
            strips[strip].push_back(box);
    }
    tbb::parallel_for(std::size_t{0}, strips.size(),
                      [&](std::size_t strip)
                      {
                          CGAL::box_self_intersection_d(
                              strips[strip].begin(), strips[strip].end(),
                              [&](const FaceBox& a, const FaceBox& b)
                              {
                                  // Pairs that share several strips are met in each: the first one counts.
                                  if (strip_of(cuts, std::max(a.min_coord(axis), b.min_coord(axis))) == strip)
                                      visit(a.info(), b.info());
                              });
                      });
}

} // namespace

std::vector<FacePair> self_intersections(const TriangleMesh& mesh)
{
    const FacePairs pairs(mesh);
    tbb::concurrent_vector<FacePair> found;
    std::vector<FaceBox> boxes;
    boxes.reserve(mesh.faces.size());
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    {
        if (pairs.has_area(mesh.faces[f]))
            boxes.emplace_back(pairs.box(mesh.faces[f]), f);
        else
            found.emplace_back(f, f);
    }
    for_each_meeting_pair(boxes, longest_axis(mesh),
                          [&](std::uint32_t f, std::uint32_t g)
                          {
                              if (pairs.meet_elsewhere(mesh.faces[f], mesh.faces[g]))
                                  found.push_back(std::minmax(f, g));
                          });
    std::vector<FacePair> sorted(found.begin(), found.end());
    std::sort(sorted.begin(), sorted.end());
    return sorted;
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
