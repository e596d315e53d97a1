#include "postprocess/patch_guard.h"

#include <algorithm>
#include <limits>
#include <map>
#include <vector>

#include "certificate/self_intersections.h"
#include "postprocess/face_shape.h"

namespace voroprobe
{

namespace
{

using Face = TriangleMesh::Face;

//! Faces stay within 75 degrees of the surface's own direction.
constexpr double kCosLargestTilt = 0.26;

//! The same at creases.
constexpr double kCosLargestTiltAtCreases = -0.2;

//! Faces that are remembered: those of the patches of one place.
constexpr std::size_t kMostKnown = 100000;

//! A few faces with vertices of their own.
struct LocalMesh
{
    TriangleMesh mesh;
    std::map<std::uint32_t, std::uint32_t> index;

    void add(const Face& face, const FacePatch& patch)
    {
        Face renamed = face;
        for (std::uint32_t& v : renamed)
        {
            const auto [entry, is_new] =
                index.try_emplace(v, static_cast<std::uint32_t>(mesh.vertices.size()));
            if (is_new)
                mesh.vertices.push_back(patch.point(v));
            v = entry->second;
        }
        mesh.faces.push_back(renamed);
    }
};

//! Does another state of the patch have the same face at the same place?
bool is_in(const Face& face, const FacePatch& patch, const FacePatch& other)
{
    return std::find(other.faces().begin(), other.faces().end(), face) != other.faces().end() &&
           std::all_of(face.begin(), face.end(),
                       [&](std::uint32_t v) { return patch.point(v) == other.point(v); });
}

} // namespace

const PatchGuard::FaceFit& PatchGuard::fit_of(const Point3& a, const Point3& b, const Point3& c)
{
    if (known_.size() > kMostKnown)
        known_.clear();
    const auto [entry, is_new] = known_.try_emplace({a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z});
    FaceFit& fit = entry->second;
    if (!is_new)
        return fit;
    const Point3 middle = (a + b + c) / 3.0;
    const auto near = surface_.projection(middle);
    fit.face_distance = surface_.distance(a, b, c);
    fit.middle_distance = near ? distance(middle, near->point) : std::numeric_limits<double>::infinity();
    fit.tilt = near ? dot(unit_normal(a, b, c), near->normal) : -1.0;
    return fit;
}

bool PatchGuard::is_beyond(const FacePatch& patch, std::uint32_t vertex)
{
    const auto& faces = patch.faces();
    return std::any_of(
        faces.begin(), faces.end(),
        [&](const Face& face)
        {
            return std::find(face.begin(), face.end(), vertex) != face.end() &&
                   fit_of(patch.point(face[0]), patch.point(face[1]), patch.point(face[2])).face_distance >
                       surface_.max_distance;
        });
}

PatchFit PatchGuard::fit(const FacePatch& patch)
{
    PatchFit fit;
    for (const Face& face : patch.faces())
    {
        const FaceFit& of_face = fit_of(patch.point(face[0]), patch.point(face[1]), patch.point(face[2]));
        fit.beyond += of_face.face_distance > surface_.max_distance ? 1 : 0;
        fit.face_distance = std::max(fit.face_distance, of_face.face_distance);
        fit.middle_distance = std::max(fit.middle_distance, of_face.middle_distance);
        fit.tilt = std::min(fit.tilt, of_face.tilt);
    }
    return fit;
}

bool PatchGuard::keeps_to_surface(const PatchFit& after, const PatchFit& before) const
{
    return after.beyond <= before.beyond &&
           after.face_distance <= std::max(surface_.max_distance, before.face_distance) &&
           after.middle_distance <= std::max(surface_.max_distance, before.middle_distance) &&
           (after.tilt >= kCosLargestTilt || after.tilt >= std::min(kCosLargestTiltAtCreases, before.tilt));
}

bool PatchGuard::is_sound(const FacePatch& after, const FacePatch& previous, const PatchFit& before)
{
    return keeps_to_surface(fit(after), before) && crosses_nothing(after, previous);
}

//! Asks for the new faces alone, which come first.
bool PatchGuard::crosses_nothing(const FacePatch& after, const FacePatch& previous) const
{
    std::vector<Face> kept;
    LocalMesh local;
    Box3 box;
    for (const Face& face : after.faces())
        if (is_in(face, after, previous))
            kept.push_back(face);
        else
        {
            local.add(face, after);
            for (const std::uint32_t v : face)
                box.include(after.point(v));
        }
    const std::size_t new_faces = local.mesh.faces.size();
    for (const Face& face : kept)
        local.add(face, after);
    for (const std::uint32_t f : grid_.faces_near(box))
        if (!after.replaces(f))
            local.add(mesh_.face(f), after);
    return !first_faces_intersect(local.mesh, new_faces);
}

} // namespace voroprobe
