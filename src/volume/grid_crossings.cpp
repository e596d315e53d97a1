#include <algorithm>
#include <cmath>
#include <utility>

#include "volume/inventory.h"

namespace voroprobe
{
namespace
{

//! Points in the order they come, thinned evenly: at most twice as many as wanted are kept at any time.
class SpreadPoints
{
public:
    explicit SpreadPoints(std::size_t most) : most_(most) {}

    void add(const Point3& p)
    {
        if (seen_++ % stride_ != 0)
            return;
        kept_.push_back(p);
        if (kept_.size() == 2 * most_)
        {
            for (std::size_t i = 0; i < most_; ++i)
                kept_[i] = kept_[2 * i];
            kept_.resize(most_);
            stride_ *= 2;
        }
    }

    [[nodiscard]] std::vector<Point3> take() &&
    {
        if (kept_.size() <= most_)
            return std::move(kept_);
        std::vector<Point3> spread;
        for (std::size_t i = 0; i < most_; ++i)
            spread.push_back(kept_[i * kept_.size() / most_]);
        return spread;
    }

private:
    std::size_t most_;
    std::size_t seen_ = 0;
    std::size_t stride_ = 1;
    std::vector<Point3> kept_;
};

//! The samples whose edges a surface may cross: its box, rounded outwards.
struct SampleBox
{
    std::array<int, 3> min;
    std::array<int, 3> max;
};

SampleBox samples_around(const Box3& box, const LatticeFrame& frame)
{
    SampleBox samples{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const double a = (box.min[axis] - frame.first[axis]) / frame.step[axis];
        const double b = (box.max[axis] - frame.first[axis]) / frame.step[axis];
        const int last = frame.sample_count[axis] - 1;
        // One more on both sides: a crossing within rounding of a sample.
        samples.min[axis] = std::clamp(static_cast<int>(std::floor(std::min(a, b))) - 1, 0, last);
        samples.max[axis] = std::clamp(static_cast<int>(std::ceil(std::max(a, b))) + 1, 0, last);
    }
    return samples;
}

//! Slice k and, where there is one, slice k + 1.
struct SlicePair
{
    int k;
    std::vector<double> below;
    std::vector<double> above;
};

//! Looks for the crossings of one surface.
class CrossingSearch
{
public:
    CrossingSearch(const LatticeFrame& frame, const Inventory& inventory, SurfaceId surface, std::size_t most)
        : frame_(frame), inventory_(inventory), id_(surface),
          surface_(inventory.surfaces()[static_cast<std::size_t>(surface)]),
          samples_(samples_around(surface_.box, frame)), points_(most)
    {
    }

    [[nodiscard]] const SampleBox& samples() const { return samples_; }

    void visit_slice(const SlicePair& slices)
    {
        for (int j = samples_.min[1]; j <= samples_.max[1]; ++j)
            for (int i = samples_.min[0]; i <= samples_.max[0]; ++i)
                visit_sample(slices, {i, j, slices.k});
    }

    [[nodiscard]] std::vector<Point3> take() && { return std::move(points_).take(); }

private:
    //! The edges that go up from a sample, and the sample itself where it is on a cap.
    void visit_sample(const SlicePair& slices, const std::array<int, 3>& index)
    {
        const double height = height_of(slices, index);
        if (surface_.touches_border && height >= 0.0 && is_on_border(index) &&
            is_ours(region(index), kOuterRegion))
            points_.add(frame_.at(index));
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            std::array<int, 3> next = index;
            if (++next[axis] == frame_.sample_count[axis])
                continue;
            const double next_height = height_of(slices, next);
            if ((height >= 0.0) != (next_height >= 0.0) && is_ours(region(index), region(next)))
                points_.add(edge_crossing(frame_.at(index), height, frame_.at(next), next_height));
        }
    }

    [[nodiscard]] double height_of(const SlicePair& slices, const std::array<int, 3>& index) const
    {
        const auto columns = static_cast<std::size_t>(frame_.sample_count[0]);
        const std::size_t at =
            static_cast<std::size_t>(index[0]) + static_cast<std::size_t>(index[1]) * columns;
        return (index[2] == slices.k ? slices.below : slices.above)[at];
    }

    [[nodiscard]] bool is_on_border(const std::array<int, 3>& index) const
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (index[axis] == 0 || index[axis] + 1 == frame_.sample_count[axis])
                return true;
        return false;
    }

    [[nodiscard]] Region region(const std::array<int, 3>& index) const
    {
        return inventory_.region(index[0], index[1], index[2]);
    }

    [[nodiscard]] bool is_ours(Region a, Region b) const { return inventory_.surface_between(a, b) == id_; }

    const LatticeFrame& frame_;
    const Inventory& inventory_;
    SurfaceId id_;
    const ScanSurface& surface_;
    SampleBox samples_;
    SpreadPoints points_;
};

} // namespace

std::vector<std::vector<Point3>> grid_crossings(const HeightField& field, const Inventory& inventory,
                                                std::span<const SurfaceId> surfaces, std::size_t most)
{
    std::vector<std::vector<Point3>> found(surfaces.size());
    if (most == 0)
        return found;
    const LatticeFrame frame = field.frame();
    std::vector<CrossingSearch> searches;
    for (const SurfaceId surface : surfaces)
        searches.emplace_back(frame, inventory, surface, most);

    const std::size_t slice_size =
        static_cast<std::size_t>(frame.sample_count[0]) * static_cast<std::size_t>(frame.sample_count[1]);
    SlicePair slices{-1, std::vector<double>(slice_size), std::vector<double>(slice_size)};
    int above = -1; // the slice held in slices.above
    for (int k = 0; k < frame.sample_count[2]; ++k)
    {
        const auto reaches = [k](const CrossingSearch& search)
        { return k >= search.samples().min[2] && k <= search.samples().max[2]; };
        if (std::none_of(searches.begin(), searches.end(), reaches))
            continue;
        std::swap(slices.below, slices.above);
        if (above != k)
            field.read_slice(static_cast<std::size_t>(k), slices.below);
        if (k + 1 < frame.sample_count[2])
            field.read_slice(static_cast<std::size_t>(k) + 1, slices.above);
        above = k + 1;
        slices.k = k;
        for (CrossingSearch& search : searches)
            if (reaches(search))
                search.visit_slice(slices);
    }
    for (std::size_t i = 0; i < searches.size(); ++i)
        found[i] = std::move(searches[i]).take();
    return found;
}

} // namespace voroprobe
