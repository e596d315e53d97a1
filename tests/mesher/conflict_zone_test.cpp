#include "mesher/conflict_zone.h"

#include <cmath>
#include <iterator>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "mesher/restricted_delaunay.h"
#include "oracles/sphere_union_oracle.h"
#include "support/random.h"

namespace voroprobe
{
namespace
{

using CellSet = std::set<DelaunayCell>;

//! Random points of the unit cube, of a lattice of `steps` along each axis where that is not 0: many of them
//! cospherical.
std::vector<Point3> random_points(std::size_t count, int steps)
{
    Random random(static_cast<std::uint64_t>(11 + steps));
    std::vector<Point3> points;
    for (std::size_t i = 0; i < count; ++i)
    {
        Point3 p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        for (std::size_t axis = 0; steps > 0 && axis < 3; ++axis)
            p[axis] = std::round(p[axis] * steps) / steps;
        points.push_back(p);
    }
    return points;
}

class ConflictZoneOf : public testing::TestWithParam<int>
{
protected:
    SphereUnionOracle oracle_{{{{0, 0, 0}, 1.0}}};
    MeshingStatistics statistics_;
    RestrictedDelaunay restricted_{oracle_, statistics_};
};

TEST_P(ConflictZoneOf, a_point_is_that_of_cgal)
{
    ConflictZone zone;
    for (const Point3& p : random_points(400, GetParam()))
    {
        const DelaunayCell start = restricted_.locate(p, {});
        if (start == DelaunayCell())
            continue; // a vertex already
        const Triangulation& triangulation = restricted_.triangulation();
        zone.find(triangulation, p, start);
        std::vector<DelaunayCell> cells;
        std::vector<Triangulation::Facet> boundary;
        triangulation.find_conflicts(cgal_point(p), start, std::back_inserter(boundary),
                                     std::back_inserter(cells));
        EXPECT_EQ(CellSet(zone.cells().begin(), zone.cells().end()), CellSet(cells.begin(), cells.end()));
        ASSERT_EQ(zone.facets().size(), boundary.size());
        restricted_.insert(p, VertexOrigin::kRefinement);
    }
}

TEST_P(ConflictZoneOf, every_point_leaves_a_delaunay_triangulation)
{
    std::size_t inserted = 0;
    for (const Point3& p : random_points(400, GetParam()))
        inserted += restricted_.insert(p, VertexOrigin::kRefinement) != VertexHandle() ? 1 : 0;
    EXPECT_EQ(restricted_.vertex_count(), inserted);
    EXPECT_TRUE(restricted_.triangulation().is_valid());
}

INSTANTIATE_TEST_SUITE_P(Lattices, ConflictZoneOf, testing::Values(0, 3, 4));

} // namespace
} // namespace voroprobe
