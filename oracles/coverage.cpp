#include "oracles/coverage.h"

#include <algorithm>
#include <cstdint>
#include <numbers>

#include "geometry/cube_grid.h"

namespace voroprobe
{
namespace
{

//! Numbers for the pairs of a surface and a cube that it passes. Two points of a cube are not farther apart
//! than `radius`.
class CubesOfSurfaces
{
public:
    CubesOfSurfaces(const Box3& domain, double radius) : cubes_(domain, radius * std::numbers::inv_sqrt3) {}

    [[nodiscard]] std::int64_t number(const SurfacePoint& at) const
    {
        return at.surface * cubes_.count() + cubes_.number(cubes_.cube(at.point));
    }

    //! Calls `visit(first, last)` for rows of numbers, up to and with the last one: of all cubes that come
    //! nearer to the point than the radius. Until it returns true; whether it has.
    template <class Visit>
    bool any_row_around(const SurfacePoint& at, Visit visit) const
    {
        const CubeGrid::Cube own = cubes_.cube(at.point);
        const std::int64_t surface = at.surface * cubes_.count();
        for (std::int64_t dz = -kReach; dz <= kReach; ++dz)
            for (std::int64_t dy = -kReach; dy <= kReach; ++dy)
            {
                CubeGrid::Cube first{own[0], own[1] + dy, own[2] + dz};
                if (!cubes_.has(first))
                    continue;
                CubeGrid::Cube last = first;
                for (std::int64_t dx = 1; dx <= kReach; ++dx)
                {
                    first[0] -= cubes_.has({own[0] - dx, first[1], first[2]}) ? 1 : 0;
                    last[0] += cubes_.has({own[0] + dx, last[1], last[2]}) ? 1 : 0;
                }
                if (visit(surface + cubes_.number(first), surface + cubes_.number(last)))
                    return true;
            }
        return false;
    }

private:
    //! The radius in cubes, rounded up.
    static constexpr std::int64_t kReach = 2;

    CubeGrid cubes_;
};

//! Vertices by the surface they are on and the cube they lie in.
class VerticesInCubes
{
public:
    VerticesInCubes(const Box3& domain, std::span<const SurfacePoint> vertices, double radius)
        : cubes_(domain, radius), radius_(radius)
    {
        entries_.reserve(vertices.size());
        for (const SurfacePoint& at : vertices)
            entries_.push_back({cubes_.number(at), at.point});
        std::sort(entries_.begin(), entries_.end(),
                  [](const Entry& a, const Entry& b) { return a.number < b.number; });
    }

    [[nodiscard]] bool covers(const SurfacePoint& at) const
    {
        const std::int64_t own = cubes_.number(at);
        const auto first = lower_bound(own);
        if (first != entries_.end() && first->number == own)
            return true;
        return cubes_.any_row_around(at, [&](std::int64_t begin, std::int64_t last)
                                     { return is_any_near(at.point, begin, last); });
    }

private:
    struct Entry
    {
        std::int64_t number; //!< of the surface and the cube
        Point3 point;
    };

    [[nodiscard]] std::vector<Entry>::const_iterator lower_bound(std::int64_t number) const
    {
        return std::lower_bound(entries_.begin(), entries_.end(), number,
                                [](const Entry& a, std::int64_t b) { return a.number < b; });
    }

    [[nodiscard]] bool is_any_near(const Point3& p, std::int64_t first, std::int64_t last) const
    {
        for (auto entry = lower_bound(first); entry != entries_.end() && entry->number <= last; ++entry)
        {
            if (squared_distance(entry->point, p) <= radius_ * radius_)
                return true;
        }
        return false;
    }

    CubesOfSurfaces cubes_;
    double radius_;
    std::vector<Entry> entries_; //!< sorted by number
};

//! The cubes around some points, each with the point's surface.
class CubesAround
{
public:
    CubesAround(const Box3& domain, std::span<const SurfacePoint> points, double radius)
        : cubes_(domain, radius)
    {
        const auto add = [&](std::int64_t first, std::int64_t last)
        {
            for (; first <= last; ++first)
                numbers_.push_back(first);
            return false;
        };
        for (const SurfacePoint& at : points)
            cubes_.any_row_around(at, add);
        std::sort(numbers_.begin(), numbers_.end());
    }

    [[nodiscard]] bool hold(const SurfacePoint& at) const
    {
        return std::binary_search(numbers_.begin(), numbers_.end(), cubes_.number(at));
    }

private:
    CubesOfSurfaces cubes_;
    std::vector<std::int64_t> numbers_; //!< sorted
};

void erase_covered(const Box3& domain, std::span<const SurfacePoint> vertices, double radius,
                   std::vector<SurfacePoint>& points)
{
    if (points.empty())
        return;
    const VerticesInCubes in_cubes(domain, vertices, radius);
    std::erase_if(points, [&](const SurfacePoint& at) { return in_cubes.covers(at); });
}

} // namespace

std::vector<SurfacePoint> find_uncovered_points(const SurfaceOracle& oracle,
                                                std::span<const SurfacePoint> vertices, double radius,
                                                double spacing, std::size_t threads)
{
    std::vector<SurfacePoint> points = oracle.points_in_cubes(spacing, threads);
    erase_covered(oracle.domain(), vertices, radius, points);
    return points;
}

std::vector<SurfacePoint> find_uncovered_points_near(std::vector<SurfacePoint> places,
                                                     const SurfaceOracle& oracle,
                                                     std::span<const SurfacePoint> vertices, double radius,
                                                     double spacing, std::size_t threads)
{
    erase_covered(oracle.domain(), vertices, radius, places);
    if (places.empty())
        return {};
    std::vector<SurfacePoint> points = oracle.points_in_cubes(spacing, threads);
    const CubesAround around(oracle.domain(), places, radius);
    std::erase_if(points, [&](const SurfacePoint& at) { return !around.hold(at); });
    erase_covered(oracle.domain(), vertices, radius, points);
    return points;
}

} // namespace voroprobe
