#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracles/trilinear_oracle.h"

namespace voroprobe
{

//! The field whose zero set is the surface: positive inside, negative outside, at no sample zero (see
//! TieBreaker).
struct Level
{
    double isovalue;
    double sign; //!< +1 where the object lies above the isovalue, -1 where below

    [[nodiscard]] double operator()(double sample) const { return sign * (sample - isovalue); }
};

//! Chooses an isovalue that no sample has. Where samples equal the wanted one, it is moved to the outer side
//! of all of them by a fraction of the smallest difference of any other sample: every tie falls inside, the
//! surface moves by less than that fraction of a grid edge, and it is the exact isosurface of one isovalue
//! everywhere.
class TieBreaker
{
public:
    explicit TieBreaker(double isovalue) : isovalue_(isovalue) {}

    void include(double sample)
    {
        const double difference = std::abs(sample - isovalue_);
        tie_ = tie_ || difference == 0.0;
        smallest_ = difference > 0.0 && difference < smallest_ ? difference : smallest_;
    }

    [[nodiscard]] Level level(InsideIs inside) const
    {
        const double sign = inside == InsideIs::kAbove ? 1.0 : -1.0;
        if (!tie_)
            return {isovalue_, sign};
        const double others = std::isfinite(smallest_) ? smallest_ : std::max(1.0, std::abs(isovalue_));
        return {isovalue_ - sign * kNudge * others, sign};
    }

private:
    //! A millionth: out of sight, and still far above the rounding of an interpolation between samples of 16
    //! bits.
    static constexpr double kNudge = 0x1.0p-20;

    double isovalue_;
    bool tie_ = false;
    double smallest_ = std::numeric_limits<double>::infinity(); //!< difference that is not 0
};

} // namespace voroprobe
