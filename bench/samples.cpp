#include "bench/samples.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <variant>

namespace voroprobe::bench
{

namespace
{

using GridIndex = std::array<std::size_t, 3>;

//! Flood fill over the inside samples, one region after the other.
class RegionScan
{
public:
    RegionScan(const GridGeometry& geometry, const std::vector<float>& samples, double isovalue)
        : geometry_(geometry), samples_(samples), isovalue_(isovalue), visited_(samples.size(), false)
    {
    }

    //! Crossings of the surface with grid edges around each region.
    std::vector<std::vector<Point3>> crossings_by_region()
    {
        std::vector<std::vector<Point3>> regions;
        for (std::size_t at = 0; at < samples_.size(); ++at)
            if (is_inside(at) && !visited_[at])
                regions.push_back(flood(at));
        return regions;
    }

private:
    [[nodiscard]] bool is_inside(std::size_t at) const { return samples_[at] >= isovalue_; }

    [[nodiscard]] GridIndex index_of(std::size_t at) const
    {
        const auto& n = geometry_.size;
        return {at % n[0], at / n[0] % n[1], at / (n[0] * n[1])};
    }

    std::vector<Point3> flood(std::size_t start)
    {
        std::vector<Point3> crossings;
        std::vector<std::size_t> front{start};
        visited_[start] = true;
        while (!front.empty())
        {
            const std::size_t at = front.back();
            front.pop_back();
            visit_neighbours(at, front, crossings);
        }
        return crossings;
    }

    void visit_neighbours(std::size_t at, std::vector<std::size_t>& front, std::vector<Point3>& crossings)
    {
        const GridIndex index = index_of(at);
        std::size_t stride = 1;
        for (std::size_t axis = 0; axis < 3; stride *= geometry_.size[axis], ++axis)
            for (const int step : {-1, 1})
            {
                if (index[axis] == (step < 0 ? 0 : geometry_.size[axis] - 1))
                    continue;
                const std::size_t next = step < 0 ? at - stride : at + stride;
                if (!is_inside(next))
                    crossings.push_back(crossing(index, axis, step, at, next));
                else if (!visited_[next])
                {
                    visited_[next] = true;
                    front.push_back(next);
                }
            }
    }

    [[nodiscard]] Point3 crossing(const GridIndex& index, std::size_t axis, int step, std::size_t inside,
                                  std::size_t outside) const
    {
        Vec3 position{static_cast<double>(index[0]), static_cast<double>(index[1]),
                      static_cast<double>(index[2])};
        position[axis] +=
            step * (samples_[inside] - isovalue_) / (double{samples_[inside]} - double{samples_[outside]});
        return {position.x * geometry_.spacing.x, position.y * geometry_.spacing.y,
                position.z * geometry_.spacing.z};
    }

    const GridGeometry& geometry_;
    const std::vector<float>& samples_;
    double isovalue_;
    std::vector<bool> visited_;
};

} // namespace

std::vector<float> to_float(const Volume& volume)
{
    std::vector<float> samples;
    samples.reserve(volume.geometry.sample_count());
    const auto append = [&samples](const auto& stored)
    {
        for (const auto value : stored)
        {
            const auto as_float = static_cast<float>(value);
            samples.push_back(std::isfinite(as_float) ? as_float : std::numeric_limits<float>::lowest());
        }
    };
    std::visit(append, volume.samples);
    return samples;
}

std::vector<Point3> seeds_on_every_region(const GridGeometry& geometry, const std::vector<float>& samples,
                                          double isovalue, std::size_t per_region)
{
    std::vector<Point3> seeds;
    for (const auto& crossings : RegionScan(geometry, samples, isovalue).crossings_by_region())
    {
        const std::size_t count = std::min(per_region, crossings.size());
        for (std::size_t i = 0; i < count; ++i)
            seeds.push_back(crossings[i * crossings.size() / count]);
    }
    return seeds;
}

} // namespace voroprobe::bench
