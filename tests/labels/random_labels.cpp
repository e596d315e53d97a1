#include "random_labels.h"

#include <cmath>

#include "support/random.h"

namespace voroprobe
{
namespace
{

struct Blob
{
    Point3 center;
    double radius;
    std::uint16_t label;
};

std::uint16_t label_at(const std::vector<Blob>& blobs, const Point3& p)
{
    std::uint16_t label = 0;
    for (const Blob& blob : blobs)
        label = distance(p, blob.center) <= blob.radius ? blob.label : label;
    return label;
}

} // namespace

Volume random_labels(const std::array<std::size_t, 3>& size, std::uint16_t labels, std::uint64_t seed)
{
    constexpr int kBlobsPerLabel = 3;
    constexpr double kShareOfSpecks = 0.01;
    Random random(seed);
    const auto any_label = [&] { return static_cast<std::uint16_t>(random.uniform(0.0, labels + 1.0)); };
    std::vector<Blob> blobs;
    for (int i = 0; i < kBlobsPerLabel * labels; ++i)
        blobs.push_back({{random.uniform(0.0, static_cast<double>(size[0])),
                          random.uniform(0.0, static_cast<double>(size[1])),
                          random.uniform(0.0, static_cast<double>(size[2]))},
                         random.uniform(0.5, 4.5),
                         any_label()});
    std::vector<std::uint16_t> samples;
    for (std::size_t k = 0; k < size[2]; ++k)
        for (std::size_t j = 0; j < size[1]; ++j)
            for (std::size_t i = 0; i < size[0]; ++i)
                samples.push_back(random.uniform() < kShareOfSpecks
                                      ? any_label()
                                      : label_at(blobs, {static_cast<double>(i), static_cast<double>(j),
                                                         static_cast<double>(k)}));
    return make_volume({.size = size, .spacing = {1, 1, 1}, .direction = {}, .origin = {}},
                       std::move(samples));
}

std::size_t count_components(const std::array<std::size_t, 3>& size, const std::vector<bool>& belongs,
                             Neighbours neighbours)
{
    std::vector<bool> left = belongs;
    const auto inside = [&](int x, std::size_t axis) { return x >= 0 && x < static_cast<int>(size[axis]); };
    const auto at = [&](const SampleIndex& p)
    {
        return static_cast<std::size_t>(p[0]) +
               size[0] * (static_cast<std::size_t>(p[1]) + size[1] * static_cast<std::size_t>(p[2]));
    };
    const auto flood = [&](const SampleIndex& first)
    {
        std::vector<SampleIndex> open{first};
        left[at(first)] = false;
        while (!open.empty())
        {
            const SampleIndex p = open.back();
            open.pop_back();
            for (int z = -1; z <= 1; ++z)
                for (int y = -1; y <= 1; ++y)
                    for (int x = -1; x <= 1; ++x)
                    {
                        const SampleIndex q{p[0] + x, p[1] + y, p[2] + z};
                        if (neighbours == Neighbours::kFaces && std::abs(x) + std::abs(y) + std::abs(z) != 1)
                            continue;
                        if (!inside(q[0], 0) || !inside(q[1], 1) || !inside(q[2], 2) || !left[at(q)])
                            continue;
                        left[at(q)] = false;
                        open.push_back(q);
                    }
        }
    };
    std::size_t components = 0;
    for (int k = 0; inside(k, 2); ++k)
        for (int j = 0; inside(j, 1); ++j)
            for (int i = 0; inside(i, 0); ++i)
                if (const SampleIndex p{i, j, k}; left[at(p)])
                {
                    flood(p);
                    ++components;
                }
    return components;
}

} // namespace voroprobe
