#pragma once

#include <optional>

#include "geometry/box3.h"
#include "geometry/segment3.h"

namespace voroprobe
{

//! The part of space an implicit function is looked at in, a box or a ball: Omega in the report.
class ImplicitDomain
{
public:
    //! \throw UsageError where the box is empty, flat or not finite.
    explicit ImplicitDomain(const Box3& box);

    //! \throw UsageError where the radius is not above 0 or something is not finite.
    ImplicitDomain(const Point3& center, double radius);

    [[nodiscard]] const Box3& bounding_box() const { return box_; }

    [[nodiscard]] bool contains(const Point3& p) const;

    //! Parameters of the part of a segment in the domain; nullopt where they do not meet. An end that the
    //! domain contains has its own parameter, 0 or 1; others lie on the border, but for rounding.
    [[nodiscard]] std::optional<ParameterRange> clip(const Segment3& segment) const;

    //! Whether the box lies in the domain and away from its border.
    [[nodiscard]] bool holds_within(const Box3& box) const;

    //! By how much p is beyond the border; at most 0 within the domain. Scan units.
    [[nodiscard]] double distance_beyond(const Point3& p) const;

private:
    struct Ball
    {
        Point3 center;
        double radius;
    };

    [[nodiscard]] static std::optional<ParameterRange> clip_to_ball(const Segment3& segment,
                                                                    const Ball& ball);

    Box3 box_; //!< the domain, or the box around the ball
    std::optional<Ball> ball_;
};

} // namespace voroprobe
