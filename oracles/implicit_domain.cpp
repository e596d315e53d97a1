#include "oracles/implicit_domain.h"

#include <algorithm>
#include <cmath>

#include "support/error.h"

namespace voroprobe
{

ImplicitDomain::ImplicitDomain(const Box3& box) : box_(box)
{
    if (!is_finite(box.min) || !is_finite(box.max) ||
        !(box.min.x < box.max.x && box.min.y < box.max.y && box.min.z < box.max.z))
        throw UsageError("the domain is empty, flat or not finite; it must be a box with a volume");
}

ImplicitDomain::ImplicitDomain(const Point3& center, double radius) : ball_(Ball{center, radius})
{
    if (!is_finite(center) || !std::isfinite(radius) || !(radius > 0.0))
        throw UsageError("the domain is a ball whose radius is not above 0 or not finite; it must be a ball "
                         "with a volume");
    box_ = Box3{center, center}.expanded(radius);
}

bool ImplicitDomain::contains(const Point3& p) const
{
    if (ball_)
        return squared_distance(p, ball_->center) <= ball_->radius * ball_->radius;
    return box_.contains(p);
}

std::optional<ParameterRange> ImplicitDomain::clip(const Segment3& segment) const
{
    if (!ball_)
        return clip_to_box(segment, box_);
    const bool source_within = contains(segment.source);
    const bool target_within = contains(segment.target);
    if (source_within && target_within)
        return ParameterRange{0.0, 1.0};
    auto range = clip_to_ball(segment, *ball_);
    if (!range && (source_within || target_within)) // the end is on the border, the rest beyond it
        range = source_within ? ParameterRange{0.0, 0.0} : ParameterRange{1.0, 1.0};
    if (range && source_within)
        range->first = 0.0;
    if (range && target_within)
        range->second = 1.0;
    return range;
}

std::optional<ParameterRange> ImplicitDomain::clip_to_ball(const Segment3& segment, const Ball& ball)
{
    const Vec3 along = segment.target - segment.source;
    const double squared_length = squared_norm(along);
    if (!(squared_length > 0.0))
        return std::nullopt;
    const double nearest = dot(ball.center - segment.source, along) / squared_length;
    const double squared_half_chord =
        ball.radius * ball.radius - squared_distance(segment.at(nearest), ball.center);
    if (!(squared_half_chord >= 0.0))
        return std::nullopt;
    const double half = std::sqrt(squared_half_chord / squared_length);
    const ParameterRange range{std::max(nearest - half, 0.0), std::min(nearest + half, 1.0)};
    return range.first <= range.second ? std::optional(range) : std::nullopt;
}

bool ImplicitDomain::holds_within(const Box3& box) const
{
    if (!ball_)
        return box.min.x > box_.min.x && box.min.y > box_.min.y && box.min.z > box_.min.z &&
               box.max.x < box_.max.x && box.max.y < box_.max.y && box.max.z < box_.max.z;
    Vec3 farthest;
    for (std::size_t axis = 0; axis < 3; ++axis)
        farthest[axis] = std::max(std::abs(box.min[axis] - ball_->center[axis]),
                                  std::abs(box.max[axis] - ball_->center[axis]));
    return norm(farthest) < ball_->radius;
}

double ImplicitDomain::distance_beyond(const Point3& p) const
{
    if (ball_)
        return distance(p, ball_->center) - ball_->radius;
    double beyond = box_.min.x - p.x;
    for (std::size_t axis = 0; axis < 3; ++axis)
        beyond = std::max({beyond, box_.min[axis] - p[axis], p[axis] - box_.max[axis]});
    return beyond;
}

} // namespace voroprobe
