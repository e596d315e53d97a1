#include "mesher/restricted_delaunay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mesher/umbrella.h"
#include "oracles/sphere_union_oracle.h"
#include "support/random.h"
#include "surface_distance.h"

namespace voroprobe
{
namespace
{

constexpr double kRounding = 1e-9; // of coordinates around 1

//! The Delaunay triangulation of points of a sphere and a smaller one within it, restricted to both.
class RestrictedToSpheres : public testing::Test
{
protected:
    RestrictedToSpheres()
    {
        Random random(7);
        for (const Point3& p : sample_surface(oracle_, 800, random))
            restricted_.insert(p, VertexOrigin::kRefinement);
    }

    //! Every facet of the table in use.
    template <class Visit>
    void for_each_facet(Visit&& visit)
    {
        for (const VertexHandle vertex : restricted_.triangulation().finite_vertex_handles())
        {
            restricted_.odd_facets_around(vertex, facets_);
            for (const FacetId id : facets_)
                visit(restricted_.facet(id));
        }
    }

    SphereUnionOracle oracle_{{{{0, 0, 0}, 1.0}, {{0, 0, 0}, 0.5}}};
    MeshingStatistics statistics_;
    RestrictedDelaunay restricted_{oracle_, statistics_};
    std::vector<FacetId> facets_;
};

TEST_F(RestrictedToSpheres, centers_lie_on_the_surface_as_far_from_all_corners)
{
    std::size_t count = 0;
    for_each_facet(
        [&](const RestrictedFacet& facet)
        {
            ++count;
            const double from_origin = norm(facet.center);
            EXPECT_LT(std::min(std::abs(from_origin - 1.0), std::abs(from_origin - 0.5)), kRounding);
            for (const Point3& corner : restricted_.corners(facet))
                EXPECT_NEAR(distance(corner, facet.center), std::sqrt(facet.squared_radius), kRounding);
        });
    EXPECT_GT(count, 2000U);
}

TEST_F(RestrictedToSpheres, surface_delaunay_balls_are_empty)
{
    for_each_facet(
        [&](const RestrictedFacet& facet)
        {
            const auto nearest =
                restricted_.triangulation().nearest_vertex(cgal_point(facet.center), facet.delaunay_cell);
            EXPECT_GE(distance(position(nearest), facet.center), std::sqrt(facet.squared_radius) - kRounding);
        });
}

TEST_F(RestrictedToSpheres, remembered_answers_are_those_the_oracle_would_give_now)
{
    std::vector<Crossing> crossings;
    for_each_facet(
        [&](const RestrictedFacet& facet)
        {
            const DelaunayCell other = facet.delaunay_cell->neighbor(facet.index);
            oracle_.find_crossings({facet.delaunay_cell->info().circumcenter, other->info().circumcenter},
                                   crossings);
            ASSERT_EQ(crossings.size(), facet.crossing_count);
            double nearest = 1.0;
            for (const Crossing& crossing : crossings)
                nearest = std::min(nearest, distance(crossing.point, facet.center));
            EXPECT_LT(nearest, kRounding);
        });
}

TEST_F(RestrictedToSpheres, facets_are_odd_where_the_sides_of_their_dual_vertices_differ)
{
    const Triangulation& triangulation = restricted_.triangulation();
    for (const auto& [delaunay_cell, index] : triangulation.finite_facets())
    {
        const FacetId id = delaunay_cell->info().facet[static_cast<std::size_t>(index)];
        const bool odd = id < kUnqueriedFacet && restricted_.facet(id).odd();
        EXPECT_EQ(odd, is_inside(delaunay_cell->info().region) !=
                           is_inside(delaunay_cell->neighbor(index)->info().region));
    }
}

TEST_F(RestrictedToSpheres, a_point_that_is_a_vertex_is_not_inserted_again)
{
    const VertexHandle vertex = *restricted_.triangulation().finite_vertex_handles().begin();
    const std::size_t before = restricted_.vertex_count();
    EXPECT_EQ(restricted_.insert(position(vertex), VertexOrigin::kProbe), VertexHandle());
    EXPECT_EQ(restricted_.vertex_count(), before);
}

//! Corners of a facet, and the radius of its ball.
using PlacedFacet = std::pair<std::array<std::uint32_t, 3>, double>;

// Lemma 1 of the report, in general: the persistent facets of its Definition 10 are those with balls under
// half the size criterion, and a ball is refined for its size where it is larger than that.
TEST_F(RestrictedToSpheres, a_center_inserted_leaves_every_facet_with_a_ball_under_half_of_its_own)
{
    Random random(11);
    std::size_t left = 0;
    for (int insertion = 0; insertion < 100; ++insertion)
    {
        std::vector<PlacedFacet> before;
        std::vector<Point3> centers;
        for_each_facet(
            [&](const RestrictedFacet& facet)
            {
                auto corners = facet.vertices;
                std::sort(corners.begin(), corners.end());
                before.emplace_back(corners, std::sqrt(facet.squared_radius));
                centers.push_back(facet.center);
            });
        const std::size_t chosen = random.below(before.size());
        restricted_.insert(centers[chosen], VertexOrigin::kRefinement);
        std::set<std::array<std::uint32_t, 3>> after;
        for_each_facet(
            [&](const RestrictedFacet& facet)
            {
                auto corners = facet.vertices;
                std::sort(corners.begin(), corners.end());
                after.insert(corners);
            });
        for (const auto& [corners, radius] : before)
        {
            if (radius > 0.5 * before[chosen].second)
                continue;
            ++left;
            EXPECT_TRUE(after.contains(corners));
        }
    }
    EXPECT_GT(left, 1000U);
}

TEST_F(RestrictedToSpheres, umbrellas_are_whole_or_none)
{
    std::size_t umbrellas = 0;
    for (const VertexHandle vertex : restricted_.triangulation().finite_vertex_handles())
    {
        const std::uint32_t index = vertex->info().index;
        restricted_.odd_facets_around(vertex, facets_);
        if (!is_umbrella(restricted_, index, facets_))
            continue;
        ++umbrellas;
        std::vector<FacetId> torn(facets_.begin() + 1, facets_.end());
        EXPECT_FALSE(is_umbrella(restricted_, index, torn));
        std::vector<FacetId> doubled = facets_;
        doubled.insert(doubled.end(), facets_.begin(), facets_.end());
        EXPECT_FALSE(is_umbrella(restricted_, index, doubled));
        std::reverse(facets_.begin(), facets_.end());
        EXPECT_TRUE(is_umbrella(restricted_, index, facets_)) << "the order plays no part";
    }
    EXPECT_GT(umbrellas, 700U) << "800 points sample the spheres densely";
    EXPECT_FALSE(is_umbrella(restricted_, 4, {}));
}

} // namespace
} // namespace voroprobe
