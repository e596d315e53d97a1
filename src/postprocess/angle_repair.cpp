#include "postprocess/angle_repair.h"

#include <algorithm>
#include <utility>

#include "postprocess/face_shape.h"

namespace voroprobe
{

namespace
{

using Face = TriangleMesh::Face;

//! A repair has to gain as much, squared degrees: rounding is no gain.
constexpr double kLeastGain = 0.01;

//! Rounds of moving the vertices of a patch.
constexpr int kRoundsInPlane = 2;
constexpr int kRoundsOnSurface = 1;

//! First changes that a second one is tried after.
constexpr std::size_t kMostFirstChanges = 6;

//! Faces a round tries two steps on, at about 0.2 s each. Where there are more it is the surface or the
//! bound.
constexpr std::size_t kMostTwoSteps = 200;

//! Trials that are put to the guard, the best first.
constexpr std::size_t kMostQuestions = 24;

//! A surface that leans from a face by more than 75 degrees turns within it.
constexpr double kCosCrease = 0.26;

void add_if_new(std::vector<std::uint32_t>& list, std::uint32_t value)
{
    if (std::find(list.begin(), list.end(), value) == list.end())
        list.push_back(value);
}

//! The face's corners and those across its edges.
std::vector<std::uint32_t> surroundings(const EditableMesh& mesh, std::uint32_t f)
{
    const Face& face = mesh.face(f);
    std::vector<std::uint32_t> vertices(face.begin(), face.end());
    for (std::size_t i = 0; i < 3; ++i)
    {
        const std::uint32_t a = face[i];
        const std::uint32_t b = face[(i + 1) % 3];
        add_if_new(vertices, opposite_corner(mesh.face(mesh.face_along(b, a)), a, b));
    }
    return vertices;
}

//! The face's corners and all their neighbours.
std::vector<std::uint32_t> wide_surroundings(const EditableMesh& mesh, std::uint32_t f)
{
    const Face& face = mesh.face(f);
    std::vector<std::uint32_t> vertices(face.begin(), face.end());
    for (const std::uint32_t corner : face)
        for (const std::uint32_t v : mesh.neighbours(corner))
            add_if_new(vertices, v);
    return vertices;
}

} // namespace

AngleRepair::AngleRepair(EditableMesh& mesh, const BoundingSurface& surface, PatchGuard& guard,
                         double goal_angle_deg)
    : mesh_(mesh), surface_(surface), guard_(guard), goal_angle_deg_(goal_angle_deg)
{
}

double AngleRepair::angle_of(std::uint32_t f) const
{
    const Face& face = mesh_.face(f);
    return smallest_angle_deg(mesh_.point(face[0]), mesh_.point(face[1]), mesh_.point(face[2]));
}

ShortFaces AngleRepair::short_faces(double angle_deg) const
{
    ShortFaces count;
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f)
    {
        if (!mesh_.is_alive(f) || !(angle_of(f) < angle_deg))
            continue;
        const PatchFit fit = guard_.fit(FacePatch(mesh_, wide_surroundings(mesh_, f)));
        if (fit.beyond > 0)
            ++count.beyond_bound;
        else if (fit.tilt < kCosCrease)
            ++count.at_creases;
        else
            ++count.elsewhere;
    }
    return count;
}

void AngleRepair::run(int rounds, RepairEffort effort)
{
    for (int round = 0; round < rounds; ++round)
        if (!run_once(effort))
            break;
}

//! Whether anything was gained.
bool AngleRepair::run_once(RepairEffort effort)
{
    bool gained = false;
    const auto count = static_cast<std::uint32_t>(mesh_.face_count());
    std::size_t tries = effort == RepairEffort::kTwoSteps ? kMostTwoSteps : count;
    for (std::uint32_t f = 0; f < count && tries > 0; ++f)
        if (mesh_.is_alive(f) && angle_of(f) < goal_angle_deg_)
        {
            --tries;
            gained = repair(f, effort) || gained;
        }
    return gained;
}

bool AngleRepair::repair(std::uint32_t f, RepairEffort effort)
{
    const bool is_wide = effort == RepairEffort::kTwoSteps;
    const FacePatch before(mesh_, is_wide ? wide_surroundings(mesh_, f) : surroundings(mesh_, f));
    const Trial start{before, before.shortfall(goal_angle_deg_), {}};
    std::vector<Trial> found = trials(start, is_wide ? changes_in(before) : changes_of(f), effort);
    if (is_wide)
    {
        const std::size_t first_changes = std::min(found.size(), kMostFirstChanges);
        for (std::size_t i = 0; i < first_changes; ++i)
        {
            const Trial first = found[i];
            for (Trial& second : trials(first, changes_in(first.patch), effort))
                found.push_back(std::move(second));
        }
    }
    return accept_best(std::move(found), before);
}

std::vector<AngleRepair::Change> AngleRepair::changes_of(std::uint32_t f) const
{
    std::vector<Change> changes{{Change::Kind::kNone, 0, 0}};
    const Face& face = mesh_.face(f);
    for (std::size_t i = 0; i < 3; ++i)
        for (const auto kind : {Change::Kind::kFlip, Change::Kind::kCollapse, Change::Kind::kSplit})
            changes.push_back({kind, face[i], face[(i + 1) % 3]});
    return changes;
}

std::vector<AngleRepair::Change> AngleRepair::changes_in(const FacePatch& patch)
{
    std::vector<Change> changes{{Change::Kind::kNone, 0, 0}};
    for (const auto& [a, b] : patch.inner_edges())
        for (const auto kind : {Change::Kind::kFlip, Change::Kind::kCollapse, Change::Kind::kSplit})
            changes.push_back({kind, a, b});
    return changes;
}

//! Patches after one change each and the best moves after it, those with the smallest shortfall first.
std::vector<AngleRepair::Trial> AngleRepair::trials(const Trial& from, const std::vector<Change>& changes,
                                                    RepairEffort effort) const
{
    std::vector<Trial> result;
    for (const Change& change : changes)
    {
        Trial trial = from;
        bool is_possible = true;
        switch (change.kind)
        {
        case Change::Kind::kNone:
            break;
        case Change::Kind::kFlip:
            is_possible = trial.patch.flip(change.a, change.b);
            ++trial.changes.flips;
            break;
        case Change::Kind::kCollapse:
            is_possible = trial.patch.collapse(change.a, change.b);
            ++trial.changes.collapses;
            break;
        case Change::Kind::kSplit:
            is_possible = trial.patch.split(change.a, change.b);
            ++trial.changes.splits;
            break;
        }
        if (!is_possible)
            continue;
        if (effort == RepairEffort::kSurface)
            trial.patch.improve_positions(kRoundsOnSurface, &surface_);
        else
            trial.patch.improve_positions(kRoundsInPlane);
        trial.shortfall = trial.patch.shortfall(goal_angle_deg_);
        result.push_back(std::move(trial));
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const Trial& a, const Trial& b) { return a.shortfall < b.shortfall; });
    return result;
}

//! Back onto the surface; false where that is not near.
bool AngleRepair::project(FacePatch& patch) const
{
    for (const std::uint32_t v : patch.inner())
        if (patch.has_moved(v))
        {
            const auto target = surface_.projection(patch.point(v));
            if (!target)
                return false;
            patch.move(v, target->point);
        }
    return true;
}

bool AngleRepair::accept_best(std::vector<Trial> found, const FacePatch& before)
{
    const double to_beat = before.shortfall(goal_angle_deg_) - kLeastGain;
    std::erase_if(found, [&](Trial& trial) { return trial.shortfall > to_beat || !project(trial.patch); });
    for (Trial& trial : found)
        trial.shortfall = trial.patch.shortfall(goal_angle_deg_);
    const double smallest_before = before.smallest_angle_deg();
    std::erase_if(found,
                  [&](const Trial& trial) {
                      return trial.shortfall > to_beat || trial.patch.smallest_angle_deg() < smallest_before;
                  });
    std::stable_sort(found.begin(), found.end(),
                     [](const Trial& a, const Trial& b) { return a.shortfall < b.shortfall; });
    found.erase(found.begin() + static_cast<std::ptrdiff_t>(std::min(found.size(), kMostQuestions)),
                found.end());
    if (found.empty())
        return false;
    const PatchFit fit_before = guard_.fit(before);
    const auto best =
        std::find_if(found.begin(), found.end(),
                     [&](const Trial& trial) { return guard_.is_sound(trial.patch, fit_before); });
    if (best == found.end())
        return false;
    best->patch.commit(mesh_);
    guard_.update();
    counts_.flips += best->changes.flips;
    counts_.collapses += best->changes.collapses;
    counts_.splits += best->changes.splits;
    return true;
}

} // namespace voroprobe
