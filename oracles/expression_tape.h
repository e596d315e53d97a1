#pragma once

#include <cstdint>
#include <vector>

#include "geometry/box3.h"
#include "geometry/segment3.h"
#include "oracles/interval.h"

namespace voroprobe
{

//! A function of one variable that formulas may name, with what interval evaluation needs.
struct UnaryFunction
{
    const char* name;
    double (*of_number)(double);
    Interval (*of_interval)(const Interval&);
    Interval (*derivative)(const Interval&); //!< holds f' all over the interval; everything() at jumps
};

//! A value along a segment and how it changes with the segment's parameter.
struct IntervalSlope
{
    Interval value;
    Interval slope;
};

//! A formula in x, y and z as a list of operations, each on the results of earlier ones. It is evaluated for
//! numbers and for intervals alike; both branches of a choice are computed. Immutable while it is evaluated,
//! so from any number of threads.
class ExpressionTape
{
public:
    //! The place of a result on the tape; 0, 1 and 2 are x, y and z.
    using Slot = std::uint32_t;

    enum class Operation : std::uint8_t
    {
        kConstant,
        kAdd,
        kSubtract,
        kMultiply,
        kDivide,
        kPower,
        kWholePower, //!< exponent known and whole: `exponent`
        kNegate,
        kMinimum,
        kMaximum,
        kAtan2,
        kLess,
        kLessOrEqual,
        kEqual,
        kNotEqual,
        kAnd,
        kOr,
        kChoose, //!< third where the first is not 0, otherwise the second
        kUnary
    };

    ExpressionTape();

    Slot constant(double value);
    Slot unary(const UnaryFunction& function, Slot a);
    Slot combine(Operation operation, Slot a, Slot b = 0, Slot c = 0);

    //! The operation's value is the formula's. \pre It exists.
    void finish(Slot result) { result_ = result; }

    [[nodiscard]] double value(const Point3& p) const;

    //! Holds all values over the box.
    [[nodiscard]] Interval over(const Box3& box) const;

    //! Holds all values along the segment, and all derivatives with respect to its parameter.
    [[nodiscard]] IntervalSlope along(const Segment3& segment) const;

private:
    struct Step
    {
        Operation operation;
        int exponent = 0;
        Slot a = 0;
        Slot b = 0;
        Slot c = 0;
        double constant = 0.0;
        const UnaryFunction* function = nullptr;
    };

    Slot append(const Step& step);
    [[nodiscard]] bool is_constant(Slot slot) const;
    [[nodiscard]] double constant_at(Slot slot) const { return steps_[slot].constant; }
    [[nodiscard]] Slot power(Slot base, Slot exponent);

    template <class Value>
    [[nodiscard]] static Value result_of(const Step& step, const std::vector<Value>& results);
    template <class Value>
    [[nodiscard]] Value evaluate(const Value& x, const Value& y, const Value& z) const;

    std::vector<Step> steps_; //!< the first three stand for x, y and z
    Slot result_ = 0;
};

} // namespace voroprobe
