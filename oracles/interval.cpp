#include "oracles/interval.h"

#include <cmath>
#include <numbers>

namespace voroprobe::interval
{
namespace
{

//! Beyond this the place of an angle within its turn is not trusted, radians.
constexpr double kLargestAngle = 1e6;

//! By how much a quotient of an angle may be wrong: far above its rounding below kLargestAngle, in turns.
constexpr double kTurnRounding = 1e-9;

//! Might there be a whole k with offset + k * period in the interval?
bool may_hold(const Interval& a, double offset, double period)
{
    return std::floor((a.low - offset) / period - kTurnRounding) !=
           std::floor((a.high - offset) / period + kTurnRounding);
}

//! Sine or cosine, whose maxima are at `first_maximum` plus whole turns.
template <class Function>
Interval wave(Function function, const Interval& a, double first_maximum)
{
    using std::numbers::pi;
    if (!a.is_bounded())
        return everything();
    if (std::max(std::abs(a.low), std::abs(a.high)) > kLargestAngle)
        return {-1.0, 1.0};
    const double at_low = function(a.low);
    const double at_high = function(a.high);
    Interval values = widened(std::min(at_low, at_high), std::max(at_low, at_high), kLibraryRounding);
    if (may_hold(a, first_maximum, 2.0 * pi))
        values.high = 1.0;
    if (may_hold(a, first_maximum + pi, 2.0 * pi))
        values.low = -1.0;
    return {std::max(values.low, -1.0), std::min(values.high, 1.0)};
}

} // namespace

Interval square(const Interval& a)
{
    if (!a.is_bounded())
        return everything();
    const Interval magnitude = abs(a);
    Interval result = magnitude * magnitude;
    result.low = std::max(result.low, 0.0);
    return result;
}

Interval min(const Interval& a, const Interval& b)
{
    if (!a.is_bounded() || !b.is_bounded())
        return everything();
    return {std::min(a.low, b.low), std::min(a.high, b.high)};
}

Interval max(const Interval& a, const Interval& b)
{
    return -min(-a, -b);
}

Interval abs(const Interval& a)
{
    if (!a.is_bounded())
        return everything();
    if (a.low >= 0.0)
        return a;
    if (a.high <= 0.0)
        return -a;
    return {0.0, std::max(-a.low, a.high)};
}

// For positive bases x^y is monotone in each of x and y, so its bounds are at the corners.
Interval power(const Interval& base, const Interval& exponent)
{
    if (!base.is_bounded() || !exponent.is_bounded() || base.low < 0.0)
        return everything();
    if (base.low == 0.0 && exponent.low <= 0.0)
        return everything();
    const double ll = std::pow(base.low, exponent.low);
    const double lh = std::pow(base.low, exponent.high);
    const double hl = std::pow(base.high, exponent.low);
    const double hh = std::pow(base.high, exponent.high);
    return widened(std::min({ll, lh, hl, hh}), std::max({ll, lh, hl, hh}), kLibraryRounding);
}

Interval atan2(const Interval& y, const Interval& x)
{
    if (!y.is_bounded() || !x.is_bounded())
        return everything();
    if (x.low > 0.0)
        return increasing([](double t) { return std::atan(t); }, y / x);
    return widened(-std::numbers::pi, std::numbers::pi, kLibraryRounding);
}

Interval sin(const Interval& a)
{
    return wave([](double x) { return std::sin(x); }, a, std::numbers::pi / 2.0);
}

Interval cos(const Interval& a)
{
    return wave([](double x) { return std::cos(x); }, a, 0.0);
}

Interval tan(const Interval& a)
{
    if (!a.is_bounded() || std::max(std::abs(a.low), std::abs(a.high)) > kLargestAngle ||
        may_hold(a, std::numbers::pi / 2.0, std::numbers::pi))
        return everything();
    return increasing([](double x) { return std::tan(x); }, a);
}

} // namespace voroprobe::interval
