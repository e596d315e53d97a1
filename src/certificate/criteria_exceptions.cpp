#include "certificate/criteria_exceptions.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "certificate/nearest_crossing.h"
#include "mesh/circumcircle.h"
#include "mesh/measures.h"

namespace voroprobe
{

namespace
{

//! Bounds give way by so much of themselves: files may store 32-bit floats.
constexpr double kFileRounding = 1e-5;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Counts
{
    std::size_t size = 0;
    std::size_t distance = 0;
};

void judge(const Circumcircle& circle, const FaceCriteria& criteria, NearestCrossing& search, Counts& counts)
{
    const double max_radius = (1.0 + kFileRounding) * criteria.max_radius.value_or(0.0);
    const double max_distance = (1.0 + kFileRounding) * criteria.max_center_distance.value_or(0.0);
    const auto center = search.along(circle.center, circle.normal, std::max(max_radius, max_distance));
    const double offset = center ? center->distance : kInfinity;
    counts.size += std::hypot(circle.radius, offset) > max_radius ? 1 : 0;
    counts.distance += offset > max_distance ? 1 : 0;
}

Counts count_balls(const TriangleMesh& mesh, const SurfaceOracle& oracle, const FaceCriteria& criteria)
{
    const auto count = [&](const tbb::blocked_range<std::size_t>& range, Counts counts)
    {
        NearestCrossing search(oracle);
        for (std::size_t f = range.begin(); f < range.end(); ++f)
        {
            const TriangleMesh::Face& face = mesh.faces[f];
            const auto circle =
                circumcircle(mesh.corner(face, 0), mesh.corner(face, 1), mesh.corner(face, 2));
            if (circle)
                judge(*circle, criteria, search, counts);
            else
                counts = {counts.size + 1, counts.distance + 1};
        }
        return counts;
    };
    return tbb::parallel_reduce(tbb::blocked_range<std::size_t>(0, mesh.faces.size()), Counts{}, count,
                                [](const Counts& a, const Counts& b) {
                                    return Counts{a.size + b.size, a.distance + b.distance};
                                });
}

} // namespace

CriteriaExceptions count_exceptions(const TriangleMesh& mesh, const SurfaceOracle& oracle,
                                    const FaceCriteria& criteria)
{
    CriteriaExceptions exceptions;
    if (criteria.min_angle_deg)
        exceptions.angle = count_faces_below_angle(mesh, *criteria.min_angle_deg);
    if (!criteria.max_radius && !criteria.max_center_distance)
        return exceptions;
    const Counts counts = count_balls(mesh, oracle, criteria);
    if (criteria.max_radius)
        exceptions.size = counts.size;
    if (criteria.max_center_distance)
        exceptions.distance = counts.distance;
    return exceptions;
}

} // namespace voroprobe
