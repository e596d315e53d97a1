#include "postprocess/deviation.h"

#include <algorithm>
#include <vector>

#include "certificate/mesh_distance.h"
#include "certificate/mesh_samples.h"
#include "support/random.h"

namespace voroprobe
{

namespace
{

constexpr std::uint64_t kSeed = 0;

//! Adds the distances of points of `from` to `to`; the mean is that of points spread by area.
void add(const TriangleMesh& from, const TriangleMesh& to, std::size_t samples, Deviation& result)
{
    const MeshDistance distance_to(to);
    Random random(kSeed);
    const auto look = [&](const MeshSample& sample)
    {
        const double distance = distance_to(sample.point);
        if (distance > result.max)
        {
            result.max = distance;
            result.max_at = sample.point;
        }
        return distance;
    };
    for (const MeshSample& sample : mesh_landmarks(from, samples / 2))
        look(sample);
    double sum = 0.0;
    const auto spread = area_samples(from, samples / 2, random);
    for (const MeshSample& sample : spread)
        sum += look(sample);
    result.mean += 0.5 * sum / static_cast<double>(std::max<std::size_t>(spread.size(), 1));
}

} // namespace

Deviation deviation(const TriangleMesh& a, const TriangleMesh& b, std::size_t samples)
{
    Deviation result;
    add(a, b, samples / 2, result);
    add(b, a, samples / 2, result);
    return result;
}

} // namespace voroprobe
