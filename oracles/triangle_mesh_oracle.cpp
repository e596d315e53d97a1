#include "oracles/triangle_mesh_oracle.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

#include "oracles/closed_mesh_checks.h"
#include "oracles/segment_face_predicates.h"

namespace voroprobe
{
namespace
{

using Point = MeshKernel::Point_3;
using Segment = MeshKernel::Segment_3;
using Triangles = std::vector<MeshKernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<MeshKernel, Triangles::const_iterator>;
using Traits = CGAL::AABB_traits<MeshKernel, Primitive>;
using Tree = CGAL::AABB_tree<Traits>;

//! The domain is larger than the mesh by this fraction of its diagonal: its border is outside.
constexpr double kMargin = 0.01;

//! By how much may_cross() grows its box, as a fraction of the diagonal: covers the rounding of crossings.
constexpr double kBoxRounding = 1e-12;

Point point(const Point3& p)
{
    return {p.x, p.y, p.z};
}

//! Visits the faces that a segment crosses.
template <class Visit>
class CrossedFaces
{
public:
    CrossedFaces(const Traits& traits, Visit visit) : traits_(traits), visit_(visit) {}

    // What the tree asks of a traversal.
    [[nodiscard]] static constexpr bool go_further() { return true; }
    void intersection(const Segment& segment, const Primitive& primitive)
    {
        const MeshKernel::Triangle_3& face = primitive.datum();
        if (crosses(segment.source(), segment.target(), face))
            visit_(face);
    }
    [[nodiscard]] bool do_intersect(const Segment& segment, const CGAL::AABB_node<Traits>& node) const
    {
        return traits_.do_intersect_object()(segment, node.bbox());
    }

private:
    const Traits& traits_;
    Visit visit_;
};

//! Two crossings at one place are the surface touched, not crossed: they go in pairs.
void sort_and_cancel_touches(std::vector<Crossing>& crossings)
{
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
    std::size_t kept = 0;
    for (const Crossing& crossing : crossings)
        if (kept > 0 && crossings[kept - 1].t == crossing.t)
            --kept;
        else
            crossings[kept++] = crossing;
    crossings.resize(kept);
}

class TriangleMeshOracle final : public SurfaceOracle
{
public:
    explicit TriangleMeshOracle(const TriangleMesh& mesh)
    {
        triangles_.reserve(mesh.faces.size());
        for (const TriangleMesh::Face& face : mesh.faces)
        {
            triangles_.emplace_back(point(mesh.corner(face, 0)), point(mesh.corner(face, 1)),
                                    point(mesh.corner(face, 2)));
            for (std::size_t i = 0; i < 3; ++i)
                domain_.include(mesh.corner(face, i));
        }
        rounding_ = kBoxRounding * domain_.diagonal();
        domain_ = domain_.expanded(kMargin * domain_.diagonal());
        tree_.insert(triangles_.begin(), triangles_.end());
        tree_.build(); // now, not with the first query, which may come from several threads
    }

    [[nodiscard]] Box3 domain() const override { return domain_; }

    //! Any way out crosses the surface as often, modulo two.
    [[nodiscard]] Region region(const Point3& p) const override
    {
        if (!is_finite(p) || !domain_.contains(p))
            return kOuterRegion;
        const Point3 out = way_out(p);
        if (out == p)
            return kOuterRegion;
        bool inside = false;
        visit_crossed({p, out}, [&](const auto& /*face*/) { inside = !inside; });
        return inside ? Region{1} : kOuterRegion;
    }

    void find_crossings(const Segment3& segment, std::vector<Crossing>& crossings) const override
    {
        crossings.clear();
        if (segment.source == segment.target || !is_finite(segment.source) || !is_finite(segment.target))
            return;
        const Point source = point(segment.source);
        const Point target = point(segment.target);
        visit_crossed(segment,
                      [&](const auto& face)
                      {
                          const double t = crossing_parameter(source, target, face);
                          crossings.push_back({t, segment.at(t)});
                      });
        sort_and_cancel_touches(crossings);
    }

    [[nodiscard]] bool may_cross(const Box3& box) const override
    {
        if (box.empty())
            return false;
        const Box3 grown = box.expanded(rounding_);
        return tree_.do_intersect(
            CGAL::Bbox_3(grown.min.x, grown.min.y, grown.min.z, grown.max.x, grown.max.y, grown.max.z));
    }

private:
    template <class Visit>
    void visit_crossed(const Segment3& segment, Visit visit) const
    {
        CrossedFaces<Visit> traversal(tree_.traits(), visit);
        tree_.traversal(Segment(point(segment.source), point(segment.target)), traversal);
    }

    //! The nearest point of the domain's border, along an axis.
    [[nodiscard]] Point3 way_out(const Point3& p) const
    {
        Point3 nearest = p;
        double shortest = std::numeric_limits<double>::infinity();
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const double border : {domain_.min[axis], domain_.max[axis]})
                if (const double length = std::abs(border - p[axis]); length < shortest)
                {
                    shortest = length;
                    nearest = p;
                    nearest[axis] = border;
                }
        return nearest;
    }

    Triangles triangles_;
    Tree tree_;
    Box3 domain_;
    double rounding_ = 0.0; //!< scan units
};

} // namespace

std::unique_ptr<SurfaceOracle> make_triangle_mesh_oracle(const TriangleMesh& mesh, const std::string& name,
                                                         MeshChecks checks)
{
    require_closed(mesh, name);
    if (checks == MeshChecks::kClosedAndFreeOfCrossings)
        require_no_crossing_faces(mesh, name);
    return std::make_unique<TriangleMeshOracle>(mesh);
}

} // namespace voroprobe
