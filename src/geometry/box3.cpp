#include "geometry/box3.h"

namespace voroprobe
{

std::optional<ParameterRange> clip_to_box(const Segment3& segment, const Box3& box)
{
    ParameterRange range{0.0, 1.0};
    const Vec3 direction = segment.target - segment.source;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const double from = segment.source[axis];
        const double along = direction[axis];
        if (along == 0.0)
        {
            if (from < box.min[axis] || from > box.max[axis])
                return std::nullopt;
            continue;
        }
        const double t_min = (box.min[axis] - from) / along;
        const double t_max = (box.max[axis] - from) / along;
        range.first = std::max(range.first, std::min(t_min, t_max));
        range.second = std::min(range.second, std::max(t_min, t_max));
    }
    if (range.first > range.second)
        return std::nullopt;
    return range;
}

} // namespace voroprobe
