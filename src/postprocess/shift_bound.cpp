#include "postprocess/shift_bound.h"

#include <algorithm>

#include "geometry/box3.h"

namespace voroprobe
{

namespace
{

Point3 middle_of(const TriangleMesh& mesh, const TriangleMesh::Face& face)
{
    return (mesh.corner(face, 0) + mesh.corner(face, 1) + mesh.corner(face, 2)) / 3.0;
}

} // namespace

ShiftBound::OfPatch ShiftBound::around(const TriangleMesh& patch) const
{
    OfPatch bound;
    bound.distance_to_original_ = &distance_to_original_;
    bound.reach_from_original_ = reach_;
    bound.reach_from_patch_ = reach_;
    const auto widen = [&](const Point3& p)
    { bound.reach_from_patch_ = std::max(bound.reach_from_patch_, distance_to_original_(p)); };
    std::for_each(patch.vertices.begin(), patch.vertices.end(), widen);
    for (const TriangleMesh::Face& face : patch.faces)
        widen(middle_of(patch, face));

    Box3 box = bounding_box(patch);
    box.min = box.min - reach_ * Vec3{1, 1, 1};
    box.max = box.max + reach_ * Vec3{1, 1, 1};
    const MeshDistance distance_to_patch(patch);
    const auto gather = [&](const Point3& p)
    {
        if (box.contains(p) && distance_to_patch(p) <= reach_)
            bound.points_of_original_.push_back(p);
    };
    std::for_each(original_.vertices.begin(), original_.vertices.end(), gather);
    for (const TriangleMesh::Face& face : original_.faces)
        gather(middle_of(original_, face));
    return bound;
}

bool ShiftBound::OfPatch::holds(const TriangleMesh& patch) const
{
    const auto is_near = [this](const Point3& p) { return (*distance_to_original_)(p) <= reach_from_patch_; };
    if (!std::all_of(patch.vertices.begin(), patch.vertices.end(), is_near) ||
        !std::all_of(patch.faces.begin(), patch.faces.end(),
                     [&](const TriangleMesh::Face& face) { return is_near(middle_of(patch, face)); }))
        return false;
    const MeshDistance distance_to_patch(patch);
    return std::all_of(points_of_original_.begin(), points_of_original_.end(),
                       [&](const Point3& p) { return distance_to_patch(p) <= reach_from_original_; });
}

} // namespace voroprobe
