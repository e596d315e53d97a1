#include "oracles/implicit_oracle.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "support/error.h"

namespace voroprobe
{
namespace
{

//! Length of the bracket that ends the refinement of a crossing, as a fraction of the oracle's resolution.
constexpr double kRootTolerance = 1e-9;

//! Enough for bisection alone to shrink a bracket of one resolution below the tolerance; reached by no smooth
//! function.
constexpr int kMaxRootSteps = 64;

//! A point of the segment with the function's value there.
struct Probe
{
    double t;
    double value; //!< 0 where the function is NaN: no evidence about the neighbourhood
    bool inside;
};

//! Finds the crossings of one segment, already clipped to the domain.
class CrossingSearch
{
public:
    CrossingSearch(const ImplicitOracle::Function& function, const Segment3& segment, double lipschitz_bound,
                   double resolution, std::vector<Crossing>& crossings)
        : function_(function), segment_(segment), crossings_(crossings),
          change_bound_(lipschitz_bound * distance(segment.source, segment.target)),
          shortest_(resolution / distance(segment.source, segment.target))
    {
    }

    [[nodiscard]] Probe probe(double t) const
    {
        const double value = function_(t == 1.0 ? segment_.target : segment_.at(t));
        return {t, std::isnan(value) ? 0.0 : value, value >= 0.0};
    }

    void append(double t, bool on_border) const { crossings_.push_back({t, segment_.at(t), on_border}); }

    //! Appends every change of side between two probes, in order.
    void search(const Probe& from, const Probe& to) const
    {
        const bool changes_side = from.inside != to.inside;
        if (to.t - from.t <= shortest_)
        {
            if (changes_side)
                append(root(from, to), false);
            return;
        }

        // To reach zero and come back, the function would have to change by the sum of both values.
        if (!changes_side && std::abs(from.value) + std::abs(to.value) > change_bound_ * (to.t - from.t))
            return;
        const Probe middle = probe(0.5 * (from.t + to.t));
        search(from, middle);
        search(middle, to);
    }

private:
    //! The change of side in a bracket, by the secant of its ends with Illinois' correction: the value of an
    //! end kept twice counts half. Every third step bisects, which bounds the number of steps where the
    //! function is far from straight.
    [[nodiscard]] double root(Probe low, Probe high) const
    {
        const double tolerance = kRootTolerance * shortest_;
        bool low_moved_last = false;
        for (int step = 1; step <= kMaxRootSteps && high.t - low.t > tolerance; ++step)
        {
            const double secant = low.t + (high.t - low.t) * (low.value / (low.value - high.value));
            const bool usable = step % 3 != 0 && secant > low.t && secant < high.t;
            const Probe next = probe(usable ? secant : 0.5 * (low.t + high.t));
            const bool moves_low = next.inside == low.inside;
            if (step > 1 && moves_low == low_moved_last)
                (moves_low ? high : low).value *= 0.5;
            (moves_low ? low : high) = next;
            low_moved_last = moves_low;
        }
        return 0.5 * (low.t + high.t);
    }

    const ImplicitOracle::Function& function_;
    const Segment3& segment_;
    std::vector<Crossing>& crossings_;
    double change_bound_; //!< how much the function can change along the whole segment
    double shortest_;     //!< the resolution, in the segment's parameter
};

} // namespace

ImplicitOracle::ImplicitOracle(Function function, const Box3& domain, double lipschitz_bound,
                               double resolution)
    : function_(std::move(function)), domain_(domain), lipschitz_bound_(lipschitz_bound),
      resolution_(resolution)
{
    if (!function_)
        throw UsageError("implicit oracle: no function");
    if (domain.empty() || !is_finite(domain.min) || !is_finite(domain.max))
        throw UsageError("implicit oracle: the domain is empty or not finite");
    if (!(lipschitz_bound > 0.0) || !std::isfinite(lipschitz_bound))
        throw UsageError("implicit oracle: Lipschitz bound " + std::to_string(lipschitz_bound) +
                         ", expected a positive number");
    if (!(resolution > 0.0) || !std::isfinite(resolution))
        throw UsageError("implicit oracle: resolution " + std::to_string(resolution) +
                         ", expected a positive number");
}

Region ImplicitOracle::region(const Point3& p) const
{
    return domain_.contains(p) && function_(p) >= 0.0 ? Region{1} : kOuterRegion;
}

void ImplicitOracle::find_crossings(const Segment3& segment, std::vector<Crossing>& crossings) const
{
    crossings.clear();
    if (segment.source == segment.target || !is_finite(segment.source) || !is_finite(segment.target))
        return;
    const auto range = clip_to_box(segment, domain_);
    if (!range)
        return;

    const CrossingSearch search(function_, segment, lipschitz_bound_, resolution_, crossings);
    const Probe first = search.probe(range->first);
    const Probe last = search.probe(range->second);
    if (first.inside && !domain_.contains(segment.source))
        search.append(first.t, true);
    search.search(first, last);
    if (last.inside && !domain_.contains(segment.target))
        search.append(last.t, true);
}

bool ImplicitOracle::may_cross(const Box3& box) const
{
    Box3 part;
    part.min = {std::max(box.min.x, domain_.min.x), std::max(box.min.y, domain_.min.y),
                std::max(box.min.z, domain_.min.z)};
    part.max = {std::min(box.max.x, domain_.max.x), std::min(box.max.y, domain_.max.y),
                std::min(box.max.z, domain_.max.z)};
    if (part.empty())
        return false;

    const double value = function_(part.center());
    if (!(std::abs(value) > 0.5 * lipschitz_bound_ * part.diagonal()))
        return true;
    const bool within_domain = part.min.x > domain_.min.x && part.min.y > domain_.min.y &&
                               part.min.z > domain_.min.z && part.max.x < domain_.max.x &&
                               part.max.y < domain_.max.y && part.max.z < domain_.max.z;
    return value > 0.0 && !within_domain; // an object that touches the domain's border has its cap there
}

} // namespace voroprobe
