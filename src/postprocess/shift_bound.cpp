#include "postprocess/shift_bound.h"

#include <algorithm>

#include "geometry/box3.h"
#include "geometry/point_triangle.h"

namespace voroprobe
{

namespace
{

//! Points that are remembered: those of the states of one patch.
constexpr std::size_t kMostKnown = 100000;

Point3 middle_of(const TriangleMesh& mesh, const TriangleMesh::Face& face)
{
    return (mesh.corner(face, 0) + mesh.corner(face, 1) + mesh.corner(face, 2)) / 3.0;
}

} // namespace

ShiftBound::OfPatch ShiftBound::around(const TriangleMesh& patch, double share) const
{
    const double reach = share * reach_;
    OfPatch bound;
    bound.distance_to_original_ = &distance_to_original_;
    bound.reach_from_original_ = reach;
    bound.reach_from_patch_ = reach;
    const auto widen = [&](const Point3& p)
    { bound.reach_from_patch_ = std::max(bound.reach_from_patch_, distance_to_original_(p)); };
    std::for_each(patch.vertices.begin(), patch.vertices.end(), widen);
    for (const TriangleMesh::Face& face : patch.faces)
        widen(middle_of(patch, face));

    Box3 box = bounding_box(patch);
    box.min = box.min - reach * Vec3{1, 1, 1};
    box.max = box.max + reach * Vec3{1, 1, 1};
    const MeshDistance distance_to_patch(patch);
    const auto gather = [&](const Point3& p)
    {
        if (box.contains(p) && distance_to_patch(p) <= reach)
            bound.points_of_original_.push_back({p});
    };
    std::for_each(original_.vertices.begin(), original_.vertices.end(), gather);
    for (const TriangleMesh::Face& face : original_.faces)
        gather(middle_of(original_, face));
    return bound;
}

bool ShiftBound::OfPatch::is_near_original(const Point3& p)
{
    if (known_near_.contains({p.x, p.y, p.z}))
        return true;
    if ((*distance_to_original_)(p) > reach_from_patch_)
        return false;
    if (known_near_.size() >= kMostKnown)
        known_near_.clear();
    known_near_.insert({p.x, p.y, p.z});
    return true;
}

//! Looks at the face that was near first.
bool ShiftBound::OfPatch::is_reached(PointToReach& p, const TriangleMesh& patch) const
{
    const double squared_reach = reach_from_original_ * reach_from_original_;
    for (std::size_t i = 0; i < patch.faces.size(); ++i)
    {
        const std::size_t f = (p.near_face + i) % patch.faces.size();
        const TriangleMesh::Face& face = patch.faces[f];
        if (squared_distance_to_triangle(p.point, {patch.corner(face, 0), patch.corner(face, 1),
                                                   patch.corner(face, 2)}) > squared_reach)
            continue;
        p.near_face = f;
        return true;
    }
    return false;
}

bool ShiftBound::OfPatch::holds(const TriangleMesh& patch)
{
    return std::all_of(patch.vertices.begin(), patch.vertices.end(),
                       [this](const Point3& p) { return is_near_original(p); }) &&
           std::all_of(patch.faces.begin(), patch.faces.end(),
                       [&](const TriangleMesh::Face& face)
                       { return is_near_original(middle_of(patch, face)); }) &&
           std::all_of(points_of_original_.begin(), points_of_original_.end(),
                       [&](PointToReach& p) { return is_reached(p, patch); });
}

} // namespace voroprobe
