#include "labels/label_partition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "support/error.h"

namespace voroprobe
{
namespace
{

//! Samples without a label around those of the volume: the reach of the kernel, and one more.
constexpr int kPadding = 4;

//! Samples along the side of a block.
constexpr int kBlock = 4;

//! A stored weight of 1.
constexpr double kUnitWeight = 32.0;

//! The sum a voxel's own label must have at its center, in sums of the next: enough to be seen.
constexpr double kClearMajority = 1.3;

//! Each round may leave voxels to the next whose neighbours have got stronger.
constexpr int kStrengtheningRounds = 4;

constexpr int kBalancingRounds = 6;
constexpr double kEvenEnough = 0.05;

//! Step along segments, in shortest sides of a voxel.
constexpr double kStepInVoxels = 0.3;

//! A change of label is located to this share of a step.
constexpr int kHalvings = 24;

//! Weights of the four samples around a point, t beyond the second of them, in [0, 1).
std::array<double, 4> cubic_b_spline(double t)
{
    const double s = 1.0 - t;
    return {s * s * s / 6.0, (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0,
            (4.0 - 6.0 * s * s + 3.0 * s * s * s) / 6.0, t * t * t / 6.0};
}

} // namespace

struct LabelPartition::Ballot
{
    static constexpr std::size_t kMostLabels = 64;

    std::array<PartitionLabel, kMostLabels> label;
    std::array<double, kMostLabels> sum;
    std::size_t count = 0;

    void add(PartitionLabel voted, double weight)
    {
        for (std::size_t i = 0; i < count; ++i)
            if (label[i] == voted)
            {
                sum[i] += weight;
                return;
            }
        label[count] = voted;
        sum[count++] = weight;
    }

    //! The smaller label of two that are equal.
    [[nodiscard]] PartitionLabel winner() const
    {
        std::size_t best = 0;
        for (std::size_t i = 1; i < count; ++i)
            if (sum[i] > sum[best] || (sum[i] == sum[best] && label[i] < label[best]))
                best = i;
        return label[best];
    }

    //! What `own` has, and the most that another label has.
    [[nodiscard]] std::pair<double, double> against_others(PartitionLabel own) const
    {
        std::pair<double, double> sums{0.0, 0.0};
        for (std::size_t i = 0; i < count; ++i)
            (label[i] == own ? sums.first : sums.second) =
                label[i] == own ? sum[i] : std::max(sums.second, sum[i]);
        return sums;
    }
};

LabelPartition::LabelPartition(const LabelSurvey& survey, std::span<const std::uint32_t> labels,
                               const Vec3& spacing)
    : spacing_(spacing)
{
    std::size_t samples = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        size_[axis] = survey.size()[axis] + 2 * kPadding;
        block_count_[axis] = (size_[axis] + kBlock - 1) / kBlock;
        samples *= static_cast<std::size_t>(size_[axis]);
    }
    labels_.resize(samples, 0);
    weights_.resize(samples, static_cast<std::uint8_t>(kUnitWeight));
    fill_samples(survey, labels);
    find_mixed_blocks();
    strengthen_overruled();
}

void LabelPartition::fill_samples(const LabelSurvey& survey, std::span<const std::uint32_t> labels)
{
    std::vector<bool> wanted(survey.labels().size(), false);
    for (const std::uint32_t place : labels)
        wanted[place] = true;
    for (int k = 0; k < survey.size()[2]; ++k)
        for (int j = 0; j < survey.size()[1]; ++j)
            for (const LabelRun& run : survey.row(j, k))
                if (const std::uint32_t place = survey.parts()[run.part].label; wanted[place])
                    std::fill_n(labels_.begin() + static_cast<std::ptrdiff_t>(
                                                      at(run.first + kPadding, j + kPadding, k + kPadding)),
                                run.end - run.first, place + 1);
}

std::size_t LabelPartition::at(int i, int j, int k) const
{
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(size_[0]) *
               (static_cast<std::size_t>(j) +
                static_cast<std::size_t>(size_[1]) * static_cast<std::size_t>(k));
}

//! A point belongs to the block of the first of the four samples that the kernel meets along each axis: those
//! of a block meet the samples of it and three more.
void LabelPartition::find_mixed_blocks()
{
    constexpr int kReach = kBlock + 3;
    block_mixed_.assign(static_cast<std::size_t>(block_count_[0]) *
                            static_cast<std::size_t>(block_count_[1]) *
                            static_cast<std::size_t>(block_count_[2]),
                        false);
    std::size_t block = 0;
    const auto is_mixed = [&](int x, int y, int z)
    {
        const PartitionLabel first = labels_[at(x, y, z)];
        for (int k = z; k < std::min(z + kReach, size_[2]); ++k)
            for (int j = y; j < std::min(y + kReach, size_[1]); ++j)
                for (int i = x; i < std::min(x + kReach, size_[0]); ++i)
                    if (labels_[at(i, j, k)] != first)
                        return true;
        return false;
    };
    for (int z = 0; z < size_[2]; z += kBlock)
        for (int y = 0; y < size_[1]; y += kBlock)
            for (int x = 0; x < size_[0]; x += kBlock, ++block)
                block_mixed_[block] = is_mixed(x, y, z);
}

bool LabelPartition::is_block_mixed(const SampleIndex& block) const
{
    const auto place = static_cast<std::size_t>(block[0]) +
                       static_cast<std::size_t>(block_count_[0]) *
                           (static_cast<std::size_t>(block[1]) +
                            static_cast<std::size_t>(block_count_[1]) * static_cast<std::size_t>(block[2]));
    return block_mixed_[place];
}

//! Coordinates in samples of the padded array.
Point3 LabelPartition::to_padded(const Point3& p) const
{
    return {p.x / spacing_.x + kPadding, p.y / spacing_.y + kPadding, p.z / spacing_.z + kPadding};
}

Box3 LabelPartition::domain() const
{
    constexpr int kMargin = 2;
    const auto last = [&](std::size_t axis) { return size_[axis] - 2 * kPadding - 1 + kMargin; };
    return {{-kMargin * spacing_.x, -kMargin * spacing_.y, -kMargin * spacing_.z},
            {spacing_.x * last(0), spacing_.y * last(1), spacing_.z * last(2)}};
}

LabelPartition::Ballot LabelPartition::ballot(const Point3& p_padded) const
{
    std::array<std::array<double, 4>, 3> weight;
    SampleIndex first{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const double floor = std::floor(p_padded[axis]);
        weight[axis] = cubic_b_spline(p_padded[axis] - floor);
        first[axis] = static_cast<int>(floor) - 1;
    }
    Ballot ballot;
    for (int k = 0; k < 4; ++k)
        for (int j = 0; j < 4; ++j)
        {
            const double across =
                weight[1][static_cast<std::size_t>(j)] * weight[2][static_cast<std::size_t>(k)];
            std::size_t sample = at(first[0], first[1] + j, first[2] + k);
            for (std::size_t i = 0; i < 4; ++i, ++sample)
                ballot.add(labels_[sample], across * weight[0][i] * weights_[sample]);
        }
    return ballot;
}

PartitionLabel LabelPartition::label(const Point3& p) const
{
    const Point3 q = to_padded(p);
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (!(q[axis] >= 2.0 && q[axis] < size_[axis] - 3))
            return 0; // where the kernel meets padding alone
    SampleIndex first{};
    SampleIndex block{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        first[axis] = static_cast<int>(q[axis]) - 1;
        block[axis] = first[axis] / kBlock;
    }
    return is_block_mixed(block) ? ballot(q).winner() : labels_[at(first[0], first[1], first[2])];
}

void LabelPartition::strengthen_overruled()
{
    std::vector<std::size_t> overruled;
    for (int round = 0; round <= kStrengtheningRounds; ++round)
    {
        overruled.clear();
        std::vector<std::pair<std::size_t, std::uint8_t>> stronger;
        for (int k = kPadding; k < size_[2] - kPadding; ++k)
            for (int j = kPadding; j < size_[1] - kPadding; ++j)
                for (int i = kPadding; i < size_[0] - kPadding; ++i)
                {
                    const std::size_t sample = at(i, j, k);
                    if (labels_[sample] == 0 ||
                        !is_block_mixed({(i - 1) / kBlock, (j - 1) / kBlock, (k - 1) / kBlock}))
                        continue;
                    const auto [own, other] =
                        ballot({static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)})
                            .against_others(labels_[sample]);
                    if (own >= kClearMajority * other)
                        continue;
                    if (own <= other)
                        overruled.push_back(sample);
                    constexpr double kOwnShare = 8.0 / 27.0; // of the B-spline, at its center
                    const double wanted = weights_[sample] + (kClearMajority * other - own) / kOwnShare;
                    stronger.emplace_back(sample, static_cast<std::uint8_t>(std::ceil(
                                                      std::min(wanted, kMostWeight * kUnitWeight))));
                }
        if (round < kStrengtheningRounds)
            for (const auto& [sample, weight] : stronger)
                weights_[sample] = weight;
    }
    voxels_overruled_ = overruled.size();
}

void LabelPartition::balance(const LabelSurvey& survey, std::vector<std::uint32_t> parts)
{
    for (int round = 0; round < kBalancingRounds && !parts.empty(); ++round)
    {
        std::vector<std::pair<std::uint32_t, double>> uneven;
        for (const std::uint32_t part : parts)
            if (const double share = share_of_volume(survey, part); std::abs(share - 1.0) > kEvenEnough)
                uneven.emplace_back(part, share);
        parts.clear();
        for (const auto& [part, share] : uneven)
        {
            scale_weights(survey, part, std::clamp(1.0 / std::sqrt(share), 0.7, 1.4));
            parts.push_back(part);
        }
    }
}

//! Of the volume of its voxels, by points in these and those next to them.
double LabelPartition::share_of_volume(const LabelSurvey& survey, std::uint32_t place) const
{
    const LabelPart& part = survey.parts()[place];
    const auto is_near = [&](int i, int j, int k)
    {
        for (int z = k - 1; z <= k + 1; ++z)
            for (int y = j - 1; y <= j + 1; ++y)
                for (const LabelRun& run : survey.row(y, z))
                    if (run.part == place && run.first <= i + 1 && run.end > i - 1)
                        return true;
        return false;
    };
    constexpr int kPointsAlong = 3;
    std::size_t points = 0;
    for (int k = part.box.first[2] - 1; k <= part.box.last[2] + 1; ++k)
        for (int j = part.box.first[1] - 1; j <= part.box.last[1] + 1; ++j)
            for (int i = part.box.first[0] - 1; i <= part.box.last[0] + 1; ++i)
            {
                if (!is_near(i, j, k))
                    continue;
                for (int n = 0; n < kPointsAlong * kPointsAlong * kPointsAlong; ++n)
                {
                    const auto offset = [&](int digit)
                    { return static_cast<double>(digit % kPointsAlong - 1) / kPointsAlong + kPadding; };
                    const Point3 p{i + offset(n), j + offset(n / 3), k + offset(n / 9)};
                    points += ballot(p).winner() == part.label + 1 ? 1 : 0;
                }
            }
    return static_cast<double>(points) / static_cast<double>(27 * part.voxels);
}

void LabelPartition::scale_weights(const LabelSurvey& survey, std::uint32_t place, double factor)
{
    const IndexBox& box = survey.parts()[place].box;
    for (int k = box.first[2]; k <= box.last[2]; ++k)
        for (int j = box.first[1]; j <= box.last[1]; ++j)
            for (const LabelRun& run : survey.row(j, k))
                for (int i = run.first; run.part == place && i < run.end; ++i)
                {
                    std::uint8_t& weight = weights_[at(i + kPadding, j + kPadding, k + kPadding)];
                    weight = static_cast<std::uint8_t>(
                        std::lround(std::clamp(weight * factor, 1.0, kMostWeight * kUnitWeight)));
                }
}

//! How far along `step` (padded samples), from 0 to 1, all around is one label; at least a step.
double LabelPartition::clear_length(const Point3& p_padded, const Vec3& step) const
{
    double length = std::numeric_limits<double>::infinity();
    SampleIndex block{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        block[axis] = (static_cast<int>(std::floor(p_padded[axis])) - 1) / kBlock;
        const double side = step[axis] > 0.0 ? (block[axis] + 1) * kBlock + 1 : block[axis] * kBlock + 1;
        if (step[axis] != 0.0)
            length = std::min(length, (side - p_padded[axis]) / step[axis]);
    }
    return is_block_mixed(block) ? 0.0 : length;
}

Point3 LabelPartition::locate(Point3 before, Point3 after, PartitionLabel label_before) const
{
    for (int i = 0; i < kHalvings; ++i)
    {
        const Point3 middle = 0.5 * (before + after);
        (label(middle) == label_before ? before : after) = middle;
    }
    return 0.5 * (before + after);
}

void LabelPartition::find_changes(const Segment3& segment, std::vector<Change>& changes) const
{
    changes.clear();
    if (!is_finite(segment.source) || !is_finite(segment.target))
        return; // of Delaunay cells that are flat but for rounding
    // The part within the domain, beyond which there is no label.
    const Box3 box = domain();
    const Vec3 whole = segment.target - segment.source;
    double begin = 0.0;
    double end = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        if (whole[axis] == 0.0 &&
            (segment.source[axis] < box.min[axis] || segment.source[axis] > box.max[axis]))
            return;
        if (whole[axis] == 0.0)
            continue;
        const double a = (box.min[axis] - segment.source[axis]) / whole[axis];
        const double b = (box.max[axis] - segment.source[axis]) / whole[axis];
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
    if (!(begin < end))
        return;
    // From here on within the domain: ends far away must not make steps too small to count, nor their
    // rounding lead out of it.
    const auto within = [&box](Point3 p)
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
            p[axis] = std::clamp(p[axis], box.min[axis], box.max[axis]);
        return p;
    };
    const Point3 source = within(segment.source + begin * whole);
    const Vec3 step = within(segment.source + end * whole) - source;
    const double length = norm(step);
    if (!(length > 0.0))
        return;
    const double pace = kStepInVoxels * std::min({spacing_.x, spacing_.y, spacing_.z}) / length;
    const Vec3 step_padded{step.x / spacing_.x, step.y / spacing_.y, step.z / spacing_.z};
    Point3 here = source;
    PartitionLabel label_here = label(here);
    double t = 0.0;
    while (t < 1.0)
    {
        const double clear = clear_length(to_padded(here), step_padded);
        const double next = std::min(t + std::max(pace, clear), 1.0);
        const Point3 there = source + next * step;
        if (const PartitionLabel label_there = label(there); label_there != label_here)
        {
            changes.push_back({locate(here, there, label_here), label_there});
            label_here = label_there;
        }
        t = next;
        here = there;
    }
}

} // namespace voroprobe
