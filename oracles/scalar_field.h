#pragma once

#include "geometry/box3.h"
#include "geometry/segment3.h"

namespace voroprobe
{

//! A function of space whose zero set is a surface, and what is certain of it between its values. Inside:
//! value >= 0. All members may be called from several threads at once.
class ScalarField
{
public:
    virtual ~ScalarField() = default;

    //! NaN counts as outside; a field may throw instead.
    [[nodiscard]] virtual double value(const Point3& p) const = 0;

    //! The values at the ends of a segment.
    struct EndValues
    {
        double source;
        double target;
    };

    //! True only where it is certain that the function changes side at most once along the segment, so that
    //! the sides of its ends tell all.
    [[nodiscard]] virtual bool ends_tell_all(const Segment3& segment, const EndValues& values) const = 0;

    //! What is certain of the side of a whole box.
    enum class BoxSide
    {
        kInside,
        kOutside,
        kUnknown
    };
    [[nodiscard]] virtual BoxSide side_of(const Box3& box) const = 0;
};

} // namespace voroprobe
