#include "oracles/crossing_search.h"

#include <cmath>

namespace voroprobe
{
namespace
{

//! Enough for the bisections among them to shrink any bracket to two neighbouring doubles; reached by no
//! smooth function.
constexpr int kMaxRootSteps = 200;

//! Pieces one query is divided into at most: only a function that is zero all along, but for rounding, needs
//! as many. The rest is then told by the ends of its pieces.
constexpr std::size_t kMaxDivisions = std::size_t{1} << 16;

} // namespace

CrossingSearch::CrossingSearch(const ScalarField& field, const Segment3& segment,
                               const Tolerances& tolerances, std::vector<Crossing>& crossings)
    : field_(field), segment_(segment), crossings_(crossings)
{
    const double length = distance(segment.source, segment.target);
    shortest_ = tolerances.resolution / length;
    root_tolerance_ = tolerances.root / length;
}

CrossingSearch::Probe CrossingSearch::probe(double t) const
{
    const double value = field_.value(at(t));
    return {t, std::isnan(value) ? 0.0 : value, value >= 0.0};
}

void CrossingSearch::search(const Probe& from, const Probe& to)
{
    const bool settled = to.t - from.t <= shortest_ || divisions_ >= kMaxDivisions ||
                         field_.ends_tell_all({at(from.t), at(to.t)}, {from.value, to.value});
    if (settled)
    {
        if (from.inside != to.inside)
            append(root(from, to), false);
        return;
    }
    ++divisions_;
    const Probe middle = probe(0.5 * (from.t + to.t));
    search(from, middle);
    search(middle, to);
}

// By the secant of the ends with Illinois' correction: the value of an end kept twice counts half. Every
// third step bisects, which bounds the number of steps where the function is far from straight.
double CrossingSearch::root(Probe low, Probe high) const
{
    bool low_moved_last = false;
    for (int step = 1; step <= kMaxRootSteps && high.t - low.t > root_tolerance_; ++step)
    {
        const double middle = 0.5 * (low.t + high.t);
        if (!(middle > low.t && middle < high.t))
            break; // no double lies between
        const double secant = low.t + (high.t - low.t) * (low.value / (low.value - high.value));
        const bool usable = step % 3 != 0 && secant > low.t && secant < high.t;
        const Probe next = probe(usable ? secant : middle);
        const bool moves_low = next.inside == low.inside;
        if (step > 1 && moves_low == low_moved_last)
            (moves_low ? high : low).value *= 0.5;
        (moves_low ? low : high) = next;
        low_moved_last = moves_low;
    }
    return 0.5 * (low.t + high.t);
}

} // namespace voroprobe
