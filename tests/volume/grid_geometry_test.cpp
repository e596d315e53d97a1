#include "volume/grid_geometry.h"

#include <limits>

#include <gtest/gtest.h>

#include "stored_orders.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

constexpr double kRounding = 1e-9; // mm

GridGeometry geometry_of(const StoredLattice& lattice)
{
    return make_grid_geometry(lattice, canonical_axis_order(lattice.direction));
}

void expect_near(const Point3& a, const Point3& b, const char* what)
{
    EXPECT_NEAR(a.x, b.x, kRounding) << what;
    EXPECT_NEAR(a.y, b.y, kRounding) << what;
    EXPECT_NEAR(a.z, b.z, kRounding) << what;
}

Point3 world_position(const StoredLattice& lattice, const Point3& p_source_index)
{
    const Vec3 scaled{p_source_index.x * lattice.spacing.x, p_source_index.y * lattice.spacing.y,
                      p_source_index.z * lattice.spacing.z};
    return lattice.origin + lattice.direction * scaled;
}

StoredLattice small_lattice()
{
    return {.size = {2, 3, 4}};
}

TEST(GridGeometry, upright_axes_stay_as_they_are)
{
    EXPECT_TRUE(canonical_axis_order(Matrix3{}).is_identity());
}

TEST(GridGeometry, the_grid_frame_is_never_mirrored)
{
    for (const Matrix3& rotation :
         {Matrix3{}, rotation_about({1, 0, 0}, 16.5), rotation_about({1, 2, 3}, 77.0)})
        for (const StoredOrder& order : all_orders())
        {
            const GridGeometry geometry = geometry_of(store({.rotation = rotation}, order).lattice);
            EXPECT_NEAR(determinant(geometry.world_from_grid.linear), 1.0, 1e-14);
        }
}

TEST(GridGeometry, grid_axes_are_as_near_to_world_axes_as_they_can_be)
{
    const Phantom phantom{.rotation = rotation_about({1, 2, 3}, 30.0)};
    for (const StoredOrder& order : all_orders())
    {
        const GridGeometry geometry = geometry_of(store(phantom, order).lattice);
        for (std::size_t axis = 0; axis < 3; ++axis)
            expect_near(geometry.world_from_grid.linear.column[axis], phantom.rotation.column[axis], "axis");
    }
}

TEST(GridGeometry, every_order_of_a_lattice_turned_by_half_a_right_angle_has_the_same_grid)
{
    const Phantom phantom{.rotation = rotation_about({0, 0, 1}, 45.0)};
    const GridGeometry expected = geometry_of(store(phantom, all_orders().front()).lattice);
    for (const StoredOrder& order : all_orders())
    {
        const GridGeometry geometry = geometry_of(store(phantom, order).lattice);
        EXPECT_EQ(geometry.size, expected.size);
        expect_near(geometry.world_from_grid.translation, expected.world_from_grid.translation,
                    "first sample");
    }
}

TEST(GridGeometry, source_indices_lead_back_to_the_positions_of_the_file)
{
    const Phantom phantom{.rotation = rotation_about({1, 2, 3}, 77.0)};
    for (const StoredOrder& order : all_orders({7, -3, 40}))
    {
        const StoredLattice lattice = store(phantom, order).lattice;
        const GridGeometry geometry = geometry_of(lattice);
        for (const Point3& p_grid : {Point3{0, 0, 0}, Point3{1.5, 0.25, 2.0}, geometry.grid_box().max})
            expect_near(geometry.world_from_grid * p_grid,
                        world_position(lattice, geometry.source_index_from_grid * p_grid), "position");
    }
}

TEST(GridGeometry, the_first_stored_sample_has_the_start_index)
{
    StoredLattice lattice = small_lattice();
    lattice.start = {5, 6, 7};
    const GridGeometry geometry = geometry_of(lattice);
    expect_near(geometry.source_index_from_grid * Point3{0, 0, 0}, {5, 6, 7}, "start");
    expect_near(geometry.world_from_grid * Point3{0, 0, 0}, {5, 6, 7}, "world");
}

TEST(GridGeometry, nearly_orthonormal_cosines_are_made_so)
{
    StoredLattice lattice = small_lattice();
    lattice.direction.column[0] = {1.0, 4e-4, 0.0};
    lattice.direction.column[2] = {0.0, 3e-4, 1.0002};
    const Matrix3 rotation = geometry_of(lattice).world_from_grid.linear;
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b)
            EXPECT_NEAR(dot(rotation.column[a], rotation.column[b]), a == b ? 1.0 : 0.0, 1e-15);
}

TEST(GridGeometry, bad_lattices_are_refused)
{
    const auto refuses = [](const auto& spoil)
    {
        StoredLattice lattice = small_lattice();
        spoil(lattice);
        EXPECT_THROW(geometry_of(lattice), InputError);
    };
    refuses([](StoredLattice& lattice) { lattice.size[1] = 0; });
    refuses([](StoredLattice& lattice) { lattice.spacing.y = 0.0; });
    refuses([](StoredLattice& lattice) { lattice.spacing.z = -1.0; });
    refuses([](StoredLattice& lattice) { lattice.spacing.x = std::numeric_limits<double>::infinity(); });
    refuses([](StoredLattice& lattice) { lattice.origin.x = std::numeric_limits<double>::quiet_NaN(); });
    refuses([](StoredLattice& lattice) { lattice.direction.column[0] = {0, 0, 0}; });
    refuses([](StoredLattice& lattice) { lattice.direction.column[0] = {1.0, 0.3, 0.0}; });
    refuses([](StoredLattice& lattice)
            { lattice.direction.column[1].y = std::numeric_limits<double>::quiet_NaN(); });
}

} // namespace

} // namespace voroprobe
