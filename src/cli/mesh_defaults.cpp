#include "cli/mesh_defaults.h"

#include <algorithm>
#include <cmath>

#include "cli/number_text.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

constexpr double kSizeInMeanSides = 2.0;
constexpr double kDistanceInShortestSides = 0.3;
constexpr double kFloorInShortestSides = 0.25;
constexpr double kLargestFloorInSizes = 0.5;
constexpr double kReachInShortestSides = 1.0;

} // namespace

VoxelScale voxel_scale(const AffineTransform& source_index_from_grid)
{
    const auto& index_per_length = source_index_from_grid.linear.column;
    const double longest_step =
        std::max({norm(index_per_length[0]), norm(index_per_length[1]), norm(index_per_length[2])});
    return {1.0 / longest_step, 1.0 / std::cbrt(std::abs(determinant(source_index_from_grid.linear)))};
}

MeshingOptions meshing_options(const RequestedCriteria& requested, const VoxelScale& voxel)
{
    const double size = requested.size.value_or(kSizeInMeanSides * voxel.mean_side);
    const double default_floor =
        std::min(kFloorInShortestSides * voxel.shortest_side, kLargestFloorInSizes * size);
    MeshingOptions options{
        .max_facet_radius = size,
        .max_facet_distance = requested.distance.value_or(kDistanceInShortestSides * voxel.shortest_side),
        .min_facet_angle_deg = requested.angle_deg,
        .floor_radius = requested.floor.value_or(default_floor),
        .reach_lower_bound = requested.reach.value_or(kReachInShortestSides * voxel.shortest_side)};
    if (options.floor_radius > size)
        throw UsageError("--floor is " + number_text(options.floor_radius) +
                         "; allowed: at most --size, here " + number_text(size) + " mm");
    return options;
}

} // namespace voroprobe
