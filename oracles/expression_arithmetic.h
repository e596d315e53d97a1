#pragma once

#include <cmath>

#include "oracles/expression_tape.h"
#include "oracles/interval.h"

//! The operations of a tape for numbers, for intervals, and for intervals with slopes. NaN goes through all
//! of them, so that a formula that is undefined somewhere shows it.
namespace voroprobe::arithmetic
{

// Numbers

inline double add(double a, double b)
{
    return a + b;
}
inline double subtract(double a, double b)
{
    return a - b;
}
inline double multiply(double a, double b)
{
    return a * b;
}
inline double divide(double a, double b)
{
    return a / b;
}
inline double negate(double a)
{
    return -a;
}
inline double square(double a)
{
    return a * a;
}
inline double power(double a, double b)
{
    return std::pow(a, b);
}
inline double angle(double y, double x)
{
    return std::atan2(y, x);
}
inline double minimum(double a, double b)
{
    return a < b || std::isnan(a) ? a : b;
}
inline double maximum(double a, double b)
{
    return a > b || std::isnan(a) ? a : b;
}
inline double less(double a, double b)
{
    return a < b ? 1.0 : 0.0;
}
inline double less_or_equal(double a, double b)
{
    return a <= b ? 1.0 : 0.0;
}
inline double equal(double a, double b)
{
    return a == b ? 1.0 : 0.0;
}
inline double both(double a, double b)
{
    return a != 0.0 && b != 0.0 ? 1.0 : 0.0;
}
inline double choose(double condition, double a, double b)
{
    return condition != 0.0 ? a : b;
}
inline double apply(const UnaryFunction& function, double a)
{
    return function.of_number(a);
}

// Intervals

inline Interval add(const Interval& a, const Interval& b)
{
    return interval::operator+(a, b);
}
inline Interval subtract(const Interval& a, const Interval& b)
{
    return interval::operator-(a, b);
}
inline Interval multiply(const Interval& a, const Interval& b)
{
    return interval::operator*(a, b);
}
inline Interval divide(const Interval& a, const Interval& b)
{
    return interval::operator/(a, b);
}
inline Interval negate(const Interval& a)
{
    return interval::operator-(a);
}
inline Interval square(const Interval& a)
{
    return interval::square(a);
}
inline Interval power(const Interval& a, const Interval& b)
{
    return interval::power(a, b);
}
inline Interval angle(const Interval& y, const Interval& x)
{
    return interval::atan2(y, x);
}
inline Interval minimum(const Interval& a, const Interval& b)
{
    return interval::min(a, b);
}
inline Interval maximum(const Interval& a, const Interval& b)
{
    return interval::max(a, b);
}

//! 1 where it is certainly true, 0 where certainly false, both otherwise.
inline Interval truth(bool certainly_true, bool certainly_false)
{
    return {certainly_true ? 1.0 : 0.0, certainly_false ? 0.0 : 1.0};
}
inline bool certainly_true(const Interval& a)
{
    return !a.contains(0.0);
}
inline bool certainly_false(const Interval& a)
{
    return a == interval::point(0.0);
}
inline Interval less(const Interval& a, const Interval& b)
{
    return truth(a.high < b.low, a.low >= b.high);
}
inline Interval less_or_equal(const Interval& a, const Interval& b)
{
    return truth(a.high <= b.low, a.low > b.high);
}
inline Interval equal(const Interval& a, const Interval& b)
{
    return truth(a.is_point() && a == b, a.high < b.low || b.high < a.low);
}
inline Interval both(const Interval& a, const Interval& b)
{
    return truth(certainly_true(a) && certainly_true(b), certainly_false(a) || certainly_false(b));
}
inline Interval choose(const Interval& condition, const Interval& a, const Interval& b)
{
    return certainly_true(condition) ? a : certainly_false(condition) ? b : interval::hull(a, b);
}
inline Interval apply(const UnaryFunction& function, const Interval& a)
{
    return function.of_interval(a);
}

// Intervals with slopes: the rules of differentiation

inline IntervalSlope add(const IntervalSlope& a, const IntervalSlope& b)
{
    return {add(a.value, b.value), add(a.slope, b.slope)};
}
inline IntervalSlope subtract(const IntervalSlope& a, const IntervalSlope& b)
{
    return {subtract(a.value, b.value), subtract(a.slope, b.slope)};
}
inline IntervalSlope multiply(const IntervalSlope& a, const IntervalSlope& b)
{
    return {multiply(a.value, b.value), add(multiply(a.slope, b.value), multiply(a.value, b.slope))};
}
inline IntervalSlope divide(const IntervalSlope& a, const IntervalSlope& b)
{
    const Interval quotient = divide(a.value, b.value);
    return {quotient, divide(subtract(a.slope, multiply(quotient, b.slope)), b.value)};
}
inline IntervalSlope negate(const IntervalSlope& a)
{
    return {negate(a.value), negate(a.slope)};
}
inline IntervalSlope square(const IntervalSlope& a)
{
    return {square(a.value), multiply(multiply(interval::point(2.0), a.value), a.slope)};
}
IntervalSlope power(const IntervalSlope& a, const IntervalSlope& b);
IntervalSlope angle(const IntervalSlope& y, const IntervalSlope& x);
IntervalSlope minimum(const IntervalSlope& a, const IntervalSlope& b);
IntervalSlope maximum(const IntervalSlope& a, const IntervalSlope& b);
IntervalSlope choose(const IntervalSlope& condition, const IntervalSlope& a, const IntervalSlope& b);

//! 0 or 1: it does not change where it is certain, and jumps otherwise.
inline IntervalSlope step(const Interval& value)
{
    return {value, value.is_point() ? interval::point(0.0) : interval::everything()};
}
inline IntervalSlope less(const IntervalSlope& a, const IntervalSlope& b)
{
    return step(less(a.value, b.value));
}
inline IntervalSlope less_or_equal(const IntervalSlope& a, const IntervalSlope& b)
{
    return step(less_or_equal(a.value, b.value));
}
inline IntervalSlope equal(const IntervalSlope& a, const IntervalSlope& b)
{
    return step(equal(a.value, b.value));
}
inline IntervalSlope both(const IntervalSlope& a, const IntervalSlope& b)
{
    return step(both(a.value, b.value));
}
inline IntervalSlope apply(const UnaryFunction& function, const IntervalSlope& a)
{
    return {function.of_interval(a.value), multiply(function.derivative(a.value), a.slope)};
}

//! By repeated squaring, the same products whatever is multiplied: so the interval holds the number. \pre n >
//! 0.
template <class Value>
Value natural_power(const Value& base, int n)
{
    if (n == 1)
        return base;
    const Value root = natural_power(base, n / 2);
    const Value even = square(root);
    return n % 2 == 0 ? even : multiply(even, base);
}

} // namespace voroprobe::arithmetic
