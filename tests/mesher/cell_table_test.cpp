#include "mesher/cell_table.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mesher/cell_shape.h"
#include "mesher/component_update.h"
#include "mesher/restricted_delaunay.h"
#include "oracles/sphere_union_oracle.h"
#include "support/random.h"
#include "surface_distance.h"

namespace voroprobe
{
namespace
{

using Number = CellTable::Number;

//! The Delaunay triangulation of points of two spheres, one in the other.
class CellTables : public testing::Test
{
protected:
    CellTables() { insert(400); }

    void insert(std::size_t count)
    {
        for (const Point3& p : sample_surface(oracle_, count, random_))
            restricted_.insert(p, VertexOrigin::kRefinement);
    }

    void expect_same_as_triangulation(const CellTable& table) const
    {
        ASSERT_EQ(table.size(), restricted_.triangulation().tds().cells().size());
        for (const DelaunayCell delaunay_cell : restricted_.triangulation().all_cell_handles())
        {
            const Number cell = CellTable::number(delaunay_cell);
            ASSERT_LT(cell, table.size());
            ASSERT_EQ(table.cell(cell), delaunay_cell);
            ASSERT_EQ(table.region(cell), delaunay_cell->info().region);
            ASSERT_EQ(table.is_infinite(cell), restricted_.triangulation().is_infinite(delaunay_cell));
            for (int i = 0; i < 4; ++i)
            {
                const auto at = static_cast<std::size_t>(i);
                ASSERT_EQ(table.neighbors(cell)[at], CellTable::number(delaunay_cell->neighbor(i)));
                ASSERT_EQ(table.corners(cell)[at], delaunay_cell->vertex(i)->info().index);
            }
        }
    }

    Random random_{3};
    SphereUnionOracle oracle_{{{{0, 0, 0}, 1.0}, {{0, 0, 0}, 0.5}}};
    MeshingStatistics statistics_;
    RestrictedDelaunay restricted_{oracle_, statistics_};
};

TEST_F(CellTables, take_in_what_insertions_have_done)
{
    CellTable table(restricted_.triangulation(), Workers(1));
    expect_same_as_triangulation(table);
    for (const std::size_t count : {1U, 10U, 300U})
    {
        const std::size_t first_new_vertex = restricted_.vertex_index_bound();
        insert(count);
        const auto made = table.update();
        ASSERT_TRUE(made);
        const std::set<Number> is_new(made->begin(), made->end());
        for (Number cell = 0; cell < table.size(); ++cell)
        {
            const auto& corners = table.corners(cell);
            EXPECT_EQ(is_new.contains(cell),
                      std::any_of(corners.begin(), corners.end(),
                                  [&](std::uint32_t corner) { return corner >= first_new_vertex; }));
        }
        expect_same_as_triangulation(table);
    }
}

TEST_F(CellTables, keep_the_regions_of_cells_that_stay_and_give_them_back)
{
    CellTable table(restricted_.triangulation(), Workers(1));
    std::map<DelaunayCell, Region> raw;
    for (Number cell = 0; cell < table.size(); cell += 5)
    {
        raw[table.cell(cell)] = table.region(cell);
        table.set_region(cell, 7);
        table.set_region(cell, 8);
    }
    table.give_back_regions();
    for (const auto& [delaunay_cell, region] : raw)
        EXPECT_EQ(delaunay_cell->info().region, region);

    insert(10);
    const auto made = table.update();
    ASSERT_TRUE(made);
    const std::set<Number> is_new(made->begin(), made->end());
    expect_same_as_triangulation(table);
    for (Number cell = 0; cell < table.size(); ++cell)
        EXPECT_EQ(table.region(cell) == 8, raw.contains(table.cell(cell)) && !is_new.contains(cell));

    table.undo_changes_after(0);
    for (Number cell = 0; cell < table.size(); ++cell)
        EXPECT_NE(table.region(cell), 8);
    expect_same_as_triangulation(table);
}

//! Whether the two tell the same cells apart.
bool same_parts(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b)
{
    std::map<std::uint32_t, std::uint32_t> b_of_a;
    std::map<std::uint32_t, std::uint32_t> a_of_b;
    for (std::size_t c = 0; c < a.size(); ++c)
    {
        if (b_of_a.try_emplace(a[c], b[c]).first->second != b[c] ||
            a_of_b.try_emplace(b[c], a[c]).first->second != a[c])
            return false;
    }
    return true;
}

TEST_F(CellTables, components_brought_up_to_date_are_those_found_anew)
{
    CellTable table(restricted_.triangulation(), Workers(1));
    for (Number cell = 0; cell < table.size(); ++cell)
        table.set_region(cell,
                         !table.is_infinite(cell) && norm(centroid(corner_positions(table.cell(cell)))) < 0.7
                             ? 1
                             : kOuterRegion);
    ASSERT_EQ(find_region_components(table).components.size(), 2U);

    std::size_t told = 0;
    std::size_t in_pieces = 0;
    for (int trial = 0; trial < 2000; ++trial)
    {
        const RegionComponents before = find_region_components(table);
        const std::size_t changes = table.changes().size();
        std::vector<Number> changed;
        for (int i = 0; i < 3; ++i)
        {
            const auto cell = static_cast<Number>(random_.below(table.size()));
            const Region beyond = table.region(table.neighbors(cell)[0]);
            if (table.is_infinite(cell) || beyond == table.region(cell))
                continue;
            table.set_region(cell, beyond);
            changed.push_back(cell);
        }
        RegionComponents updated = before;
        const RegionComponents found = find_region_components(table);
        if (!changed.empty() && update_components(table, changed, updated))
        {
            ++told;
            in_pieces += found.components.size() > 2 ? 1 : 0;
            EXPECT_TRUE(same_parts(updated.of_cell, found.of_cell)) << trial;
        }
        if (found.components.size() > 2)
            table.undo_changes_after(changes);
    }
    EXPECT_GT(told, 100U);
    EXPECT_GT(in_pieces, 0U);
}

} // namespace
} // namespace voroprobe
