#include "mesher/probing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "support/error.h"
#include "support/number_text.h"

namespace voroprobe
{
namespace
{

// Finer tilings would take hours.
constexpr double kMostTiles = 1U << 28U;

constexpr std::size_t kQuestionsBetweenLooks = 1024; // for whether to stop

//! For each of `count` tiles along a side, when it is probed: those in the middle first, then those in the
//! middle of what is left on either side, and so on.
std::vector<std::size_t> middle_first(std::size_t count)
{
    std::vector<std::size_t> level(count);
    const auto assign = [&](auto&& self, std::size_t begin, std::size_t end, std::size_t depth) -> void
    {
        if (begin == end)
            return;
        const std::size_t middle = begin + (end - begin) / 2;
        level[middle] = depth;
        self(self, begin, middle, depth + 1);
        self(self, middle + 1, end, depth + 1);
    };
    assign(assign, 0, count, 0);
    return level;
}

Vec3 coordinates_along(const std::array<Vec3, 3>& axis, const Vec3& x)
{
    return {dot(axis[0], x), dot(axis[1], x), dot(axis[2], x)};
}

} // namespace

void Probing::begin(const ConvexRegion& region, const IsNews& is_news)
{
    region_ = &region;
    is_news_ = &is_news;
    box_ = thin_bounding_box(region.corners);
    half_spaces_.clear();
    for (const HalfSpace& half_space : region.half_spaces)
        half_spaces_.push_back({coordinates_along(box_.axis, half_space.normal), half_space.offset});
}

Point3 Probing::world(const Vec3& coordinates) const
{
    return region_->origin + box_.at(coordinates);
}

std::optional<Point3> Probing::query(const Vec3& from, const Vec3& to)
{
    return query({world(from), world(to)}, *is_news_);
}

bool Probing::stop_requested()
{
    stopped_ = stopped_ || stop_.stop_requested();
    return stopped_;
}

bool Probing::may_ask()
{
    if (++asked_ % kQuestionsBetweenLooks == 0)
        stop_requested();
    return !stopped_;
}

bool Probing::certify(const Box3& box)
{
    if (!may_ask())
        return true; // ends the search
    if (oracle_.may_cross(box))
        return false;
    ++counts_.boxes_certified;
    return true;
}

std::optional<Point3> Probing::query(const Segment3& segment, const IsNews& is_news)
{
    if (!may_ask())
        return std::nullopt;
    ++counts_.queries;
    oracle_.find_crossings(segment, crossings_);
    for (const Crossing& crossing : crossings_)
    {
        if (is_news(crossing.point))
            return crossing.point;
        ++counts_.hits_passed_over;
    }
    return std::nullopt;
}

//! The tiles of the smallest face of the thin box, and what of their probes lies in the region.
class Probing::Tiles
{
public:
    explicit Tiles(Probing& probing) : probing_(probing)
    {
        const Vec3 size = probing.box_.size();
        const double side = std::numbers::sqrt2 * kTileHalfDiagonal * probing.reach_;
        for (std::size_t a = 0; a < 2; ++a)
            count_[a] = std::max(std::ceil(size[a] / side), 1.0);
        if (count_[0] * count_[1] > kMostTiles)
            throw UsageError(
                "reach_lower_bound is " + number_text(probing.reach_) + "; it must be at least " +
                number_text(std::sqrt(0.5 * size.x * size.y / kMostTiles)) + " for a domain of this size");
        half_ = {0.5 * size.x / count_[0], 0.5 * size.y / count_[1], 0.0};
    }

    [[nodiscard]] std::size_t count(std::size_t axis) const { return static_cast<std::size_t>(count_[axis]); }

    //! The middle of a tile; its third coordinate is 0.
    [[nodiscard]] Vec3 middle(std::size_t i, std::size_t j) const
    {
        return {probing_.box_.low.x + (2.0 * static_cast<double>(i) + 1.0) * half_.x,
                probing_.box_.low.y + (2.0 * static_cast<double>(j) + 1.0) * half_.y, 0.0};
    }

    //! Third coordinates of the ends of the tile's probe; nullopt where the tile misses the region.
    [[nodiscard]] std::optional<ParameterRange> heights(std::size_t i, std::size_t j) const
    {
        const Vec3 center = middle(i, j);
        ParameterRange range{probing_.box_.low.z, probing_.box_.high.z};
        for (const HalfSpace& half_space : probing_.half_spaces_)
        {
            const Vec3& n = half_space.normal;
            const double room = half_space.offset - n.x * center.x - n.y * center.y +
                                std::abs(n.x) * half_.x + std::abs(n.y) * half_.y;
            if (n.z > 0.0)
                range.second = std::min(range.second, room / n.z);
            else if (n.z < 0.0)
                range.first = std::max(range.first, room / n.z);
            else if (room < 0.0)
                return std::nullopt;
        }
        if (range.first > range.second || !clip_to_ball(center, range))
            return std::nullopt;
        return range;
    }

private:
    // The ball grown by the tile.
    [[nodiscard]] bool clip_to_ball(const Vec3& center, ParameterRange& range) const
    {
        const auto& ball = probing_.region_->ball;
        if (!ball)
            return true;
        const Vec3 c = coordinates_along(probing_.box_.axis, ball->center - probing_.region_->origin);
        const double radius = ball->radius + norm(half_);
        const double squared_half_chord =
            radius * radius - (center.x - c.x) * (center.x - c.x) - (center.y - c.y) * (center.y - c.y);
        if (squared_half_chord < 0.0)
            return false;
        const double half_chord = std::sqrt(squared_half_chord);
        range.first = std::max(range.first, c.z - half_chord);
        range.second = std::min(range.second, c.z + half_chord);
        return range.first <= range.second;
    }

    Probing& probing_;
    std::array<double, 2> count_{};
    Vec3 half_; //!< sides of a tile
};

std::optional<Point3> Probing::probe_all(const ConvexRegion& region, const IsNews& is_news)
{
    begin(region, is_news);
    const Tiles tiles(*this);
    const auto level_u = middle_first(tiles.count(0));
    const auto level_v = middle_first(tiles.count(1));
    const std::size_t last_level = std::max(*std::max_element(level_u.begin(), level_u.end()),
                                            *std::max_element(level_v.begin(), level_v.end()));
    const auto at_height = [](Vec3 c, double height)
    {
        c.z = height;
        return c;
    };
    for (std::size_t level = 0; level <= last_level; ++level)
    {
        for (std::size_t j = 0; j < tiles.count(1); ++j)
        {
            for (std::size_t i = 0; i < tiles.count(0); ++i)
            {
                if (std::max(level_u[i], level_v[j]) != level)
                    continue;
                const auto range = tiles.heights(i, j);
                if (!range)
                    continue;
                const Vec3 middle = tiles.middle(i, j);
                if (const auto news =
                        query(at_height(middle, range->first), at_height(middle, range->second)))
                    return news;
            }
        }
    }

    // Across each row at a height that all its probes reach, or in several parts where there is none.
    const Vec3 hub = coordinates_along(box_.axis, region.hub);
    for (std::size_t j = 0; j < tiles.count(1); ++j)
    {
        std::optional<std::size_t> first;
        ParameterRange common{};
        const auto connect = [&](std::size_t last) -> std::optional<Point3>
        {
            const double height = 0.5 * (common.first + common.second);
            const Vec3 from = at_height(tiles.middle(*first, j), height);
            const Vec3 to = at_height(tiles.middle(last, j), height);
            if (*first != last)
            {
                if (const auto news = query(from, to))
                    return news;
            }
            return query(norm(hub - from) < norm(hub - to) ? from : to, hub);
        };
        for (std::size_t i = 0; i < tiles.count(0); ++i)
        {
            const auto range = tiles.heights(i, j);
            if (first && range && range->first <= common.second && common.first <= range->second)
            {
                common = {std::max(common.first, range->first), std::min(common.second, range->second)};
                continue;
            }
            if (first)
            {
                if (const auto news = connect(i - 1))
                    return news;
            }
            first = range ? std::optional(i) : std::nullopt;
            common = range.value_or(ParameterRange{});
        }
        if (first)
        {
            if (const auto news = connect(tiles.count(0) - 1))
                return news;
        }
    }
    return std::nullopt;
}

} // namespace voroprobe
