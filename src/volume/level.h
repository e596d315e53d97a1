#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace voroprobe
{

//! Which side of the isovalue is the object.
enum class InsideIs
{
    kAbove, //!< inside: sample >= isovalue (CT, labels, fog volumes)
    kBelow  //!< inside: sample <= isovalue (signed distances)
};

//! The field whose zero set is the surface: positive inside, negative outside, zero at no sample (see
//! LevelSurvey).
struct Level
{
    double isovalue;
    double sign; //!< +1 where the object lies above the isovalue, -1 where below

    [[nodiscard]] double operator()(double sample) const { return sign * (sample - isovalue); }
};

//! Sees every sample once, then tells how to read them as a field.
class LevelSurvey
{
public:
    LevelSurvey(double isovalue, InsideIs inside)
        : isovalue_(isovalue), sign_(inside == InsideIs::kAbove ? 1.0 : -1.0)
    {
    }

    void include(double sample)
    {
        if (!std::isfinite(sample))
        {
            ++not_finite_;
            return;
        }
        const double height = sign_ * (sample - isovalue_);
        tie_ = tie_ || height == 0.0;
        lowest_ = std::min(lowest_, height);
        farthest_ = std::max(farthest_, std::abs(height));
        if (height != 0.0)
            smallest_ = std::min(smallest_, std::abs(height));
    }

    //! Its isovalue is one that no sample has. Where samples equal the wanted one, it is moved to the outer
    //! side of all of them by a fraction of the smallest difference of any other sample: every tie falls
    //! inside, the surface moves by less than that fraction of a grid edge, and it is still the exact
    //! isosurface of one isovalue.
    [[nodiscard]] Level level() const
    {
        const double others = std::isfinite(smallest_) ? smallest_ : unit();
        return {tie_ ? isovalue_ - sign_ * kNudge * others : isovalue_, sign_};
    }

    //! A value to put in place of samples that are not finite: that of the sample farthest outside, or one
    //! farther out where no sample is outside.
    [[nodiscard]] double outside() const { return isovalue_ + sign_ * (lowest_ < 0.0 ? lowest_ : -unit()); }

    [[nodiscard]] std::size_t not_finite() const { return not_finite_; }

    //! The largest difference of a sample from the isovalue.
    [[nodiscard]] double farthest() const { return farthest_; }

private:
    //! Small enough not to be seen (the surface moves by at most this fraction of a grid edge), large enough
    //! that what hangs on ties alone, such as a speck of one sample that equals the isovalue, can be meshed
    //! and survives the rounding to 32-bit floats of an STL file. No fraction of small whole numbers, which
    //! would put saddles of whole samples on the surface again.
    static constexpr double kNudge = 0.0037;

    //! A difference that shows beside the isovalue, where the samples give none.
    [[nodiscard]] double unit() const { return std::max(1.0, std::abs(isovalue_)); }

    double isovalue_;
    double sign_;
    bool tie_ = false;
    double lowest_ = 0.0;
    double farthest_ = 0.0;
    double smallest_ = std::numeric_limits<double>::infinity(); //!< distance from the isovalue that is not 0
    std::size_t not_finite_ = 0;
};

} // namespace voroprobe
