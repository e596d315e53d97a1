#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace voroprobe
{

//! A closed interval of reals that holds the true value of an expression and the one doubles give as well:
//! bounds are moved outward by more than the rounding of what they bound. Unbounded, it may also stand for
//! NaN: any operation on it, and any that is not defined on all of its operands, gives everything(). The
//! processor's rounding mode is left alone, which compilers do not expect to change.
//! Source: Moore, Kearfott & Cloud, Introduction to Interval Analysis, 2009.
struct Interval
{
    double low = 0.0;
    double high = 0.0;

    [[nodiscard]] bool is_bounded() const { return std::isfinite(low) && std::isfinite(high); }
    [[nodiscard]] bool is_point() const { return low == high; }
    [[nodiscard]] bool contains(double x) const { return low <= x && x <= high; }

    //! 0 may be one end, not between: a derivative like this means a monotone function.
    [[nodiscard]] bool keeps_sign() const { return low >= 0.0 || high <= 0.0; }

    friend bool operator==(const Interval&, const Interval&) = default;
};

namespace interval
{

//! Covers a result that is correctly rounded: one unit in the last place or more.
inline constexpr double kRounding = 0x1.0p-52;

//! Covers the functions of the C library: glibc's manual lists errors of at most 2 units in the last place on
//! x86-64 for those used here.
inline constexpr double kLibraryRounding = 0x1.0p-49;

//! What underflow may lose.
inline constexpr double kUnderflow = std::numeric_limits<double>::denorm_min();

constexpr Interval everything()
{
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}

constexpr Interval point(double x)
{
    return {x, x};
}

//! [low, high] widened by a relative and an absolute error; everything() where a bound is NaN. A lower bound
//! that overflowed is the largest double, and the other way round.
inline Interval widened(double low, double high, double error, double underflow = kUnderflow)
{
    if (std::isnan(low) || std::isnan(high))
        return everything();
    const double most = std::numeric_limits<double>::max();
    low = std::min(low, most);
    high = std::max(high, -most);
    return {low - (std::abs(low) * error + underflow), high + (std::abs(high) * error + underflow)};
}

inline Interval hull(const Interval& a, const Interval& b)
{
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

inline Interval operator-(const Interval& a)
{
    return {-a.high, -a.low};
}

//! Sums of doubles that are zero are so exactly: zero is not widened.
inline Interval operator+(const Interval& a, const Interval& b)
{
    if (!a.is_bounded() || !b.is_bounded())
        return everything();
    return widened(a.low + b.low, a.high + b.high, kRounding, 0.0);
}

inline Interval operator-(const Interval& a, const Interval& b)
{
    return a + (-b);
}

inline Interval operator*(const Interval& a, const Interval& b)
{
    if (!a.is_bounded() || !b.is_bounded())
        return everything();
    if (a == point(0.0) || b == point(0.0))
        return point(0.0);
    const double ll = a.low * b.low;
    const double lh = a.low * b.high;
    const double hl = a.high * b.low;
    const double hh = a.high * b.high;
    return widened(std::min({ll, lh, hl, hh}), std::max({ll, lh, hl, hh}), kRounding);
}

inline Interval operator/(const Interval& a, const Interval& b)
{
    if (!a.is_bounded() || !b.is_bounded() || b.contains(0.0))
        return everything();
    if (a == point(0.0))
        return a;
    const double ll = a.low / b.low;
    const double lh = a.low / b.high;
    const double hl = a.high / b.low;
    const double hh = a.high / b.high;
    return widened(std::min({ll, lh, hl, hh}), std::max({ll, lh, hl, hh}), kRounding);
}

Interval square(const Interval& a);
Interval min(const Interval& a, const Interval& b);
Interval max(const Interval& a, const Interval& b);
Interval abs(const Interval& a);
Interval power(const Interval& base, const Interval& exponent);
Interval atan2(const Interval& y, const Interval& x);

Interval sin(const Interval& a);
Interval cos(const Interval& a);
Interval tan(const Interval& a);

//! A function that does not fall, defined on [first, last]; everything() where `a` reaches beyond.
template <class Function>
Interval increasing(Function function, const Interval& a, double first = -std::numeric_limits<double>::max(),
                    double last = std::numeric_limits<double>::max())
{
    if (!(a.low >= first && a.high <= last))
        return everything();
    return widened(function(a.low), function(a.high), kLibraryRounding);
}

} // namespace interval
} // namespace voroprobe
