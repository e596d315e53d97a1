#include "cli/file_lattice.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "volume/grid_geometry.h"

namespace voroprobe
{
namespace
{

FileLattice there_and_back(const StoredLattice& stored)
{
    const GridGeometry grid = make_grid_geometry(stored, canonical_axis_order(stored.direction));
    return file_lattice(grid.size, {grid.world_from_grid, grid.source_index_from_grid});
}

void expect_near(const Vec3& a, const Vec3& b)
{
    EXPECT_NEAR(distance(a, b), 0.0, 1e-12) << a.x << ' ' << a.y << ' ' << a.z;
}

//! Columns of a rotation about x.
Matrix3 rotation_about_x(double degrees)
{
    const double c = std::cos(degrees * std::numbers::pi / 180.0);
    const double s = std::sin(degrees * std::numbers::pi / 180.0);
    return {{Vec3{1, 0, 0}, Vec3{0, c, s}, Vec3{0, -s, c}}};
}

TEST(FileLattice, is_what_the_file_said_whatever_the_canonical_grid_made_of_it)
{
    const Matrix3 permuted{{Vec3{0, 0, -1}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}};
    const Matrix3 left_handed{{Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}};
    for (const Matrix3& direction : {Matrix3{}, permuted, left_handed, rotation_about_x(16.5)})
    {
        const FileLattice lattice = there_and_back(
            {.size = {3, 5, 7}, .spacing = {0.5, 1.0, 3.0}, .direction = direction, .origin = {1, 2, 3}});
        EXPECT_EQ(lattice.size, (std::array<std::size_t, 3>{3, 5, 7}));
        expect_near(lattice.spacing, {0.5, 1.0, 3.0});
        expect_near(lattice.origin, {1, 2, 3});
        for (std::size_t axis = 0; axis < 3; ++axis)
            expect_near(lattice.direction.column[axis], direction.column[axis]);
    }
}

TEST(FileLattice, letters_say_where_the_axes_run)
{
    EXPECT_EQ(orientation_letters({}), "LPS");
    EXPECT_EQ(orientation_letters({{Vec3{-1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}}), "RAS");
    EXPECT_EQ(orientation_letters({{Vec3{0, 0, -1}, Vec3{0.9, 0.1, 0}, Vec3{0, 1, 0}}}), "ILP");
}

TEST(FileLattice, obliqueness_is_the_angle_of_the_rotation)
{
    EXPECT_NEAR(obliqueness_deg({}), 0.0, 1e-9);
    EXPECT_NEAR(obliqueness_deg(rotation_about_x(16.5)), 16.5, 1e-9);
}

} // namespace
} // namespace voroprobe
