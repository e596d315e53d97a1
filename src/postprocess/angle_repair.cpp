#include "postprocess/angle_repair.h"

#include <algorithm>
#include <array>
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

//! Work aims at so much more than the target, degrees, lest faces fall below by the next.
constexpr double kMarginDeg = 1.0;

//! The same for annealing, which is the last: what rounding to 32 bits may cost small faces.
constexpr double kAnnealingMarginDeg = 0.25;

//! Short runs from ever new seeds do better than one long one.
constexpr std::size_t kAnnealingSteps = 4000;
constexpr std::array kTemperatures{200.0, 30.0, 5.0};

//! In all, at about 0.1 s each. Skulls take some hundred; where there is work for more it is the surface or
//! the bound.
constexpr std::size_t kMostAnnealings = 1000;

//! Rounds that leave as many faces of each patch beyond the bound as there are. Later ones may have more, up
//! to what the whole mesh had.
constexpr std::size_t kPatientRounds = 2;
constexpr std::size_t kMostMoreBeyond = 4; // at once

//! Of the bound on the shift, by round: what a small shift mends is not shifted far.
constexpr std::array kShiftShares{0.125, 0.125, 0.25, 0.25, 0.5, 0.5, 1.0};

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

//! With all neighbours.
std::vector<std::uint32_t> with_ring(const EditableMesh& mesh, std::vector<std::uint32_t> vertices)
{
    const std::size_t count = vertices.size();
    for (std::size_t i = 0; i < count; ++i)
        for (const std::uint32_t v : mesh.neighbours(vertices[i]))
            add_if_new(vertices, v);
    return vertices;
}

//! The face's corners and all their neighbours.
std::vector<std::uint32_t> wide_surroundings(const EditableMesh& mesh, std::uint32_t f)
{
    const Face& face = mesh.face(f);
    return with_ring(mesh, {face.begin(), face.end()});
}

} // namespace

AngleRepair::AngleRepair(EditableMesh& mesh, const BoundingSurface& surface, PatchGuard& guard,
                         double target_angle_deg, std::size_t most_beyond)
    : mesh_(mesh), surface_(surface), guard_(guard), target_angle_deg_(target_angle_deg),
      goal_angle_deg_(target_angle_deg + kMarginDeg), most_beyond_(most_beyond)
{
}

double AngleRepair::angle_of(std::uint32_t f) const
{
    const Face& face = mesh_.face(f);
    return smallest_angle_deg(mesh_.point(face[0]), mesh_.point(face[1]), mesh_.point(face[2]));
}

ShortFaces AngleRepair::short_faces() const
{
    ShortFaces count;
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f)
    {
        if (!mesh_.is_alive(f) || !(angle_of(f) < target_angle_deg_))
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
    for (std::uint32_t f = 0; f < count; ++f)
        if (mesh_.is_alive(f) && angle_of(f) < goal_angle_deg_)
            gained = repair(f, effort) || gained;
    return gained;
}

bool AngleRepair::repair(std::uint32_t f, RepairEffort effort)
{
    const FacePatch before(mesh_, surroundings(mesh_, f));
    return accept_best(trials(before, changes_of(f), effort), before);
}

std::vector<std::uint32_t> AngleRepair::short_face_list() const
{
    std::vector<std::uint32_t> list;
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f)
        if (mesh_.is_alive(f) && angle_of(f) < target_angle_deg_)
            list.push_back(f);
    return list;
}

void AngleRepair::anneal_short_faces(const ShiftBound& shift_bound)
{
    beyond_ = count_beyond(mesh_.mesh(), surface_);
    for (std::size_t round = 0; annealings_ < kMostAnnealings; ++round)
    {
        const std::vector<std::uint32_t> faces = short_face_list();
        if (faces.empty())
            return;
        for (const std::uint32_t f : faces)
            anneal_around(f, round, shift_bound);
    }
}

//! On patches of three sizes.
void AngleRepair::anneal_around(std::uint32_t f, std::size_t round, const ShiftBound& shift_bound)
{
    constexpr int kSizes = 3;
    const double goal_angle_deg = target_angle_deg_ + kAnnealingMarginDeg;
    for (int size = 0; size < kSizes && mesh_.is_alive(f) && annealings_ < kMostAnnealings; ++size)
    {
        std::vector<std::uint32_t> inner = size == 0 ? surroundings(mesh_, f) : wide_surroundings(mesh_, f);
        if (size == 2)
            inner = with_ring(mesh_, std::move(inner));
        const FacePatch before(mesh_, inner);
        const std::size_t spare = most_beyond_ - std::min(most_beyond_, beyond_);
        const ChangedPatch found =
            anneal(before, surface_, guard_, shift_bound,
                   {.goal_angle_deg = goal_angle_deg,
                    .steps = kAnnealingSteps,
                    .seed = annealings_++,
                    .more_beyond = round < kPatientRounds ? 0 : std::min(spare, kMostMoreBeyond),
                    .shift_share = kShiftShares[std::min(round, kShiftShares.size() - 1)],
                    .temperature = kTemperatures[round % kTemperatures.size()]});
        if (found.shortfall > before.shortfall(goal_angle_deg) - kLeastGain)
            continue;
        beyond_ = beyond_ + guard_.fit(found.patch).beyond - guard_.fit(before).beyond;
        commit(found);
    }
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

//! Patches after one change each and the best moves after it, those with the smallest shortfall first.
std::vector<ChangedPatch> AngleRepair::trials(const FacePatch& before, const std::vector<Change>& changes,
                                              RepairEffort effort) const
{
    std::vector<ChangedPatch> result;
    for (const Change& change : changes)
    {
        ChangedPatch trial{before, 0.0, {}};
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
                     [](const ChangedPatch& a, const ChangedPatch& b) { return a.shortfall < b.shortfall; });
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

bool AngleRepair::accept_best(std::vector<ChangedPatch> found, const FacePatch& before)
{
    const double to_beat = before.shortfall(goal_angle_deg_) - kLeastGain;
    std::erase_if(found,
                  [&](ChangedPatch& trial) { return trial.shortfall > to_beat || !project(trial.patch); });
    for (ChangedPatch& trial : found)
        trial.shortfall = trial.patch.shortfall(goal_angle_deg_);
    const double smallest_before = before.smallest_angle_deg();
    std::erase_if(found,
                  [&](const ChangedPatch& trial) {
                      return trial.shortfall > to_beat || trial.patch.smallest_angle_deg() < smallest_before;
                  });
    std::stable_sort(found.begin(), found.end(),
                     [](const ChangedPatch& a, const ChangedPatch& b) { return a.shortfall < b.shortfall; });
    found.erase(found.begin() + static_cast<std::ptrdiff_t>(std::min(found.size(), kMostQuestions)),
                found.end());
    if (found.empty())
        return false;
    const PatchFit fit_before = guard_.fit(before);
    const auto best = std::find_if(found.begin(), found.end(),
                                   [&](const ChangedPatch& trial)
                                   { return guard_.is_sound(trial.patch, before, fit_before); });
    if (best == found.end())
        return false;
    commit(*best);
    return true;
}

void AngleRepair::commit(const ChangedPatch& changed)
{
    changed.patch.commit(mesh_);
    guard_.update();
    counts_ += changed.changes;
}

} // namespace voroprobe
