#include "oracles/coverage.h"

#include <algorithm>
#include <cstdint>
#include <numbers>

#include "geometry/cube_grid.h"

namespace voroprobe
{
namespace
{

//! Vertices by the surface they are on and the cube they lie in.
class VerticesInCubes
{
public:
    //! Two points of a cube are not farther apart than `radius`.
    VerticesInCubes(const Box3& domain, std::span<const SurfacePoint> vertices, double radius)
        : cubes_(domain, radius * std::numbers::inv_sqrt3), radius_(radius)
    {
        entries_.reserve(vertices.size());
        for (const SurfacePoint& at : vertices)
            entries_.push_back({number(at.surface, cubes_.cube(at.point)), at.point});
        std::sort(entries_.begin(), entries_.end(),
                  [](const Entry& a, const Entry& b) { return a.number < b.number; });
    }

    [[nodiscard]] bool covers(const SurfacePoint& at) const
    {
        const CubeGrid::Cube own = cubes_.cube(at.point);
        if (!vertices_in(at.surface, own).empty())
            return true;
        for (std::int64_t dz = -kReach; dz <= kReach; ++dz)
            for (std::int64_t dy = -kReach; dy <= kReach; ++dy)
                for (std::int64_t dx = -kReach; dx <= kReach; ++dx)
                {
                    const CubeGrid::Cube cube{own[0] + dx, own[1] + dy, own[2] + dz};
                    if (cubes_.has(cube) && is_near(at.point, vertices_in(at.surface, cube)))
                        return true;
                }
        return false;
    }

private:
    struct Entry
    {
        std::int64_t number; //!< of the surface and the cube
        Point3 point;
    };

    //! The radius in cubes, rounded up.
    static constexpr std::int64_t kReach = 2;

    [[nodiscard]] std::int64_t number(SurfaceId surface, const CubeGrid::Cube& cube) const
    {
        return surface * cubes_.count() + cubes_.number(cube);
    }

    [[nodiscard]] std::span<const Entry> vertices_in(SurfaceId surface, const CubeGrid::Cube& cube) const
    {
        const std::int64_t wanted = number(surface, cube);
        const auto begin = std::lower_bound(entries_.begin(), entries_.end(), wanted,
                                            [](const Entry& a, std::int64_t b) { return a.number < b; });
        const auto end = std::find_if(begin, entries_.end(),
                                      [wanted](const Entry& entry) { return entry.number != wanted; });
        return {begin, end};
    }

    [[nodiscard]] bool is_near(const Point3& p, std::span<const Entry> entries) const
    {
        return std::any_of(entries.begin(), entries.end(),
                           [&](const Entry& entry)
                           { return squared_distance(entry.point, p) <= radius_ * radius_; });
    }

    CubeGrid cubes_;
    double radius_;
    std::vector<Entry> entries_; //!< sorted by number
};

} // namespace

std::vector<SurfacePoint> find_uncovered_points(const SurfaceOracle& oracle,
                                                std::span<const SurfacePoint> vertices, double radius,
                                                double spacing, std::size_t threads)
{
    std::vector<SurfacePoint> uncovered = oracle.points_in_cubes(spacing, threads);
    const VerticesInCubes in_cubes(oracle.domain(), vertices, radius);
    std::erase_if(uncovered, [&](const SurfacePoint& at) { return in_cubes.covers(at); });
    return uncovered;
}

} // namespace voroprobe
