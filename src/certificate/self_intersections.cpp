#include "certificate/self_intersections.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>
#include <tbb/concurrent_vector.h>

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
            return CGAL::do_intersect(triangle(a), triangle(b));
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

    //! Of faces that share corner 0. What they have in common is convex and holds that corner: if it is more,
    //! it reaches the side opposite the corner in one of them.
    [[nodiscard]] bool meet_beyond_corner(const Face& a, const Face& b) const
    {
        if (lies_strictly_to_one_side(a, b) || lies_strictly_to_one_side(b, a))
            return false;
        return CGAL::do_intersect(Segment(points_[a[1]], points_[a[2]]), triangle(b)) ||
               CGAL::do_intersect(Segment(points_[b[1]], points_[b[2]]), triangle(a));
    }

    //! Whether face b, but for corner 0 that it shares with a, lies to one side of the plane of a: the usual
    //! case, quickly told.
    [[nodiscard]] bool lies_strictly_to_one_side(const Face& a, const Face& b) const
    {
        const Point& p = points_[a[0]];
        const Point& q = points_[a[1]];
        const Point& r = points_[a[2]];
        const CGAL::Orientation side = CGAL::orientation(p, q, r, points_[b[1]]);
        return side != CGAL::COPLANAR && side == CGAL::orientation(p, q, r, points_[b[2]]);
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
    CGAL::box_self_intersection_d<CGAL::Parallel_tag>(
        boxes.begin(), boxes.end(),
        [&](const FaceBox& a, const FaceBox& b)
        {
            if (pairs.meet_elsewhere(mesh.faces[a.info()], mesh.faces[b.info()]))
                found.push_back(std::minmax(a.info(), b.info()));
        });
    std::vector<FacePair> sorted(found.begin(), found.end());
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

} // namespace voroprobe
