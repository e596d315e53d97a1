#include "mesher/seeded_mesher.h"

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/measures.h"
#include "mesh/topology.h"
#include "oracles/implicit_oracle.h"
#include "oracles/sphere_union_oracle.h"
#include "oracles/trilinear_oracle.h"
#include "self_intersections.h"
#include "support/error.h"
#include "volume/phantoms.h"

namespace voroprobe
{
namespace
{

constexpr MeshingOptions kOptions{
    .max_facet_radius = 0.5, .max_facet_distance = 0.02, .floor_radius = 0.05, .reach_lower_bound = 0.5};

SphereUnionOracle shell()
{
    return SphereUnionOracle({{{0, 0, 0}, 10.0}, {{0, 0, 0}, 7.0}});
}

//! Asks to stop once it has heard of `vertices` vertices.
class StopAt : public ProgressSink
{
public:
    explicit StopAt(std::size_t vertices) : vertices_(vertices) {}
    void report(const ProgressReport& report) override
    {
        ++reports_;
        stop_ = stop_ || report.vertices >= vertices_;
    }
    [[nodiscard]] bool stop_requested() const override { return stop_; }
    [[nodiscard]] std::size_t reports() const { return reports_; }

private:
    std::size_t vertices_;
    std::size_t reports_ = 0;
    bool stop_ = false;
};

void expect_sound(const TriangleMesh& mesh)
{
    EXPECT_TRUE(is_closed_manifold(mesh));
    EXPECT_TRUE(is_closed_manifold(weld(mesh)));
    EXPECT_TRUE(find_self_intersections(mesh).empty());
}

TEST(Stopping, a_run_interrupted_anywhere_is_closed)
{
    for (const std::size_t vertices : {0U, 1000U, 4000U})
    {
        StopAt sink(vertices);
        const MeshingResult result = mesh_surface(shell(), kOptions, &sink);
        EXPECT_EQ(result.status, MeshingStatus::kInterrupted);
        EXPECT_LE(result.mesh.vertices.size(), vertices + 2048);
        expect_sound(result.mesh);
    }
}

TEST(Stopping, a_sink_that_never_stops_changes_nothing)
{
    StopAt sink(std::numeric_limits<std::size_t>::max());
    const MeshingResult watched = mesh_surface(shell(), kOptions, &sink);
    EXPECT_EQ(watched.status, MeshingStatus::kDone);
    EXPECT_GE(sink.reports(), watched.mesh.vertices.size() / 4096);
    const MeshingResult alone = mesh_surface(shell(), kOptions);
    EXPECT_EQ(watched.mesh.vertices, alone.mesh.vertices);
    EXPECT_EQ(watched.mesh.faces, alone.mesh.faces);
}

TEST(Stopping, a_spent_budget_leaves_a_closed_mesh)
{
    std::vector<std::size_t> budgets{1, 3, 4, 5, 10, 50, 200, 2000};
    for (std::size_t budget = 280; budget <= 430;
         budget += 10) // here both spheres are coarse and touch everywhere
        budgets.push_back(budget);
    for (const std::size_t budget : budgets)
    {
        SCOPED_TRACE(budget);
        MeshingOptions options = kOptions;
        options.max_vertices = budget;
        const MeshingResult result = mesh_surface(shell(), options);
        EXPECT_EQ(result.status, MeshingStatus::kBudgetExhausted);
        EXPECT_LE(result.statistics.insertions, budget + 2); // an initialization adds two points at once
        expect_sound(result.mesh);
    }
}

TEST(Stopping, a_budget_that_is_not_reached_is_not_exhausted)
{
    MeshingOptions options = kOptions;
    options.max_vertices = 1'000'000;
    EXPECT_EQ(mesh_surface(shell(), options).status, MeshingStatus::kDone);
}

TEST(Stopping, no_surface_gives_an_empty_mesh)
{
    const ImplicitOracle nothing([](const Point3&) { return -1.0; }, {{0, 0, 0}, {9, 9, 9}}, 1.0, 1e-3);
    const MeshingResult result = mesh_surface(nothing, kOptions);
    EXPECT_EQ(result.status, MeshingStatus::kDone);
    EXPECT_TRUE(result.mesh.vertices.empty());
    EXPECT_TRUE(result.mesh.faces.empty());
}

// The middle of the domain is the circumcenter of the sentinels.
TEST(Stopping, a_speck_in_the_middle_that_no_probe_meets_gives_an_empty_mesh)
{
    const ImplicitOracle speck([](const Point3& p) { return 0.001 - norm(p); }, {{-1, -1, -1}, {1, 1, 1}},
                               1.0, 1e-3);
    EXPECT_TRUE(mesh_surface(speck, kOptions).mesh.faces.empty());
}

TEST(Options, outside_their_range_are_refused_by_name)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    struct Case
    {
        std::string option;
        std::function<void(MeshingOptions&, double)> set;
        std::vector<double> refused;
    };
    const std::vector<Case> cases{
        {"max_facet_radius", [](auto& o, double v) { o.max_facet_radius = v; }, {0.0, -1.0, nan, infinity}},
        {"max_facet_distance",
         [](auto& o, double v) { o.max_facet_distance = v; },
         {0.0, -1.0, nan, infinity}},
        {"min_facet_angle_deg",
         [](auto& o, double v) { o.min_facet_angle_deg = v; },
         {-1.0, 30.1, nan, infinity}},
        {"floor_radius", [](auto& o, double v) { o.floor_radius = v; }, {0.0, -1.0, nan, infinity}},
        {"reach_lower_bound",
         [](auto& o, double v) { o.reach_lower_bound = v; },
         {0.0, -1.0, nan, infinity}}};
    for (const Case& refused : cases)
        for (const double value : refused.refused)
        {
            SCOPED_TRACE(refused.option + " = " + std::to_string(value));
            MeshingOptions options = kOptions;
            refused.set(options, value);
            try
            {
                mesh_surface(shell(), options);
                ADD_FAILURE() << "accepted";
            }
            catch (const UsageError& error)
            {
                EXPECT_NE(std::string(error.what()).find(refused.option), std::string::npos) << error.what();
            }
        }
}

// --- the border of the domain -----------------------------------------------------------------------

//! Which sides of the box a point lies on, a bit each, to within `tolerance`.
unsigned sides_of(const Box3& box, const Point3& p, double tolerance)
{
    unsigned sides = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        if (std::abs(p[axis] - box.min[axis]) <= tolerance)
            sides |= 1U << (2 * axis);
        if (std::abs(p[axis] - box.max[axis]) <= tolerance)
            sides |= 2U << (2 * axis);
    }
    return sides;
}

constexpr double kOnSide = 1e-9; // scan units, rounding of coordinates around 10

//! A slanted cylinder through two opposite sides of the box.
std::unique_ptr<SurfaceOracle> tube()
{
    const auto radius = [](const Point3& p)
    { return 3.0 - std::hypot(p.x - 5.0, p.y - 5.0 - 0.1 * (p.z - 5.0)); };
    return make_trilinear_oracle(std::make_shared<Volume>(sample_volume(radius, {11, 11, 11}, {1, 1, 1})),
                                 0.0);
}

constexpr MeshingOptions kTubeOptions{
    .max_facet_radius = 0.8, .max_facet_distance = 0.05, .floor_radius = 0.2, .reach_lower_bound = 0.5};

TEST(Border, is_closed_by_default)
{
    const auto oracle = tube();
    const TriangleMesh mesh = mesh_surface(*oracle, kTubeOptions).mesh;
    expect_sound(mesh);
    EXPECT_EQ(euler_characteristic(mesh), 2);
}

TEST(Border, left_open_leaves_the_surface_without_its_caps)
{
    const auto oracle = tube();
    MeshingOptions options = kTubeOptions;
    options.close_border = false;
    const TriangleMesh mesh = mesh_surface(*oracle, options).mesh;
    const MeshTopology topology = analyze_topology(mesh);
    EXPECT_TRUE(topology.manifold());
    EXPECT_TRUE(topology.oriented());
    EXPECT_EQ(topology.unused_vertices, 0U);
    EXPECT_EQ(topology.components, 1U);
    EXPECT_EQ(topology.euler_characteristic, 0);
    EXPECT_GT(topology.boundary_edges, 0U);

    const Box3 box = oracle->domain();
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> faces_on_edge;
    for (const TriangleMesh::Face& face : mesh.faces)
    {
        EXPECT_EQ(sides_of(box, mesh.corner(face, 0), kOnSide) &
                      sides_of(box, mesh.corner(face, 1), kOnSide) &
                      sides_of(box, mesh.corner(face, 2), kOnSide),
                  0U);
        for (std::size_t i = 0; i < 3; ++i)
            ++faces_on_edge[std::minmax(face[i], face[(i + 1) % 3])];
    }
    // The rim of the caps is a crease that the mesh cuts off by at most the distance bound, or by the floor.
    const double near_border = *options.max_facet_distance + options.floor_radius;
    for (const auto& [edge, faces] : faces_on_edge)
        if (faces == 1)
        {
            EXPECT_NE(sides_of(box, mesh.vertices[edge.first], near_border) &
                          sides_of(box, mesh.vertices[edge.second], near_border),
                      0U);
        }
}

} // namespace
} // namespace voroprobe
