#include <cmath>
#include <cstdlib>

#include "io/mesh_reader.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "program_fixture.h"

namespace voroprobe
{
namespace
{

using program::run;

//! Formats store 32-bit floats at worst; coordinates here stay below 100.
constexpr double kRounding = 1e-4;

//! A ball off center on an oblique, left-handed, anisotropic lattice that begins far from the world's origin.
Phantom oblique_phantom()
{
    Phantom phantom;
    phantom.size = {20, 24, 16};
    phantom.spacing = {1.0, 0.8, 1.4};
    phantom.direction = {{Vec3{-0.8, 0.6, 0}, Vec3{0.6, 0.8, 0}, Vec3{0, 0, 1}}};
    phantom.origin = {30, -40, 50};
    phantom.field = ball(world_from_index(phantom) * Point3{10, 13, 8}, 6.0);
    return phantom;
}

class OutputTest : public ProgramTest
{
protected:
    TriangleMesh meshed(const std::string& input, const std::string& output,
                        const std::vector<std::string>& more = {})
    {
        std::vector<std::string> arguments{"mesh",           folder_ / input, "-o",
                                           folder_ / output, "--isovalue",    "0"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const auto outcome = run(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return read_mesh(folder_ / output);
    }
};

TEST_F(OutputTest, frames_of_reference_agree_and_all_wind_outward)
{
    const Phantom phantom = oblique_phantom();
    write_phantom(phantom, folder_ / "oblique.mha");
    const TriangleMesh lps = meshed("oblique.mha", "lps.ply");
    const TriangleMesh ras = meshed("oblique.mha", "ras.ply", {"--frame-of-reference", "ras"});
    const TriangleMesh index = meshed("oblique.mha", "index.ply", {"--frame-of-reference", "index"});

    ASSERT_EQ(lps.vertices.size(), ras.vertices.size());
    ASSERT_EQ(lps.vertices.size(), index.vertices.size());
    const AffineTransform to_world = world_from_index(phantom);
    for (std::size_t i = 0; i < lps.vertices.size(); ++i)
    {
        const Point3& p = lps.vertices[i];
        EXPECT_LT(distance(ras.vertices[i], {-p.x, -p.y, p.z}), kRounding);
        EXPECT_LT(distance(to_world * index.vertices[i], p), kRounding);
    }
    for (const TriangleMesh* mesh : {&lps, &ras, &index})
    {
        EXPECT_TRUE(is_closed_manifold(*mesh));
        EXPECT_GT(enclosed_volume(*mesh), 0.0);
    }
}

TEST_F(OutputTest, the_mesh_lies_where_the_header_says)
{
    const Phantom phantom = oblique_phantom();
    write_phantom(phantom, folder_ / "oblique.mha");
    const Point3 center = world_from_index(phantom) * Point3{10, 13, 8};
    for (const Point3& p : meshed("oblique.mha", "out.ply").vertices)
        EXPECT_NEAR(distance(p, center), 6.0, 0.2); // the trilinear interpolant of a ball is nearly one
}

TEST_F(OutputTest, every_format_is_written_closed)
{
    for (const char* name : {"out.stl", "out.ply", "out.obj", "out.off", "out.vtp", "out.3mf"})
    {
        const TriangleMesh mesh = meshed("ball.mha", name);
        EXPECT_TRUE(is_closed_manifold(mesh)) << name;
        EXPECT_EQ(count_components(mesh), 1U) << name;
    }
}

TEST_F(OutputTest, format_overrides_the_extension)
{
    EXPECT_EQ(run(mesh_ball("mesh.dat", {"--format", "stl-ascii"})).status, 0);
    EXPECT_TRUE(program::read_text(folder_ / "mesh.dat").starts_with("solid"));
    EXPECT_EQ(run(mesh_ball("mesh.stl", {"--format", "off"})).status, 0);
    EXPECT_TRUE(program::read_text(folder_ / "mesh.stl").starts_with("OFF"));
}

TEST_F(OutputTest, two_runs_give_the_same_bytes_whatever_the_seed_and_threads)
{
    for (const char* extension : {".stl", ".ply"})
    {
        EXPECT_EQ(run(mesh_ball(std::string("a") + extension)).status, 0);
        EXPECT_EQ(run(mesh_ball(std::string("b") + extension, {"--seed", "12345", "--threads", "2"})).status,
                  0);
        EXPECT_EQ(program::read_text(folder_ / (std::string("a") + extension)),
                  program::read_text(folder_ / (std::string("b") + extension)));
    }
}

TEST_F(OutputTest, spacing_can_be_given)
{
    const double once =
        enclosed_volume(meshed("ball.mha", "once.ply", {"--size", "1.5", "--distance", "0.1"}));
    const double twice = enclosed_volume(
        meshed("ball.mha", "twice.ply", {"--spacing", "2,2,2", "--size", "3", "--distance", "0.2"}));
    EXPECT_NEAR(twice / once, 8.0, 0.08);
}

TEST_F(OutputTest, inside_below_turns_the_object_over)
{
    Phantom signed_distance = ball_phantom();
    signed_distance.field = [](const Point3& p) { return distance(p, {11.5, 11.5, 11.5}) - 8.0; };
    write_phantom(signed_distance, folder_ / "distance.mha");

    const double ball_volume = 4.0 / 3.0 * 3.14159265 * 512.0;
    EXPECT_NEAR(enclosed_volume(meshed("distance.mha", "below.ply",
                                       {"--inside", "below", "--size", "1", "--distance", "0.1"})),
                ball_volume, 0.05 * ball_volume);
    const auto above =
        run({"mesh", folder_ / "distance.mha", "-o", folder_ / "above.ply", "--isovalue", "0"});
    EXPECT_EQ(above.status, 0) << above.err;
    EXPECT_NE(above.err.find("voroprobe: warning: 100 % of the samples on the border"), std::string::npos)
        << above.err;
    EXPECT_NEAR(enclosed_volume(read_mesh(folder_ / "above.ply")), 23.0 * 23.0 * 23.0 - ball_volume,
                0.05 * 12167.0);
}

TEST_F(OutputTest, an_open_border_leaves_the_object_open_where_it_is_cut)
{
    Phantom cut = ball_phantom();
    cut.field = ball({0.0, 11.5, 11.5}, 8.0);
    write_phantom(cut, folder_ / "cut.mha");
    EXPECT_TRUE(is_closed_manifold(meshed("cut.mha", "closed.ply")));
    const MeshTopology open = analyze_topology(meshed("cut.mha", "open.ply", {"--border", "open"}));
    EXPECT_FALSE(open.closed());
    EXPECT_TRUE(open.manifold());
    EXPECT_TRUE(open.oriented());
}

TEST_F(OutputTest, samples_that_are_not_numbers_are_warned_of_and_left_outside)
{
    Phantom holed = ball_phantom();
    const auto whole = holed.field;
    holed.field = [whole](const Point3& p) { return p == Point3{2, 2, 2} ? std::nan("") : whole(p); };
    write_phantom(holed, folder_ / "holed.mha");
    const auto outcome = run({"mesh", folder_ / "holed.mha", "-o", folder_ / "out.stl", "--isovalue", "0"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("voroprobe: warning: 1 NaN and 0 infinite"), std::string::npos) << outcome.err;
}

TEST_F(OutputTest, a_level_set_in_a_vdb_file_needs_no_option)
{
    const char* named = std::getenv("VOROPROBE_DATA");
    const std::filesystem::path data = named != nullptr ? named : VOROPROBE_SOURCE_DIR "/../shared/data";
    const std::filesystem::path path = data / "sphere_levelset.vdb";
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << "no " << path;
    const auto outcome = run({"mesh", path, "-o", folder_ / "sphere.ply"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const TriangleMesh mesh = read_mesh(folder_ / "sphere.ply");
    EXPECT_TRUE(is_closed_manifold(mesh));
    EXPECT_EQ(count_components(mesh), 1U);
    EXPECT_NEAR(enclosed_volume(mesh), 4.0 / 3.0 * 3.14159265 * 27.0, 1.0); // radius 3
    EXPECT_NE(run({"info", path}).out.find("level set"), std::string::npos);
}

TEST_F(OutputTest, the_report_tells_values_used_and_what_was_found)
{
    const auto outcome = run({"mesh", folder_ / "ball.mha", "-o", folder_ / "out.stl"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    for (const char* part : {"24 x 24 x 24 voxels of 1 x 1 x 1 mm", "(Otsu)",
                             "size 2 mm, angle 30 deg, distance 0.3 mm, floor 0.25 mm, reach 1 mm", "1 found",
                             "closed, manifold, oriented, Euler characteristic 2", "faces below 30 deg",
                             "mm2, volume", "(lps)", "peak memory", "out.stl"})
        EXPECT_NE(outcome.out.find(part), std::string::npos) << part << " is not in:\n" << outcome.out;
}

} // namespace
} // namespace voroprobe
