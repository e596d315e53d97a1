#include "certificate/criteria_exceptions.h"

#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"
#include "oracles/sphere_union_oracle.h"

namespace voroprobe
{
namespace
{

//! The faces of an icosahedron in a sphere of radius 10: edges of 10.5146, circumcircles of radius 6.0706,
//! that lie 2.0535 below the sphere; balls of radius 6.4085.
class CriteriaExceptionsTest : public testing::Test
{
protected:
    TriangleMesh mesh_ = sample::icosphere(0, 10.0);
    SphereUnionOracle oracle_{{{{0, 0, 0}, 10.0}}};
};

TEST_F(CriteriaExceptionsTest, are_not_counted_without_a_bound)
{
    const CriteriaExceptions found = count_exceptions(mesh_, oracle_, {});
    EXPECT_EQ(found.angle, std::nullopt);
    EXPECT_EQ(found.size, std::nullopt);
    EXPECT_EQ(found.distance, std::nullopt);
}

TEST_F(CriteriaExceptionsTest, are_none_just_below_the_bounds)
{
    const CriteriaExceptions found = count_exceptions(
        mesh_, oracle_, {.min_angle_deg = 59.9, .max_radius = 6.409, .max_center_distance = 2.054});
    EXPECT_EQ(found.angle, 0U);
    EXPECT_EQ(found.size, 0U);
    EXPECT_EQ(found.distance, 0U);
}

TEST_F(CriteriaExceptionsTest, are_all_faces_just_beyond_the_bounds)
{
    const CriteriaExceptions found = count_exceptions(
        mesh_, oracle_, {.min_angle_deg = 60.1, .max_radius = 6.408, .max_center_distance = 2.053});
    EXPECT_EQ(found.angle, 20U);
    EXPECT_EQ(found.size, 20U);
    EXPECT_EQ(found.distance, 20U);
}

TEST_F(CriteriaExceptionsTest, of_the_radius_know_balls_from_circumcircles)
{
    EXPECT_EQ(count_exceptions(mesh_, oracle_, {.max_radius = 6.2}).size, 20U);
    EXPECT_EQ(count_exceptions(mesh_, oracle_, {.max_radius = 6.5}).size, 0U);
}

TEST_F(CriteriaExceptionsTest, hold_faces_without_area_and_faces_far_from_the_surface)
{
    mesh_.faces.push_back({0, 0, 1});
    EXPECT_EQ(count_exceptions(mesh_, oracle_, {.max_center_distance = 3.0}).distance, 1U);
    sample::append(mesh_, sample::tetrahedron(), {50, 0, 0});
    EXPECT_EQ(count_exceptions(mesh_, oracle_, {.max_center_distance = 3.0}).distance, 5U);
}

} // namespace
} // namespace voroprobe
