#include "oracles/trilinear_oracle.h"

#include <string>
#include <type_traits>
#include <utility>

#include "oracles/brick_map.h"
#include "oracles/level.h"
#include "support/error.h"
#include "volume/trilinear_cell.h"

namespace voroprobe
{
namespace
{

//! By how much may_cross() grows its box, grid edges: covers the rounding of the box's and the surface's
//! coordinates.
constexpr double kBoxRounding = 1e-9;

//! A segment of index coordinates clipped to the samples' box.
struct ClippedSegment
{
    Segment3 part;
    ParameterRange range{0.0, 1.0}; //!< parameters of the part's ends along the whole segment
    bool enters = false;            //!< the whole segment begins beyond the box
    bool leaves = false;
};

template <class Sample>
class TrilinearOracle final : public SurfaceOracle
{
public:
    TrilinearOracle(std::shared_ptr<const Volume> volume, const Level& level)
        : volume_(std::move(volume)), samples_(std::get<std::vector<Sample>>(volume_->samples).data()),
          level_(level), row_stride_(volume_->geometry.size[0]),
          slice_stride_(row_stride_ * volume_->geometry.size[1]), domain_(volume_->geometry.grid_box()),
          bricks_(volume_->geometry.size,
                  [this](std::size_t k, auto sides)
                  {
                      for (std::size_t i = 0; i < sides.size(); ++i)
                          sides[i] = level_(static_cast<double>(samples_[k * slice_stride_ + i])) >= 0.0;
                  })
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            inverse_spacing_[axis] = 1.0 / volume_->geometry.spacing[axis];
            last_sample_[axis] = static_cast<double>(volume_->geometry.size[axis] - 1);
        }
    }

    [[nodiscard]] Box3 domain() const override { return domain_; }

    [[nodiscard]] Region region(const Point3& p) const override
    {
        return domain_.contains(p) && is_inside_at(index_of(p)) ? Region{1} : kOuterRegion;
    }

    void find_crossings(const Segment3& segment, std::vector<Crossing>& crossings) const override;
    [[nodiscard]] bool may_cross(const Box3& box) const override;

private:
    //! Index coordinates of a point of the domain.
    [[nodiscard]] Point3 index_of(const Point3& p) const
    {
        return {std::clamp(p.x * inverse_spacing_.x, 0.0, last_sample_.x),
                std::clamp(p.y * inverse_spacing_.y, 0.0, last_sample_.y),
                std::clamp(p.z * inverse_spacing_.z, 0.0, last_sample_.z)};
    }

    [[nodiscard]] GridCell cell_at(const Point3& p_index) const
    {
        GridCell cell;
        for (std::size_t axis = 0; axis < 3; ++axis)
            cell[axis] = std::min(static_cast<int>(p_index[axis]), static_cast<int>(last_sample_[axis]) - 1);
        return cell;
    }

    [[nodiscard]] static Vec3 local(const Point3& p_index, const GridCell& cell)
    {
        return {p_index.x - cell[0], p_index.y - cell[1], p_index.z - cell[2]};
    }

    [[nodiscard]] const Sample* first_corner(const GridCell& cell) const
    {
        return samples_ +
               (static_cast<std::size_t>(cell[0]) + static_cast<std::size_t>(cell[1]) * row_stride_ +
                static_cast<std::size_t>(cell[2]) * slice_stride_);
    }

    [[nodiscard]] CellCorners corners(const GridCell& cell) const
    {
        const Sample* low = first_corner(cell);
        const Sample* high = low + slice_stride_;
        const auto value = [&](const Sample* sample) { return level_(static_cast<double>(*sample)); };
        return {value(low),  value(low + 1),  value(low + row_stride_),  value(low + row_stride_ + 1),
                value(high), value(high + 1), value(high + row_stride_), value(high + row_stride_ + 1)};
    }

    [[nodiscard]] bool is_inside_at(const Point3& p_index) const
    {
        const GridCell cell = cell_at(p_index);
        if (!bricks_.is_mixed(cell))
            return level_(static_cast<double>(*first_corner(cell))) >= 0.0;
        return trilinear_value(corners(cell), local(p_index, cell)) >= 0.0;
    }

    [[nodiscard]] std::optional<ClippedSegment> clip(const Segment3& segment) const;

    std::shared_ptr<const Volume> volume_;
    const Sample* samples_;
    Level level_;
    std::size_t row_stride_;
    std::size_t slice_stride_;
    Box3 domain_;
    Vec3 inverse_spacing_;
    Vec3 last_sample_;
    BrickMap bricks_;
};

template <class Sample>
std::optional<ClippedSegment> TrilinearOracle<Sample>::clip(const Segment3& segment) const
{
    ClippedSegment clipped;
    clipped.enters = !domain_.contains(segment.source);
    clipped.leaves = !domain_.contains(segment.target);
    if (clipped.enters || clipped.leaves)
    {
        if (!is_finite(segment.source) || !is_finite(segment.target))
            return std::nullopt;
        const auto range = clip_to_box(segment, domain_);
        if (!range)
            return std::nullopt;
        clipped.range = *range;
    }
    clipped.part = {index_of(clipped.enters ? segment.at(clipped.range.first) : segment.source),
                    index_of(clipped.leaves ? segment.at(clipped.range.second) : segment.target)};
    return clipped;
}

template <class Sample>
void TrilinearOracle<Sample>::find_crossings(const Segment3& segment, std::vector<Crossing>& crossings) const
{
    crossings.clear();
    const auto clipped = clip(segment);
    if (!clipped)
        return;
    const auto [first, last] = clipped->range;
    const auto append = [&](double t, bool on_border) { crossings.push_back({t, segment.at(t), on_border}); };

    if (clipped->enters && is_inside_at(clipped->part.source))
        append(first, true);
    GridWalk walk(clipped->part, cell_at(clipped->part.source), cell_at(clipped->part.target));
    while (!walk.done())
    {
        const int distance = bricks_.distance(walk.cell());
        if (distance > 0)
        {
            walk.leave(BrickMap::clear_box(walk.cell(), distance));
            continue;
        }
        if (bricks_.is_mixed(walk.cell()))
        {
            const GridCellSpan span = walk.span();
            const CubicRoots roots = find_sign_changes(restrict_to_segment(
                corners(walk.cell()), local(span.entry, walk.cell()), local(span.exit, walk.cell())));
            for (std::size_t i = 0; i < roots.count; ++i)
            {
                const double along_part = span.first + roots.parameter[i] * (span.last - span.first);
                append(std::min(first + along_part * (last - first), last), false);
            }
        }
        walk.step();
    }
    if (clipped->leaves && is_inside_at(clipped->part.target))
        append(last, true);
}

template <class Sample>
bool TrilinearOracle<Sample>::may_cross(const Box3& box) const
{
    const Box3 grown = box.expanded(kBoxRounding * norm(volume_->geometry.spacing));
    Box3 part;
    bool at_border = false;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        part.min[axis] = std::max(domain_.min[axis], grown.min[axis]);
        part.max[axis] = std::min(domain_.max[axis], grown.max[axis]);
        at_border = at_border || part.min[axis] == domain_.min[axis] || part.max[axis] == domain_.max[axis];
    }
    if (part.empty())
        return false;
    if (bricks_.any_mixed({cell_at(index_of(part.min)), cell_at(index_of(part.max))}))
        return true;
    return at_border && is_inside_at(index_of(part.min)); // one side throughout: its cap, if it is the inside
}

//! What has to be known of the samples before they are read as a field.
struct SampleSurvey
{
    TieBreaker ties;
    double outermost; //!< of the finite samples, farthest on the outer side of the isovalue; a value beyond
                      //!< it where none is
    bool all_finite = true;
};

template <class Sample>
SampleSurvey survey(const std::vector<Sample>& samples, double isovalue, InsideIs inside)
{
    const double sign = inside == InsideIs::kAbove ? 1.0 : -1.0;
    const double just_outside = isovalue - sign * std::max(1.0, std::abs(isovalue));
    SampleSurvey result{TieBreaker(isovalue), just_outside};
    double lowest = std::numeric_limits<double>::infinity();
    for (const Sample sample : samples)
    {
        const auto value = static_cast<double>(sample);
        if (std::is_floating_point_v<Sample> && !std::isfinite(value))
        {
            result.all_finite = false;
            continue;
        }
        result.ties.include(value);
        lowest = std::min(lowest, sign * value);
    }
    if (lowest < sign * isovalue)
        result.outermost = sign * lowest;
    return result;
}

//! The volume with samples that are not finite replaced by a value outside.
template <class Sample>
std::shared_ptr<const Volume> with_finite_samples(const Volume& volume, double outside)
{
    auto copy = std::make_shared<Volume>(volume);
    for (Sample& sample : std::get<std::vector<Sample>>(copy->samples))
        if (!std::isfinite(static_cast<double>(sample)))
            sample = static_cast<Sample>(outside);
    return copy;
}

void check_volume(const std::shared_ptr<const Volume>& volume, double isovalue)
{
    if (!volume)
        throw UsageError("trilinear oracle: no volume");
    if (!std::isfinite(isovalue))
        throw UsageError("trilinear oracle: isovalue " + std::to_string(isovalue) +
                         ", expected a finite number");
    for (const std::size_t size : volume->geometry.size)
        if (size < 2 || size > static_cast<std::size_t>(std::numeric_limits<int>::max()))
            throw UsageError("trilinear oracle: " + std::to_string(size) +
                             " samples along an axis, expected at least 2 and fewer than 2^31");
    const std::size_t count = std::visit([](const auto& samples) { return samples.size(); }, volume->samples);
    if (count != volume->geometry.sample_count())
        throw UsageError("trilinear oracle: " + std::to_string(count) + " samples, expected " +
                         std::to_string(volume->geometry.sample_count()));
}

} // namespace

std::unique_ptr<SurfaceOracle> make_trilinear_oracle(std::shared_ptr<const Volume> volume, double isovalue,
                                                     InsideIs inside)
{
    check_volume(volume, isovalue);
    return std::visit(
        [&]<class Sample>(const std::vector<Sample>& samples) -> std::unique_ptr<SurfaceOracle>
        {
            const SampleSurvey found = survey(samples, isovalue, inside);
            if (!found.all_finite)
                volume = with_finite_samples<Sample>(*volume, found.outermost);
            return std::make_unique<TrilinearOracle<Sample>>(volume, found.ties.level(inside));
        },
        volume->samples);
}

} // namespace voroprobe
