#include "oracles/triangle_mesh_oracle.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "../mesh/sample_meshes.h"
#include "concurrent_queries.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "oracle_laws.h"
#include "support/error.h"

namespace voroprobe
{
namespace
{

//! The cube [0, n]^3 as unit squares cut in two, so that edges, diagonals and corners lie on whole
//! coordinates.
TriangleMesh lattice_cube(int n)
{
    TriangleMesh mesh;
    const auto add_square = [&mesh](const Point3& corner, const Vec3& u, const Vec3& v)
    {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {corner, corner + u, corner + u + v, corner + v});
        mesh.faces.push_back({first, first + 1, first + 2});
        mesh.faces.push_back({first, first + 2, first + 3});
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        Vec3 u;
        Vec3 v;
        u[(axis + 1) % 3] = 1.0;
        v[(axis + 2) % 3] = 1.0;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
            {
                const Point3 low = double(i) * u + double(j) * v;
                Point3 high = low;
                high[axis] = n;
                add_square(low, v, u);
                add_square(high, u, v);
            }
    }
    return weld(mesh);
}

Point3 random_lattice_point(Random& random, int lowest, int highest)
{
    const auto whole = [&] { return std::floor(random.uniform(lowest, highest + 1)); };
    const double x = whole();
    const double y = whole();
    return {x, y, whole()};
}

TEST(TriangleMeshOracle, finds_the_crossings_of_a_sphere_where_its_faces_are)
{
    const TriangleMesh sphere = sample::icosphere(3);
    const auto oracle = make_triangle_mesh_oracle(sphere);
    Random random(1);
    std::vector<Crossing> crossings;
    for (int i = 0; i < 20000; ++i)
    {
        const Segment3 segment = random_segment(random, {{-2, -2, -2}, {2, 2, 2}});
        oracle->find_crossings(segment, crossings);
        ASSERT_LE(crossings.size(), 2U) << "the polyhedron is convex";
        for (const Crossing& crossing : crossings)
        {
            ASSERT_LE(norm(crossing.point), 1.0 + 1e-12);
            ASSERT_GE(norm(crossing.point), 0.99) << "the faces' distance from the sphere";
        }
        const double radius = norm(segment.source);
        if (radius < 0.99 || radius > 1.0)
        {
            ASSERT_EQ(is_inside(oracle->region(segment.source)), radius < 1.0);
        }
    }
}

// By the mean over random lines of the length inside: the volume, as Cauchy had it.
TEST(TriangleMeshOracle, chords_of_parallel_lines_add_up_to_the_volume)
{
    const TriangleMesh sphere = sample::icosphere(2);
    const auto oracle = make_triangle_mesh_oracle(sphere);
    std::vector<Crossing> crossings;
    constexpr int kLines = 200;
    double length = 0.0;
    for (int i = 0; i < kLines; ++i)
        for (int j = 0; j < kLines; ++j)
        {
            const double x = (i + 0.5) * 2.0 / kLines - 1.0;
            const double y = (j + 0.5) * 2.0 / kLines - 1.0;
            oracle->find_crossings({{x, y, -2}, {x, y, 2}}, crossings);
            ASSERT_EQ(crossings.size() % 2, 0U);
            for (std::size_t c = 0; c < crossings.size(); c += 2)
                length += crossings[c + 1].point.z - crossings[c].point.z;
        }
    EXPECT_NEAR(length * 4.0 / (kLines * kLines), enclosed_volume(sphere), 0.002);
}

TEST(TriangleMeshOracle, keeps_the_laws_of_oracles)
{
    expect_laws_on_random_segments(*make_triangle_mesh_oracle(sample::icosphere(3)), 2, 20000);
    TriangleMesh shells = sample::icosphere(2);
    sample::append(shells, sample::icosphere(2, 0.5));
    expect_laws_on_random_segments(*make_triangle_mesh_oracle(shells), 3, 20000);
}

// Segments between whole coordinates run through edges and corners, along edges, and within faces.
TEST(TriangleMeshOracle, keeps_the_laws_on_a_hundred_thousand_degenerate_segments)
{
    constexpr int kSide = 3;
    const auto oracle = make_triangle_mesh_oracle(lattice_cube(kSide));
    Random random(4);
    std::vector<Crossing> crossings;
    for (int i = 0; i < 100'000; ++i)
    {
        const Segment3 segment{random_lattice_point(random, -1, kSide + 1),
                               random_lattice_point(random, -1, kSide + 1)};
        oracle->find_crossings(segment, crossings);
        ASSERT_TRUE(keeps_the_laws(*oracle, segment, crossings));
        ASSERT_LE(crossings.size(), 2U) << "the cube is convex";
    }
}

TEST(TriangleMeshOracle, keeps_the_laws_between_corners_and_points_on_faces)
{
    const TriangleMesh sphere = sample::icosphere(2);
    const auto oracle = make_triangle_mesh_oracle(sphere);
    Random random(5);
    std::vector<Crossing> crossings;
    const auto random_place = [&]
    {
        const auto& face = sphere.faces[static_cast<std::size_t>(
            random.uniform(0.0, static_cast<double>(sphere.faces.size())))];
        const double kind = random.uniform(0.0, 3.0);
        if (kind < 1.0)
            return sphere.corner(face, 0);
        if (kind < 2.0)
            return 0.5 * (sphere.corner(face, 0) + sphere.corner(face, 1));
        return (sphere.corner(face, 0) + sphere.corner(face, 1) + sphere.corner(face, 2)) / 3.0;
    };
    for (int i = 0; i < 20000; ++i)
    {
        const Point3 source = random_place();
        const Segment3 segment{source, source + random.uniform(-1.0, 3.0) * (random_place() - source)};
        oracle->find_crossings(segment, crossings);
        ASSERT_TRUE(keeps_the_laws(*oracle, segment, crossings));
    }
}

TEST(TriangleMeshOracle, a_corner_that_is_touched_is_not_crossed)
{
    const auto oracle = make_triangle_mesh_oracle(lattice_cube(1));
    std::vector<Crossing> crossings;
    oracle->find_crossings({{-1, 1, 1}, {1, -1, 1}}, crossings);
    EXPECT_TRUE(keeps_the_laws(*oracle, {{-1, 1, 1}, {1, -1, 1}}, crossings));
    EXPECT_EQ(crossings.size(), 0U) << "at (0, 0, 1)";
    oracle->find_crossings({{-1, 0, 0.5}, {1, -2, 0.5}}, crossings);
    EXPECT_EQ(crossings.size(), 0U);
}

TEST(TriangleMeshOracle, windings_do_not_matter_and_a_piece_within_is_a_cavity)
{
    TriangleMesh shells = sample::icosphere(2);
    sample::append(shells, sample::icosphere(2, 0.5));
    std::swap(shells.faces[7][0], shells.faces[7][1]);
    const auto oracle = make_triangle_mesh_oracle(shells);
    EXPECT_FALSE(is_inside(oracle->region({0, 0, 0})));
    EXPECT_TRUE(is_inside(oracle->region({0.7, 0, 0})));
    EXPECT_FALSE(is_inside(oracle->region({1.1, 0, 0})));
    EXPECT_FALSE(is_inside(oracle->region({std::nan(""), 0, 0})));
    EXPECT_FALSE(is_inside(oracle->region({1e300, 0, 0})));
}

TEST(TriangleMeshOracle, faces_without_area_change_nothing)
{
    TriangleMesh tetrahedron = sample::tetrahedron();
    tetrahedron.vertices.push_back({0.5, 0.5, 0}); // the middle of edge 1-2, split on one side only
    tetrahedron.faces = {{0, 2, 4}, {0, 4, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 4, 2}};
    const auto oracle = make_triangle_mesh_oracle(tetrahedron, "the mesh", MeshChecks::kClosed);
    expect_laws_on_random_segments(*oracle, 6, 5000);
    EXPECT_TRUE(is_inside(oracle->region({0.2, 0.2, 0.2})));
}

TEST(TriangleMeshOracle, certifies_boxes_without_surface)
{
    const auto oracle = make_triangle_mesh_oracle(sample::icosphere(3));
    EXPECT_FALSE(oracle->may_cross({{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}));
    EXPECT_FALSE(oracle->may_cross({{0.8, 0.8, 0.8}, {2, 2, 2}}));
    EXPECT_FALSE(oracle->may_cross(Box3{}));
    EXPECT_TRUE(oracle->may_cross({{0.9, -0.1, -0.1}, {1.1, 0.1, 0.1}}));
    EXPECT_TRUE(oracle->may_cross({{-5, -5, -5}, {5, 5, 5}}));
}

TEST(TriangleMeshOracle, answers_four_threads_at_once_as_it_answers_one)
{
    expect_same_answers_from_four_threads(*make_triangle_mesh_oracle(sample::icosphere(3)), 2000);
}

void expect_refusal(const TriangleMesh& mesh, const std::string& words)
{
    try
    {
        static_cast<void>(make_triangle_mesh_oracle(mesh, "part.stl"));
        ADD_FAILURE() << "not refused: " << words;
    }
    catch (const InputError& error)
    {
        EXPECT_NE(std::string(error.what()).find("part.stl"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

TEST(TriangleMeshOracle, refuses_what_bounds_no_object)
{
    expect_refusal({}, "no faces");
    TriangleMesh open = sample::icosphere(1);
    open.faces.pop_back();
    expect_refusal(open, "not closed: 3 edges");
    TriangleMesh infinite = sample::tetrahedron();
    infinite.vertices[0].x = std::numeric_limits<double>::infinity();
    expect_refusal(infinite, "finite");
    TriangleMesh crossing = sample::icosphere(1);
    sample::append(crossing, sample::icosphere(1), {1.1, 0.2, 0.1});
    expect_refusal(crossing, "crosses itself");
    TriangleMesh twice = sample::tetrahedron();
    sample::append(twice, sample::tetrahedron());
    expect_refusal(twice, "crosses itself");
}

} // namespace
} // namespace voroprobe
