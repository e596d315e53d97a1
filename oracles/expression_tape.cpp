#include "oracles/expression_tape.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "oracles/expression_arithmetic.h"

namespace voroprobe
{
namespace arithmetic
{

IntervalSlope power(const IntervalSlope& a, const IntervalSlope& b)
{
    const Interval one = interval::point(1.0);
    const Interval value = power(a.value, b.value);
    const Interval by_base = multiply(multiply(b.value, power(a.value, subtract(b.value, one))), a.slope);
    if (b.slope == interval::point(0.0))
        return {value, by_base};
    const Interval logarithm = a.value.low > 0.0
                                   ? interval::increasing([](double x) { return std::log(x); }, a.value)
                                   : interval::everything();
    return {value, add(by_base, multiply(multiply(value, logarithm), b.slope))};
}

IntervalSlope angle(const IntervalSlope& y, const IntervalSlope& x)
{
    const Interval value = angle(y.value, x.value);
    if (x.value.low <= 0.0 && y.value.contains(0.0))
        return {value, interval::everything()}; // across the jump from -pi to pi
    const Interval turning = subtract(multiply(x.value, y.slope), multiply(y.value, x.slope));
    return {value, divide(turning, add(square(x.value), square(y.value)))};
}

IntervalSlope minimum(const IntervalSlope& a, const IntervalSlope& b)
{
    const Interval value = minimum(a.value, b.value);
    if (a.value.high < b.value.low)
        return {value, a.slope};
    if (b.value.high < a.value.low)
        return {value, b.slope};
    return {value, interval::hull(a.slope, b.slope)};
}

IntervalSlope maximum(const IntervalSlope& a, const IntervalSlope& b)
{
    return negate(minimum(negate(a), negate(b)));
}

IntervalSlope choose(const IntervalSlope& condition, const IntervalSlope& a, const IntervalSlope& b)
{
    if (certainly_true(condition.value))
        return a;
    if (certainly_false(condition.value))
        return b;
    return {interval::hull(a.value, b.value), interval::everything()};
}

} // namespace arithmetic

namespace
{

//! Larger whole exponents are left to the C library.
constexpr double kLargestWholeExponent = 64.0;

//! Rounding of points along a segment, relative to its coordinates: a product and two sums.
constexpr double kPointRounding = 0x1.0p-50;

//! The number as a value that does not change.
template <class Value>
Value constant_value(double x);

template <>
double constant_value(double x)
{
    return x;
}
template <>
Interval constant_value(double x)
{
    return std::isfinite(x) ? interval::point(x) : interval::everything();
}
template <>
IntervalSlope constant_value(double x)
{
    return {constant_value<Interval>(x), interval::point(0.0)};
}

//! One coordinate of all points along a segment.
IntervalSlope coordinate(double source, double target)
{
    using interval::point;
    if (source == target)
        return {point(source), point(0.0)};
    const double margin = kPointRounding * (std::abs(source) + std::abs(target));
    return {{std::min(source, target) - margin, std::max(source, target) + margin},
            interval::operator-(point(target), point(source))};
}

//! 1 - truth
template <class Value>
Value opposite(const Value& truth)
{
    return arithmetic::subtract(constant_value<Value>(1.0), truth);
}

template <class Value>
Value is_zero(const Value& a)
{
    return arithmetic::equal(a, constant_value<Value>(0.0));
}

template <class Value>
Value whole_power(const Value& base, int exponent)
{
    const Value power = arithmetic::natural_power(base, std::abs(exponent));
    return exponent > 0 ? power : arithmetic::divide(constant_value<Value>(1.0), power);
}

} // namespace

ExpressionTape::ExpressionTape() : steps_(3, Step{Operation::kConstant}) {}

ExpressionTape::Slot ExpressionTape::append(const Step& step)
{
    steps_.push_back(step);
    return static_cast<Slot>(steps_.size() - 1);
}

bool ExpressionTape::is_constant(Slot slot) const
{
    return slot > 2 && steps_[slot].operation == Operation::kConstant;
}

ExpressionTape::Slot ExpressionTape::constant(double value)
{
    return append({.operation = Operation::kConstant, .constant = value});
}

ExpressionTape::Slot ExpressionTape::unary(const UnaryFunction& function, Slot a)
{
    if (is_constant(a))
        return constant(function.of_number(constant_at(a)));
    return append({.operation = Operation::kUnary, .a = a, .function = &function});
}

// Powers of a known whole exponent are products: defined for negative bases, and tighter as intervals.
ExpressionTape::Slot ExpressionTape::power(Slot base, Slot exponent)
{
    if (is_constant(exponent))
    {
        const double n = constant_at(exponent);
        if (n == 0.0)
            return constant(1.0);
        if (n == std::round(n) && std::abs(n) <= kLargestWholeExponent)
            return append({.operation = Operation::kWholePower, .exponent = static_cast<int>(n), .a = base});
    }
    return append({.operation = Operation::kPower, .a = base, .b = exponent});
}

ExpressionTape::Slot ExpressionTape::combine(Operation operation, Slot a, Slot b, Slot c)
{
    const bool all_constant = is_constant(a) && (operation == Operation::kNegate || is_constant(b)) &&
                              (operation != Operation::kChoose || is_constant(c));
    if (operation == Operation::kMultiply && a == b)
        return append({.operation = Operation::kWholePower, .exponent = 2, .a = a});
    const Slot slot = operation == Operation::kPower
                          ? power(a, b)
                          : append({.operation = operation, .a = a, .b = b, .c = c});
    if (!all_constant)
        return slot;
    ExpressionTape alone = *this; // numbers only: what it gives does not depend on the point
    alone.finish(slot);
    return constant(alone.value({}));
}

template <class Value>
Value ExpressionTape::result_of(const Step& step, const std::vector<Value>& results)
{
    const Value& a = results[step.a];
    const Value& b = results[step.b];
    switch (step.operation)
    {
    case Operation::kConstant:
        return constant_value<Value>(step.constant);
    case Operation::kAdd:
        return arithmetic::add(a, b);
    case Operation::kSubtract:
        return arithmetic::subtract(a, b);
    case Operation::kMultiply:
        return arithmetic::multiply(a, b);
    case Operation::kDivide:
        return arithmetic::divide(a, b);
    case Operation::kPower:
        return arithmetic::power(a, b);
    case Operation::kWholePower:
        return whole_power(a, step.exponent);
    case Operation::kNegate:
        return arithmetic::negate(a);
    case Operation::kMinimum:
        return arithmetic::minimum(a, b);
    case Operation::kMaximum:
        return arithmetic::maximum(a, b);
    case Operation::kAtan2:
        return arithmetic::angle(a, b);
    case Operation::kLess:
        return arithmetic::less(a, b);
    case Operation::kLessOrEqual:
        return arithmetic::less_or_equal(a, b);
    case Operation::kEqual:
        return arithmetic::equal(a, b);
    case Operation::kNotEqual:
        return opposite(arithmetic::equal(a, b));
    case Operation::kAnd:
        return arithmetic::both(a, b);
    case Operation::kOr:
        return opposite(arithmetic::both(is_zero(a), is_zero(b)));
    case Operation::kChoose:
        return arithmetic::choose(a, b, results[step.c]);
    case Operation::kUnary:
        return arithmetic::apply(*step.function, a);
    }
    return a;
}

template <class Value>
Value ExpressionTape::evaluate(const Value& x, const Value& y, const Value& z) const
{
    thread_local std::vector<Value> results;
    results.resize(steps_.size());
    results[0] = x;
    results[1] = y;
    results[2] = z;
    for (std::size_t i = 3; i < steps_.size(); ++i)
        results[i] = result_of(steps_[i], results);
    return results[result_];
}

double ExpressionTape::value(const Point3& p) const
{
    return evaluate(p.x, p.y, p.z);
}

Interval ExpressionTape::over(const Box3& box) const
{
    return evaluate(Interval{box.min.x, box.max.x}, Interval{box.min.y, box.max.y},
                    Interval{box.min.z, box.max.z});
}

IntervalSlope ExpressionTape::along(const Segment3& segment) const
{
    return evaluate(coordinate(segment.source.x, segment.target.x),
                    coordinate(segment.source.y, segment.target.y),
                    coordinate(segment.source.z, segment.target.z));
}

} // namespace voroprobe
