#include "certificate/criteria_exceptions.h"

#include <algorithm>
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

//! The surface is looked for within this share of the largest bound first: most of the time it is there.
constexpr double kFirstReach = 0.125;

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
    const double reach = std::max(max_radius, max_distance);
    auto center = search.along(circle.center, circle.normal, kFirstReach * reach);
    if (!center)
        center = search.along(circle.center, circle.normal, reach);
    const double offset = center ? center->distance : kInfinity;
    counts.size += circle.radius * circle.radius + offset * offset > max_radius * max_radius ? 1 : 0;
    counts.distance += offset > max_distance ? 1 : 0;
}

//! In the order of the tree, so that neighbours ask for the same samples.
Counts count_balls(const FaceTree& tree, const SurfaceOracle& oracle, const FaceCriteria& criteria)
{
    const auto count = [&](const tbb::blocked_range<std::size_t>& range, Counts counts)
    {
        NearestCrossing search(oracle);
        const TriangleMesh& mesh = tree.mesh();
        for (std::size_t i = range.begin(); i < range.end(); ++i)
        {
            const TriangleMesh::Face& face = mesh.faces[tree.faces()[i]];
            const auto circle =
                circumcircle(mesh.corner(face, 0), mesh.corner(face, 1), mesh.corner(face, 2));
            if (circle)
                judge(*circle, criteria, search, counts);
            else
                counts = {counts.size + 1, counts.distance + 1};
        }
        return counts;
    };
    return tbb::parallel_reduce(tbb::blocked_range<std::size_t>(0, tree.faces().size()), Counts{}, count,
                                [](const Counts& a, const Counts& b) {
                                    return Counts{a.size + b.size, a.distance + b.distance};
                                });
}

} // namespace

CriteriaExceptions count_exceptions(const TriangleMesh& mesh, const SurfaceOracle& oracle,
                                    const FaceCriteria& criteria)
{
    return count_exceptions(FaceTree(mesh), oracle, criteria);
}

CriteriaExceptions count_exceptions(const FaceTree& tree, const SurfaceOracle& oracle,
                                    const FaceCriteria& criteria)
{
    CriteriaExceptions exceptions;
    if (criteria.min_angle_deg)
        exceptions.angle = count_faces_below_angle(tree.mesh(), *criteria.min_angle_deg);
    if (!criteria.max_radius && !criteria.max_center_distance)
        return exceptions;
    const Counts counts = count_balls(tree, oracle, criteria);
    if (criteria.max_radius)
        exceptions.size = counts.size;
    if (criteria.max_center_distance)
        exceptions.distance = counts.distance;
    return exceptions;
}

} // namespace voroprobe
