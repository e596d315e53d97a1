#include "postprocess/relaxation.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "certificate/mesh_samples.h"
#include "certificate/self_intersections.h"
#include "postprocess/angle_repair.h"
#include "postprocess/editable_mesh.h"
#include "postprocess/patch_guard.h"
#include "postprocess/relaxation_sweeps.h"
#include "postprocess/shift_bound.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

using Face = TriangleMesh::Face;

//! Rounds of repair, by effort; each deals with all faces below the goal.
constexpr int kRoundsInPlane = 8;
constexpr int kRoundsOnSurface = 6;

//! Times that the sweeps are begun anew with more vertices held.
constexpr int kMostAttempts = 8;

//! What surrounds a crossing is held as well, to so many edges from it.
constexpr int kHeldRings = 2;

//! Of what is annealed, in largest distances from the surface.
constexpr double kLargestShift = 4.0;

//! Cells of the grid that finds faces near a patch, in typical edges.
constexpr double kEdgesPerCell = 1.5;

void check_options(const BoundingSurface& surface, const RelaxationOptions& options)
{
    if (!(surface.max_distance > 0.0) || !std::isfinite(surface.max_distance))
        throw UsageError("relaxation: the largest distance is " + std::to_string(surface.max_distance) +
                         "; allowed: a number > 0");
    if (!(options.target_angle_deg >= 0.0 && options.target_angle_deg <= 40.0))
        throw UsageError("relaxation: the angle aimed at is " + std::to_string(options.target_angle_deg) +
                         " degrees; allowed: 0 to 40");
}

//! Holds what lies near faces that cross: their corners, and what is next to those in the mesh that
//! relaxation began with. \return how many vertices were not marked before.
std::size_t mark_around(const std::vector<FacePair>& pairs, const TriangleMesh& relaxed,
                        const TriangleMesh& original, std::vector<bool>& held)
{
    const auto before = std::count(held.begin(), held.end(), true);
    std::vector<Point3> crossing;
    double reach = 0.0;
    for (const auto& [f, g] : pairs)
        for (const std::uint32_t face : {f, g})
            for (std::size_t i = 0; i < 3; ++i)
            {
                crossing.push_back(relaxed.corner(relaxed.faces[face], i));
                reach = std::max(reach,
                                 distance(crossing.back(), relaxed.corner(relaxed.faces[face], (i + 1) % 3)));
            }
    std::vector<bool> near(original.vertices.size(), false);
    for (std::size_t v = 0; v < original.vertices.size(); ++v)
        near[v] = std::any_of(crossing.begin(), crossing.end(),
                              [&](const Point3& p) { return distance(p, original.vertices[v]) <= reach; });
    for (int ring = 0; ring < kHeldRings; ++ring)
    {
        std::vector<bool> grown = near;
        for (const Face& face : original.faces)
            if (near[face[0]] || near[face[1]] || near[face[2]])
                for (const std::uint32_t v : face)
                    grown[v] = true;
        near = std::move(grown);
    }
    for (std::size_t v = 0; v < held.size(); ++v)
        held[v] = held[v] || near[v];
    return static_cast<std::size_t>(std::count(held.begin(), held.end(), true) - before);
}

//! The mesh after the sweeps, which are begun anew with what lies around held wherever faces came to cross.
EditableMesh swept(const TriangleMesh& mesh, const BoundingSurface& surface, int sweeps,
                   RelaxationResult& result)
{
    std::vector<bool> held(mesh.vertices.size(), false);
    const std::size_t crossings_before = self_intersections(mesh).size();
    for (int attempt = 1;; ++attempt)
    {
        EditableMesh editable(mesh);
        RelaxationSweeps relaxation(editable, surface, held);
        relaxation.run(sweeps);
        const TriangleMesh after = editable.mesh();
        const std::vector<FacePair> crossings = self_intersections(after);
        if (crossings.size() <= crossings_before || attempt == kMostAttempts ||
            mark_around(crossings, after, mesh, held) == 0)
        {
            result.vertices_held = static_cast<std::size_t>(std::count(held.begin(), held.end(), true));
            result.edges_flipped = relaxation.edges_flipped();
            return editable;
        }
    }
}

//! Vertices of the original that are elsewhere now.
std::size_t count_moved(const TriangleMesh& before, const EditableMesh& after)
{
    std::size_t count = 0;
    for (std::uint32_t v = 0; v < before.vertices.size(); ++v)
        count += !after.faces_of(v).empty() && !(after.point(v) == before.vertices[v]) ? 1 : 0;
    return count;
}

} // namespace

RelaxationResult relax(const TriangleMesh& mesh, const BoundingSurface& surface,
                       const RelaxationOptions& options)
{
    check_options(surface, options);
    RelaxationResult result;
    EditableMesh editable = swept(mesh, surface, options.sweeps, result);
    PatchGuard guard(editable, surface, kEdgesPerCell * typical_edge_length(mesh));
    AngleRepair repair(editable, surface, guard, options.target_angle_deg, count_beyond(mesh, surface));
    repair.run(kRoundsInPlane, RepairEffort::kPlane);
    repair.run(kRoundsOnSurface, RepairEffort::kSurface);
    repair.anneal_short_faces(
        ShiftBound(mesh, std::min(kLargestShift * surface.max_distance, options.max_shift)));
    result.mesh = editable.mesh();
    result.vertices_moved = count_moved(mesh, editable);
    result.edges_flipped += repair.counts().flips;
    result.edges_collapsed = repair.counts().collapses;
    result.edges_split = repair.counts().splits;
    result.short_faces = repair.short_faces();
    result.self_intersections = self_intersections(result.mesh).size();
    return result;
}

} // namespace voroprobe
