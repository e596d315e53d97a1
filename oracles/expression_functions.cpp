#include "oracles/expression_functions.h"

#include <array>
#include <cmath>
#include <numbers>

namespace voroprobe
{
namespace
{

using interval::everything;
using interval::increasing;
using interval::point;
using interval::operator+;
using interval::operator-;
using interval::operator*;
using interval::operator/;

constexpr Interval kOne{1.0, 1.0};

// Functions that only rise, over the range where they are defined. A lambda without captures becomes the
// plain function that the table wants.

Interval interval_root(const Interval& a)
{
    return increasing([](double x) { return std::sqrt(x); }, a, 0.0);
}

Interval interval_exp(const Interval& a)
{
    return increasing([](double x) { return std::exp(x); }, a);
}

//! log, log2 and log10 rise where they are defined; at 0 they are minus infinity.
template <double (*Logarithm)(double)>
Interval logarithm(const Interval& a)
{
    return increasing(Logarithm, a, std::numeric_limits<double>::denorm_min());
}

Interval interval_cosh(const Interval& a)
{
    return increasing([](double x) { return std::cosh(x); }, interval::abs(a));
}

Interval interval_sinh(const Interval& a)
{
    return increasing([](double x) { return std::sinh(x); }, a);
}

Interval interval_cube_root(const Interval& a)
{
    return increasing([](double x) { return std::cbrt(x); }, a);
}

//! Steps: exact, and flat but where they jump.
template <double (*Step)(double)>
Interval steps(const Interval& a)
{
    return a.is_bounded() ? Interval{Step(a.low), Step(a.high)} : everything();
}

template <double (*Step)(double)>
Interval slope_of_steps(const Interval& a)
{
    return a.is_bounded() && Step(a.low) == Step(a.high) ? point(0.0) : everything();
}

double sign(double x)
{
    return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : x; // NaN stays
}

double natural_logarithm(double x)
{
    return std::log(x);
}
double binary_logarithm(double x)
{
    return std::log2(x);
}
double decimal_logarithm(double x)
{
    return std::log10(x);
}
double nearest_whole(double x)
{
    return std::rint(x);
}
double whole_below(double x)
{
    return std::floor(x);
}
double whole_above(double x)
{
    return std::ceil(x);
}

Interval slope_of_tan(const Interval& a)
{
    return kOne + interval::square(interval::tan(a));
}

Interval slope_of_asin(const Interval& a)
{
    return kOne / interval_root(kOne - interval::square(a));
}

Interval slope_of_abs(const Interval& a)
{
    return a.low >= 0.0 ? kOne : a.high <= 0.0 ? -kOne : Interval{-1.0, 1.0};
}

template <double (*Function)(double)>
Interval rising(const Interval& a)
{
    return increasing(Function, a);
}

double inverse_tan(double x)
{
    return std::atan(x);
}
double hyperbolic_tan(double x)
{
    return std::tanh(x);
}
double inverse_sinh(double x)
{
    return std::asinh(x);
}

const std::array kFunctions{
    UnaryFunction{"sin", [](double x) { return std::sin(x); }, interval::sin, interval::cos},
    UnaryFunction{"cos", [](double x) { return std::cos(x); }, interval::cos,
                  [](const Interval& a) { return -interval::sin(a); }},
    UnaryFunction{"tan", [](double x) { return std::tan(x); }, interval::tan, slope_of_tan},
    UnaryFunction{"asin", [](double x) { return std::asin(x); },
                  [](const Interval& a)
                  { return increasing([](double x) { return std::asin(x); }, a, -1.0, 1.0); },
                  slope_of_asin},
    UnaryFunction{"acos", [](double x) { return std::acos(x); },
                  [](const Interval& a)
                  { return -increasing([](double x) { return -std::acos(x); }, a, -1.0, 1.0); },
                  [](const Interval& a) { return -slope_of_asin(a); }},
    UnaryFunction{"atan", inverse_tan, rising<inverse_tan>,
                  [](const Interval& a) { return kOne / (kOne + interval::square(a)); }},
    UnaryFunction{"sinh", [](double x) { return std::sinh(x); }, interval_sinh, interval_cosh},
    UnaryFunction{"cosh", [](double x) { return std::cosh(x); }, interval_cosh, interval_sinh},
    UnaryFunction{"tanh", hyperbolic_tan, rising<hyperbolic_tan>,
                  [](const Interval& a) { return kOne / interval::square(interval_cosh(a)); }},
    UnaryFunction{"asinh", inverse_sinh, rising<inverse_sinh>,
                  [](const Interval& a) { return kOne / interval_root(kOne + interval::square(a)); }},
    UnaryFunction{"exp", [](double x) { return std::exp(x); }, interval_exp, interval_exp},
    UnaryFunction{"log", natural_logarithm, logarithm<natural_logarithm>,
                  [](const Interval& a) { return kOne / a; }},
    UnaryFunction{"ln", natural_logarithm, logarithm<natural_logarithm>,
                  [](const Interval& a) { return kOne / a; }},
    UnaryFunction{"log2", binary_logarithm, logarithm<binary_logarithm>,
                  [](const Interval& a) {
                      return kOne / (a * Interval{0.6931471805599452, 0.6931471805599454});
                  }},
    UnaryFunction{"log10", decimal_logarithm, logarithm<decimal_logarithm>,
                  [](const Interval& a) {
                      return kOne / (a * Interval{2.302585092994045, 2.302585092994047});
                  }},
    UnaryFunction{"sqrt", [](double x) { return std::sqrt(x); }, interval_root,
                  [](const Interval& a) { return point(0.5) / interval_root(a); }},
    UnaryFunction{"cbrt", [](double x) { return std::cbrt(x); }, interval_cube_root,
                  [](const Interval& a)
                  { return kOne / (point(3.0) * interval::square(interval_cube_root(a))); }},
    UnaryFunction{"abs", [](double x) { return std::abs(x); }, interval::abs, slope_of_abs},
    UnaryFunction{"sign", sign, steps<sign>, slope_of_steps<sign>},
    UnaryFunction{"rint", nearest_whole, steps<nearest_whole>, slope_of_steps<nearest_whole>},
    UnaryFunction{"floor", whole_below, steps<whole_below>, slope_of_steps<whole_below>},
    UnaryFunction{"ceil", whole_above, steps<whole_above>, slope_of_steps<whole_above>},
};

} // namespace

std::span<const UnaryFunction> unary_functions()
{
    return kFunctions;
}

} // namespace voroprobe
