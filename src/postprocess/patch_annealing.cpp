#include "postprocess/patch_annealing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "support/random.h"

namespace voroprobe
{

namespace
{

//! In the end steps may raise the shortfall by so much, squared degrees: nearly nothing.
constexpr double kLastTemperature = 0.3;

//! Of the steps so many move a vertex, flip an edge, collapse one; the rest splits one.
constexpr double kShareOfMoves = 0.6;
constexpr double kShareOfFlips = 0.2;
constexpr double kShareOfCollapses = 0.1;

//! The shortest moves, as a power of ten of the longest edge around the vertex; the longest are as long as
//! it.
constexpr double kLeastMovePower = -2.0;

class Annealing
{
public:
    Annealing(const FacePatch& before, const BoundingSurface& surface, PatchGuard& guard,
              const ShiftBound& shift_bound, const AnnealingOptions& options)
        : surface_(surface), guard_(guard), options_(options), random_(options.seed),
          fit_before_(guard.fit(before)),
          shift_bound_(shift_bound.around(before.mesh(), options.shift_share)),
          smallest_before_(before.smallest_angle_deg()), current_{before,
                                                                  before.shortfall(options.goal_angle_deg),
                                                                  {}},
          best_(current_)
    {
        fit_before_.beyond += options.more_beyond;
    }

    ChangedPatch run()
    {
        const double cooling =
            std::pow(kLastTemperature / options_.temperature, 1.0 / static_cast<double>(options_.steps));
        double temperature = options_.temperature;
        for (std::size_t i = 0; i < options_.steps && best_.shortfall > 0.0; ++i)
        {
            step(-temperature * std::log(1.0 - random_.uniform()));
            temperature *= cooling;
        }
        return std::move(best_);
    }

private:
    //! Tries one, the cheap questions first.
    void step(double allowed_rise)
    {
        ChangedPatch trial = current_;
        if (!change(trial))
            return;
        trial.shortfall = trial.patch.shortfall(options_.goal_angle_deg);
        if (trial.shortfall > current_.shortfall + allowed_rise ||
            !guard_.is_sound(trial.patch, current_.patch, fit_before_) ||
            !shift_bound_.holds(trial.patch.mesh()))
            return;
        current_ = std::move(trial);
        if (current_.shortfall < best_.shortfall && current_.patch.smallest_angle_deg() >= smallest_before_)
            best_ = current_;
    }

    bool change(ChangedPatch& trial)
    {
        const double kind = random_.uniform();
        if (kind < kShareOfMoves)
            return move(trial);
        const auto edges = trial.patch.inner_edges();
        if (edges.empty())
            return false;
        auto [a, b] = edges[random_.below(edges.size())];
        if (random_.below(2) == 0)
            std::swap(a, b);
        if (kind < kShareOfMoves + kShareOfFlips)
        {
            ++trial.changes.flips;
            return trial.patch.flip(a, b);
        }
        return kind < kShareOfMoves + kShareOfFlips + kShareOfCollapses ? collapse(trial, a, b)
                                                                        : split(trial, a, b);
    }

    bool move(ChangedPatch& trial)
    {
        const auto& inner = trial.patch.inner();
        if (inner.empty())
            return false;
        const std::uint32_t v = inner[random_.below(inner.size())];
        const Point3 here = trial.patch.point(v);
        const double size =
            trial.patch.longest_edge_at(v) * std::pow(10.0, random_.uniform(kLeastMovePower, 0.0));
        const double x = random_.uniform(-1.0, 1.0);
        const double y = random_.uniform(-1.0, 1.0);
        const double z = random_.uniform(-1.0, 1.0);
        return place(trial.patch, v, here + size * Vec3{x, y, z});
    }

    //! Into one end, or the middle.
    bool collapse(ChangedPatch& trial, std::uint32_t a, std::uint32_t b)
    {
        ++trial.changes.collapses;
        const Point3 end = trial.patch.point(a);
        if (!trial.patch.collapse(a, b))
            return false;
        if (random_.below(2) != 0)
            return place(trial.patch, a, trial.patch.point(a));
        trial.patch.move(a, end);
        return true;
    }

    bool split(ChangedPatch& trial, std::uint32_t a, std::uint32_t b)
    {
        ++trial.changes.splits;
        if (!trial.patch.split(a, b))
            return false;
        const std::uint32_t middle = trial.patch.inner().back();
        return place(trial.patch, middle, trial.patch.point(middle));
    }

    //! Onto the surface; or nowhere, where faces do not follow it: the bound on the shift holds them.
    bool place(FacePatch& patch, std::uint32_t vertex, const Point3& to)
    {
        if (guard_.is_beyond(patch, vertex))
        {
            patch.move(vertex, to);
            return true;
        }
        const auto target = surface_.projection(to);
        if (target)
            patch.move(vertex, target->point);
        return target.has_value();
    }

    const BoundingSurface& surface_;
    PatchGuard& guard_;
    const AnnealingOptions& options_;
    Random random_;
    PatchFit fit_before_;
    ShiftBound::OfPatch shift_bound_;
    double smallest_before_; //!< angle, degrees
    ChangedPatch current_;
    ChangedPatch best_;
};

} // namespace

RelaxationCounts& RelaxationCounts::operator+=(const RelaxationCounts& more)
{
    flips += more.flips;
    collapses += more.collapses;
    splits += more.splits;
    return *this;
}

ChangedPatch anneal(const FacePatch& before, const BoundingSurface& surface, PatchGuard& guard,
                    const ShiftBound& shift_bound, const AnnealingOptions& options)
{
    return Annealing(before, surface, guard, shift_bound, options).run();
}

} // namespace voroprobe
