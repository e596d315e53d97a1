#include "labels/part_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "support/check.h"
#include "support/error.h"
#include "support/number_text.h"
#include "volume/cell_topology.h"

namespace voroprobe
{
namespace
{

//! Heights far inside and far outside, as smoothing gives them.
constexpr float kFar = 0.5F;

//! Samples are numbered by 32 bits.
constexpr std::size_t kMostSamples = std::numeric_limits<std::uint32_t>::max();

//! No sample near the surface is nearer to 0 than this: a feature that hangs on one sample is then about a
//! third of a voxel wide, well above the floor of refinement.
constexpr double kLeastHeight = 0.1;

//! No sample is farther outside: smoothing gives no more, and what is lifted for it stays within bounds.
constexpr double kMostDepth = 0.5;

//! A sample between two of the other side along an axis is at least so far from 0, in heights of theirs:
//! walls and gaps of one voxel are then meshed half a voxel wide or wider, also where they are one voxel
//! long.
constexpr float kLeastShareOfThin = 1.0F / 3.0F;

//! Corners inside must stay joined if all corners outside were so many times farther from 0: where parts of a
//! label touch at edges or corners of voxels, the neck between them is then about half a voxel wide.
constexpr double kNeckMargin = 1.4;

//! Heights are changed for a neck by this factor at a time.
constexpr double kNeckStep = 1.2;

//! Of `voxels joined by edges of the grid cell`: corner -> the lowest corner of its piece.
CornerParts joined_by_edges(const CellCorners& corners)
{
    CornerParts part{0, 1, 2, 3, 4, 5, 6, 7};
    for (bool changed = true; std::exchange(changed, false);)
        for (const auto& [a, b] : cell_edges())
            if ((corners[a] >= 0.0) == (corners[b] >= 0.0) && part[a] != part[b])
            {
                part[a] = part[b] = std::min(part[a], part[b]);
                changed = true;
            }
    return part;
}

//! Whether all corners inside are joined, and corners outside by edges alone.
bool joins_as_voxels(const CellCorners& corners, const CornerParts& by_edges)
{
    const CornerParts joined = connect_corners(corners).in_cell;
    for (std::size_t a = 0; a < corners.size(); ++a)
        for (std::size_t b = a + 1; b < corners.size(); ++b)
        {
            const bool a_inside = corners[a] >= 0.0;
            const bool wanted = a_inside || by_edges[a] == by_edges[b];
            if (a_inside == (corners[b] >= 0.0) && (joined[a] == joined[b]) != wanted)
                return false;
        }
    return true;
}

CellCorners with_outside_scaled(CellCorners corners, double factor)
{
    for (double& height : corners)
        height *= height < 0.0 ? factor : 1.0;
    return corners;
}

//! Corners inside at least `least` from 0, corners outside at most `most`.
CellCorners bounded(CellCorners corners, double least, double most)
{
    for (double& height : corners)
        height = height < 0.0 ? std::max(height, -most) : std::max(height, least);
    return corners;
}

//! The heights, changed by the rule until it joins corners as voxels are joined.
CellCorners joined_as_voxels(const CellCorners& corners, NeckRule rule)
{
    // Where all corners inside are three times as far from 0 as those outside, any two of them are joined.
    constexpr double kSurelyJoined = 4.0;
    const CornerParts by_edges = joined_by_edges(corners);
    double outside = 0.0;
    double inside = std::numeric_limits<double>::infinity();
    for (const double height : corners)
        if (height < 0.0)
            outside = std::max(outside, -height);
        else
            inside = std::min(inside, height);
    CellCorners changed = corners;
    while (!joins_as_voxels(with_outside_scaled(changed, kNeckMargin), by_edges))
    {
        CHECK_LE(inside, kSurelyJoined * kNeckMargin * outside);
        if (rule == NeckRule::kRaiseOutside)
            outside /= kNeckStep;
        else
            inside *= kNeckStep;
        changed = bounded(corners, inside, outside);
    }
    return changed;
}

//! The share of a grid cell with heights >= 0: exact along z, midpoints across it.
double share_inside(const CellCorners& h)
{
    constexpr int kColumns = 4; // along x and along y
    double share = 0.0;
    for (int j = 0; j < kColumns; ++j)
        for (int i = 0; i < kColumns; ++i)
        {
            const double x = (i + 0.5) / kColumns;
            const double y = (j + 0.5) / kColumns;
            const double low = lerp(lerp(h[0], h[1], x), lerp(h[2], h[3], x), y);
            const double high = lerp(lerp(h[4], h[5], x), lerp(h[6], h[7], x), y);
            if ((low >= 0.0) == (high >= 0.0))
                share += low >= 0.0 ? 1.0 : 0.0;
            else
                share += std::max(low, high) / std::abs(high - low);
        }
    return share / (kColumns * kColumns);
}

//! The search for the shift at which a part has the volume wanted, which grows with the shift.
class ShiftSearch
{
public:
    //! The volume at shift `shift`; returns the next shift to try.
    double next(double shift, double volume, double wanted)
    {
        if (shift != last_shift_ && (volume > last_volume_) == (shift > last_shift_) &&
            volume != last_volume_)
            slope_ = (volume - last_volume_) / (shift - last_shift_);
        last_shift_ = shift;
        last_volume_ = volume;
        (volume < wanted ? lowest_ : highest_) = shift;
        const double guess = slope_ > 0.0 ? shift + (wanted - volume) / slope_
                                          : shift + (volume < wanted ? 1 : -1) * kFirstStep;
        return guess > lowest_ && guess < highest_ ? guess : 0.5 * (lowest_ + highest_);
    }

private:
    static constexpr double kFirstStep = 0.05;
    //! Shifts beyond these change nothing: all heights but those put right would be of one sign.
    static constexpr double kMostShift = 1.0;

    double lowest_ = -kMostShift;
    double highest_ = kMostShift;
    double last_shift_ = std::numeric_limits<double>::quiet_NaN();
    double last_volume_ = 0.0;
    double slope_ = 0.0;
};

} // namespace

PartField::PartField(PartMask mask, const Vec3& spacing, std::span<const float> smoothed)
    : mask_(std::move(mask)), spacing_(spacing), whole_cells_(mask_.part_count, 0),
      shifts_(mask_.part_count, 0.0), volumes_(mask_.part_count, 0.0)
{
    CHECK(smoothed.size() == mask_.part.size());
    if (mask_.part.size() > kMostSamples)
        throw InputError("a label reaches over " + count_text(mask_.part.size()) + " samples, allowed are " +
                         count_text(kMostSamples));
    for (std::size_t c = 0; c < corner_offset_.size(); ++c)
        corner_offset_[c] = (c & 1U) + mask_.size[0] * ((c >> 1U & 1U) + mask_.size[1] * (c >> 2U & 1U));
    heights_.resize(mask_.part.size());
    std::transform(mask_.part.begin(), mask_.part.end(), heights_.begin(),
                   [](std::uint32_t part) { return part != 0 ? kFar : -kFar; });
    find_mixed_cells();
    find_band(smoothed);
    count_restored(smoothed);
    apply_shifts();
    measure();
}

void PartField::find_mixed_cells()
{
    const auto [columns, rows, slices] = mask_.size;
    for (std::size_t k = 0; k + 1 < slices; ++k)
        for (std::size_t j = 0; j + 1 < rows; ++j)
            for (std::size_t i = 0; i + 1 < columns; ++i)
            {
                const std::size_t first = i + columns * (j + rows * k);
                unsigned int code = 0;
                std::uint32_t part = 0;
                for (std::size_t c = 0; c < 8; ++c)
                    if (const std::uint32_t own = mask_.part[first + corner_offset_[c]]; own != 0)
                    {
                        code |= 1U << c;
                        part = own; // the same for all: corners of a grid cell are neighbours
                    }
                if (code == 0)
                    continue;
                if (code == 0xFF)
                    ++whole_cells_[part - 1];
                else
                    mixed_cells_.push_back({static_cast<std::uint32_t>(first), part - 1,
                                            topology_of(static_cast<CornerCode>(code)).simple});
            }
}

void PartField::find_band(std::span<const float> smoothed)
{
    std::vector<std::uint32_t> samples;
    samples.reserve(mixed_cells_.size() * corner_offset_.size());
    for (const MixedCell& cell : mixed_cells_)
        for (std::size_t c = 0; c < corner_offset_.size(); ++c)
            samples.push_back(static_cast<std::uint32_t>(corner(cell, c)));
    std::sort(samples.begin(), samples.end());
    samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
    band_.reserve(samples.size());
    for (const std::uint32_t sample : samples)
        band_.push_back({sample, smoothed[sample]});
}

void PartField::count_restored(std::span<const float> smoothed)
{
    std::vector<bool> left(mask_.part_count, false);
    for (std::size_t i = 0; i < mask_.part.size(); ++i)
        if (mask_.part[i] != 0 && smoothed[i] > 0.0F)
            left[mask_.part[i] - 1] = true;
    parts_restored_ = static_cast<std::size_t>(std::count(left.begin(), left.end(), false));
}

void PartField::shift_outside_samples()
{
    // A sample outside may have several parts for neighbours: the largest shift counts, lest a small part go
    // short. Until all are known, the sum of height and shift stands in heights_.
    for (const BandSample& band : band_)
        if (mask_.part[band.sample] == 0)
            heights_[band.sample] = -std::numeric_limits<float>::infinity();
    for (const MixedCell& cell : mixed_cells_)
        for (std::size_t c = 0; c < corner_offset_.size(); ++c)
            if (const std::size_t sample = corner(cell, c); mask_.part[sample] == 0)
                heights_[sample] = std::max(heights_[sample], static_cast<float>(shifts_[cell.part]));
}

void PartField::apply_shifts()
{
    shift_outside_samples();
    for (const BandSample& band : band_)
    {
        const std::uint32_t part = mask_.part[band.sample];
        float& height = heights_[band.sample];
        const double shift = part != 0 ? shifts_[part - 1] : static_cast<double>(height);
        const double shifted = static_cast<double>(band.smoothed) + shift;
        height = static_cast<float>(part != 0 ? std::max(shifted, kLeastHeight)
                                              : std::clamp(shifted, -kMostDepth, -kLeastHeight));
    }
    thicken_thin_samples();
    join_as_voxels();
}

void PartField::thicken_thin_samples()
{
    const std::array<std::size_t, 3> stride{1, mask_.size[0], mask_.size[0] * mask_.size[1]};
    for (const BandSample& band : band_)
    {
        float& height = heights_[band.sample];
        for (const std::size_t step : stride)
        {
            if (band.sample < step || band.sample + step >= heights_.size())
                continue; // the margin
            const float before = heights_[band.sample - step];
            const float after = heights_[band.sample + step];
            if ((before > 0.0F) != (height > 0.0F) && (after > 0.0F) != (height > 0.0F))
                height =
                    std::copysign(std::max(std::abs(height),
                                           kLeastShareOfThin * std::max(std::abs(before), std::abs(after))),
                                  height);
        }
    }
}

//! Moving heights up can only join samples inside and part samples outside, so that one pass settles all.
void PartField::join_as_voxels()
{
    for (const MixedCell& cell : mixed_cells_)
    {
        if (cell.simple)
            continue;
        CellCorners corners{};
        for (std::size_t c = 0; c < corners.size(); ++c)
            corners[c] = static_cast<double>(heights_[corner(cell, c)]);
        const CellCorners joined = joined_as_voxels(corners, neck_rule_);
        for (std::size_t c = 0; c < corners.size(); ++c)
            heights_[corner(cell, c)] = static_cast<float>(joined[c]);
    }
}

void PartField::measure()
{
    for (std::size_t part = 0; part < volumes_.size(); ++part)
        volumes_[part] = static_cast<double>(whole_cells_[part]);
    for (const MixedCell& cell : mixed_cells_)
    {
        CellCorners corners{};
        for (std::size_t c = 0; c < corners.size(); ++c)
            corners[c] = static_cast<double>(heights_[corner(cell, c)]);
        volumes_[cell.part] += share_inside(corners);
    }
    for (double& volume : volumes_)
        volume *= spacing_.x * spacing_.y * spacing_.z;
}

void PartField::set_neck_rule(NeckRule rule)
{
    neck_rule_ = rule;
    apply_shifts();
    measure();
}

void PartField::fit_volumes(std::span<const double> wanted)
{
    constexpr int kMostSteps = 12;
    constexpr double kCloseEnough = 0.001; // of the volume: that of the measure
    CHECK(wanted.size() == part_count());
    std::vector<ShiftSearch> searches(part_count());
    for (int step = 0; step < kMostSteps; ++step)
    {
        bool close = true;
        for (std::size_t part = 0; part < part_count(); ++part)
        {
            if (std::abs(volumes_[part] - wanted[part]) <= kCloseEnough * wanted[part])
                continue;
            close = false;
            shifts_[part] = searches[part].next(shifts_[part], volumes_[part], wanted[part]);
        }
        if (close)
            return;
        apply_shifts();
        measure();
    }
}

Volume PartField::volume() const
{
    return make_volume({.size = mask_.size, .spacing = spacing_, .direction = {}, .origin = {}}, heights_);
}

} // namespace voroprobe
