#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "certificate/mesh_distance.h"
#include "io/mesh_reader.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "program_fixture.h"

namespace voroprobe
{
namespace
{

namespace fs = std::filesystem;

//! Of coordinates below 100 in 32 bits.
constexpr double kRounding = 1e-5;

//! A ball with a cavity, and a small ball beside it.
Phantom shell_and_ball()
{
    Phantom phantom;
    phantom.field = [](const Point3& p)
    {
        const double r = distance(p, {9.0, 9.0, 9.0});
        return std::max(std::min(7.0 - r, r - 3.5), 2.0 - distance(p, {18, 18, 18}));
    };
    return phantom;
}

class ProcessTest : public ProgramTest
{
protected:
    void SetUp() override
    {
        ProgramTest::SetUp();
        write_phantom(shell_and_ball(), folder_ / "scan.mha");
        const program::Outcome outcome =
            program::run({"mesh", folder_ / "scan.mha", "-o", mesh(), "--isovalue", "0", "-q"});
        ASSERT_EQ(outcome.status, 0) << outcome.err;
    }

    [[nodiscard]] std::string mesh() const { return folder_ / "scan.ply"; }

    [[nodiscard]] program::Outcome process(const std::string& out, std::vector<std::string> more) const
    {
        std::vector<std::string> arguments{"process",     mesh(),      "-o",
                                           folder_ / out, "--summary", folder_ / "summary.json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return program::run(arguments);
    }

    [[nodiscard]] nlohmann::json summary() const
    {
        return nlohmann::json::parse(program::read_text(folder_ / "summary.json"));
    }
};

TEST_F(ProcessTest, steps_come_in_one_order_and_are_told)
{
    const program::Outcome outcome =
        process("out.stl", {"--on-bed", "--relax", "--decimate", "60%", "--keep-largest", "1", "--repair"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    std::vector<std::string> names;
    const nlohmann::json told = summary();
    for (const auto& step : told["steps"])
        names.push_back(step["step"]);
    EXPECT_EQ(names, (std::vector<std::string>{"repair", "bodies", "decimate", "relax"}));
    for (const std::string& name : names)
        EXPECT_NE(outcome.out.find("  " + name), std::string::npos) << outcome.out;
    const TriangleMesh result = read_mesh(folder_ / "out.stl");
    EXPECT_TRUE(is_closed_manifold(result));
    EXPECT_EQ(count_components(result), 2U); // the shell and its cavity
    EXPECT_NEAR(bounding_box(result).min.z, 0.0, 1e-5);
    EXPECT_NEAR(bounding_box(result).center().x, 0.0, 1e-5);
}

TEST_F(ProcessTest, a_step_that_would_break_a_promise_stops_and_says_so)
{
    const program::Outcome outcome = process("out.stl", {"--smooth", "50", "--max-distance", "0.001"});
    EXPECT_EQ(outcome.status, 5);
    EXPECT_NE(outcome.err.find("step 'smooth'"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("--max-distance"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(folder_ / "out.stl"));
}

TEST_F(ProcessTest, bodies_are_split_into_files_and_objects)
{
    ASSERT_EQ(process("new/body{n}.stl", {"--split", "--sort"}).status, 0);
    const double first = enclosed_volume(read_mesh(folder_ / "new/body1.stl"));
    EXPECT_GT(first, enclosed_volume(read_mesh(folder_ / "new/body2.stl")));
    EXPECT_FALSE(fs::exists(folder_ / "new/body3.stl"));

    ASSERT_EQ(process("bodies.3mf", {"--split", "--sort"}).status, 0);
    const std::vector<MeshPart> parts = read_parts(folder_ / "bodies.3mf");
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].name, "body 1");
    EXPECT_NEAR(enclosed_volume(parts[0].mesh), first, 1e-3 * first);
}

TEST_F(ProcessTest, file_names_that_are_no_utf8_do_not_break_the_json_of_any_command)
{
    const std::string latin = "c\xF4te";
    const std::string json = folder_ / "told.json";
    fs::copy_file(folder_ / "scan.mha", folder_ / (latin + ".mha"));
    const std::string scan = folder_ / (latin + ".mha");
    const std::string made = folder_ / (latin + ".ply");
    const std::vector<std::vector<std::string>> commands{
        {"mesh", scan, "-o", made, "--isovalue", "0", "--summary", json},
        {"check", made, "--json", json},
        {"process", made, "-o", folder_ / (latin + ".obj"), "--center", "--summary", json}};
    for (const auto& command : commands)
    {
        const program::Outcome outcome = program::run(command);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_NE(nlohmann::json::parse(program::read_text(json)).dump().find("c\xEF\xBF\xBDte"),
                  std::string::npos)
            << command[0];
    }
    const program::Outcome told = program::run({"info", scan, "--json"});
    EXPECT_EQ(told.status, 0) << told.err;
    EXPECT_TRUE(nlohmann::json::accept(told.out));
}

TEST_F(ProcessTest, no_file_of_a_pattern_overwrites_the_mesh_or_the_summary)
{
    for (const std::string number : {"1", "2"})
    {
        const std::string input = folder_ / ("body" + number + ".ply");
        fs::copy_file(mesh(), input);
        const std::string before = program::read_text(input);
        const program::Outcome outcome =
            program::run({"process", input, "-o", folder_ / "body{n}.ply", "--split"});
        EXPECT_EQ(outcome.status, 2) << outcome.err;
        EXPECT_NE(outcome.err.find("OUT for body " + number), std::string::npos) << outcome.err;
        EXPECT_NE(outcome.err.find("and MESH are both " + input), std::string::npos) << outcome.err;
        EXPECT_EQ(program::read_text(input), before);
        fs::remove(input);
    }
    EXPECT_EQ(process("summary{n}.json", {"--split", "--format", "ply"}).status, 0); // no such number
    const program::Outcome outcome = program::run(
        {"process", mesh(), "-o", folder_ / "body{n}.ply", "--split", "--summary", folder_ / "body2.ply"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find("--summary and OUT for body 2"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(folder_ / "body1.ply"));
}

TEST_F(ProcessTest, a_mesh_is_moved_as_it_is_told)
{
    const Box3 before = bounding_box(read_mesh(mesh()));
    ASSERT_EQ(process("out.ply", {"--unit", "cm", "--rotate", "z:90", "--translate", "100,0,0"}).status, 0);
    const Box3 after = bounding_box(read_mesh(folder_ / "out.ply"));
    EXPECT_NEAR(after.min.x, 100.0 - 10.0 * before.max.y, 1e-3);
    EXPECT_NEAR(after.max.y, 10.0 * before.max.x, 1e-3);
    EXPECT_NEAR(after.max.z, 10.0 * before.max.z, 1e-3);
}

TEST_F(ProcessTest, a_hollow_has_the_wall_asked_for_and_a_way_out)
{
    ASSERT_EQ(process("closed.stl", {"--keep-largest", "1", "--drop-cavities", "--hollow", "2"}).status, 0);
    const TriangleMesh closed = read_mesh(folder_ / "closed.stl");
    EXPECT_TRUE(is_closed_manifold(closed));
    EXPECT_EQ(count_components(closed), 2U);
    const program::Outcome outcome =
        process("open.stl", {"--keep-largest", "1", "--drop-cavities", "--hollow", "2", "--drain", "2"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const TriangleMesh open = read_mesh(folder_ / "open.stl");
    EXPECT_TRUE(is_closed_manifold(open));
    EXPECT_EQ(count_components(open), 1U);
    EXPECT_EQ(euler_characteristic(open), 2); // a ball with a dent that goes round inside
    EXPECT_EQ(program::run({"check", folder_ / "closed.stl", "--printable", "--min-wall", "1.5"}).status, 0);
    // The rim of the drain is sharp.
    EXPECT_EQ(program::run({"check", folder_ / "open.stl", "--printable", "--min-wall", "1"}).status, 0);
    EXPECT_EQ(program::run({"check", folder_ / "open.stl", "--printable", "--min-wall", "2.5"}).status, 5);
}

TEST_F(ProcessTest, hollows_that_no_memory_holds_are_refused_before_the_work)
{
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{"--hollow", "0.0001"}, {"--hollow", "1", "--voxel", "0.00001"}})
    {
        const program::Outcome outcome = process("no.stl", options);
        EXPECT_EQ(outcome.status, 2) << outcome.err;
        EXPECT_NE(outcome.err.find("this machine has"), std::string::npos) << outcome.err;
    }
    const program::Outcome outcome = process("no.stl", {"--hollow", "2", "--drain", "1000"});
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("allowed: less than the mesh"), std::string::npos) << outcome.err;
}

TEST_F(ProcessTest, hollowing_leaves_out_specks_below_its_grain_and_says_so)
{
    Phantom phantom;
    phantom.field = [](const Point3& p) {
        return std::max(8.5 - distance(p, {10, 10, 10}), 1.2 - distance(p, {20, 20, 20}));
    };
    write_phantom(phantom, folder_ / "speck.mha");
    ASSERT_EQ(
        program::run({"mesh", folder_ / "speck.mha", "-o", folder_ / "speck.ply", "--isovalue", "0"}).status,
        0);
    ASSERT_EQ(count_components(read_mesh(folder_ / "speck.ply")), 2U);
    const program::Outcome outcome = program::run(
        {"process", folder_ / "speck.ply", "-o", folder_ / "hollow.ply", "--hollow", "2.5", "--voxel", "1"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(count_components(read_mesh(folder_ / "hollow.ply")), 2U); // the ball's outside and its hollow
    EXPECT_NE(outcome.out.find("1 speck of less than 8 voxels left out"), std::string::npos) << outcome.out;
}

TEST_F(ProcessTest, printing_is_judged)
{
    const program::Outcome outcome =
        program::run({"check", mesh(), "--printable", "--density", "1.2", "--json", folder_ / "check.json"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("no way out"), std::string::npos) << outcome.err;
    const nlohmann::json print =
        nlohmann::json::parse(program::read_text(folder_ / "check.json"))["printable"];
    EXPECT_EQ(print["bodies"], 2);
    EXPECT_EQ(print["trapped_cavities"].size(), 1U);
    // Both sides may be off by the distance criterion, 0.3 of a voxel.
    EXPECT_NEAR(print["thinnest_wall"]["mm"].get<double>(), 3.5, 0.6);
    const program::Outcome small = program::run({"check", mesh(), "--printable", "--bed", "10,10,10"});
    EXPECT_EQ(small.status, 5);
    EXPECT_NE(small.err.find("--bed"), std::string::npos) << small.err;
}

TEST_F(ProcessTest, no_point_goes_farther_from_the_mesh_than_max_error)
{
    ASSERT_EQ(program::run(mesh_ball("fine.ply", {"--size", "1"})).status, 0);
    const TriangleMesh before = read_mesh(folder_ / "fine.ply");
    std::size_t fewest_faces = before.faces.size();
    for (const double bound : {0.05, 0.2})
    {
        const program::Outcome outcome =
            program::run({"process", folder_ / "fine.ply", "-o", folder_ / "out.ply", "--max-error",
                          std::to_string(bound)});
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        const TriangleMesh after = read_mesh(folder_ / "out.ply");
        EXPECT_LT(after.faces.size(), fewest_faces) << "a wider bound lets more of them go";
        fewest_faces = after.faces.size();
        const MeshDistance distance_to(after);
        for (const Point3& p : before.vertices)
            EXPECT_LE(distance_to(p), bound + kRounding);
    }
}

TEST_F(ProcessTest, decimation_makes_no_face_with_a_smaller_angle_than_told)
{
    const TriangleMesh before = read_mesh(mesh());
    const auto faces_below = [&](const std::string& bound)
    {
        EXPECT_EQ(process("out.ply", {"--decimate", "40%", "--decimate-angle", bound}).status, 0);
        return count_faces_below_angle(read_mesh(folder_ / "out.ply"), 28.0 - kRounding);
    };
    EXPECT_LE(faces_below("28"), count_faces_below_angle(before, 28.0));
    EXPECT_GT(faces_below("5"), count_faces_below_angle(before, 28.0));
}

//! 10 mm high, on a square of 10 mm, and as wide as told at the top.
std::string leaning_block(double top_half)
{
    const std::string t = std::to_string(top_half);
    return "OFF\n8 12 0\n-5 -5 0\n5 -5 0\n5 5 0\n-5 5 0\n-" + t + " -" + t + " 10\n" + t + " -" + t +
           " 10\n" + t + ' ' + t + " 10\n-" + t + ' ' + t +
           " 10\n3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n" +
           "3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n";
}

TEST_F(ProcessTest, faces_hang_over_that_lean_out_farther_than_told)
{
    const double lean = 30.0 * std::acos(-1.0) / 180.0;
    const double top_half = 5.0 + 10.0 * std::tan(lean);
    program::write_text(folder_ / "block.off", leaning_block(top_half));
    const auto overhang_beyond = [&](const std::string& bound)
    {
        const program::Outcome outcome =
            program::run({"check", folder_ / "block.off", "--printable", "--overhang", bound, "--json",
                          folder_ / "summary.json"});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return summary()["printable"]["overhang_area_mm2"].get<double>();
    };
    const double sides = 4.0 * (5.0 + top_half) * 10.0 / std::cos(lean);
    EXPECT_NEAR(overhang_beyond("29"), sides, 1e-3);
    EXPECT_EQ(overhang_beyond("31"), 0.0);
}

TEST_F(ProcessTest, surfaces_that_enclose_less_than_told_are_left_out_and_listed)
{
    for (const auto& [volume, components] : {std::pair{"10", 3U}, {"100", 2U}}) // the small ball has 33 mm3
    {
        const program::Outcome outcome =
            program::run({"mesh", folder_ / "scan.mha", "-o", folder_ / "out.ply", "--isovalue", "0",
                          "--min-component-volume", volume, "--summary", folder_ / "summary.json"});
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(count_components(read_mesh(folder_ / "out.ply")), components);
        EXPECT_EQ(summary()["certificate"]["dropped"].size(), 3 - components);
    }
    const program::Outcome none = program::run({"mesh", folder_ / "scan.mha", "-o", folder_ / "none.ply",
                                                "--isovalue", "0", "--min-component-volume", "1e5"});
    EXPECT_EQ(none.status, 4);
    EXPECT_NE(none.err.find("--min-component-volume"), std::string::npos) << none.err;
    EXPECT_FALSE(fs::exists(folder_ / "none.ply"));
}

TEST_F(ProcessTest, wrong_usage_is_refused_before_anything_is_read)
{
    const std::vector<std::vector<std::string>> wrong{
        {"--split"},          {"--max-hole", "3"},    {"--decimate", "0%"}, {"--decimate", "3"},
        {"--rotate", "w:10"}, {"--translate", "1,2"}, {"--scale", "0"},     {"--drain", "2"},
        {"--smooth", "-1"},   {"--unit", "foot"},     {"--normals"}};
    for (const auto& options : wrong)
    {
        const program::Outcome outcome = process("out.stl", options);
        EXPECT_EQ(outcome.status, 2) << options[0];
        EXPECT_NE(outcome.err.find(options[0]), std::string::npos) << outcome.err;
    }
    const program::Outcome unsplit = process("out{n}.stl", {"--center"});
    EXPECT_EQ(unsplit.status, 2);
    EXPECT_NE(unsplit.err.find("--split"), std::string::npos) << unsplit.err;
    EXPECT_EQ(program::run({"process", mesh(), "-o", mesh(), "--center"}).status, 2);
    EXPECT_EQ(program::run({"process", folder_ / "none.stl", "-o", folder_ / "out.stl"}).status, 3);
    EXPECT_EQ(program::run({"check", mesh(), "--min-wall", "1"}).status, 2);
}

TEST_F(ProcessTest, a_mesh_can_be_finished_as_it_is_made)
{
    const program::Outcome outcome =
        program::run({"mesh", folder_ / "scan.mha", "-o", folder_ / "relaxed.stl", "--isovalue", "0",
                      "--relax", "--on-bed", "--summary", folder_ / "summary.json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(summary()["steps"][0]["step"], "relax");
    EXPECT_TRUE(summary()["certificate"]["complete"]);
    const TriangleMesh result = read_mesh(folder_ / "relaxed.stl");
    EXPECT_GE(measure_angles(result).min_deg, 33.0);
    EXPECT_NEAR(bounding_box(result).min.z, 0.0, 1e-5);
}

TEST_F(ProcessTest, normals_are_written_on_request)
{
    ASSERT_EQ(process("plain.obj", {}).status, 0);
    ASSERT_EQ(process("normals.obj", {"--normals"}).status, 0);
    EXPECT_EQ(program::read_text(folder_ / "plain.obj").find("\nvn "), std::string::npos);
    EXPECT_NE(program::read_text(folder_ / "normals.obj").find("\nvn "), std::string::npos);
}

} // namespace
} // namespace voroprobe
