#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/mesh_reader.h"
#include "io/mesh_writer.h"
#include "program_fixture.h"

namespace voroprobe
{
namespace
{

//! The corner of a cube: closed, faces outward; without the last face it is not.
constexpr const char* kTetrahedron =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
constexpr const char* kOpenTetrahedron =
    "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n";

//! A ball with a cavity, and a speck of one voxel in a corner.
Phantom shell_and_speck()
{
    Phantom phantom;
    phantom.field = [](const Point3& p)
    {
        const double r = distance(p, {12.0, 12.0, 12.0});
        return std::max(std::min(9.0 - r, r - 4.0), 0.6 - distance(p, {2, 2, 2}));
    };
    return phantom;
}

class CheckTest : public ProgramTest
{
protected:
    [[nodiscard]] std::string file(const std::string& name, const std::string& text) const
    {
        program::write_text(folder_ / name, text);
        return folder_ / name;
    }

    //! Meshes the phantom with the program, and answers the mesh.
    [[nodiscard]] std::string mesh_of(const Phantom& phantom, std::vector<std::string> more = {}) const
    {
        write_phantom(phantom, folder_ / "scan.mha");
        std::vector<std::string> arguments{
            "mesh", folder_ / "scan.mha", "-o", folder_ / "scan.ply", "--isovalue", "0", "-q"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const program::Outcome outcome = program::run(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return folder_ / "scan.ply";
    }

    [[nodiscard]] program::Outcome check_against_scan(const std::string& mesh,
                                                      std::vector<std::string> more = {}) const
    {
        std::vector<std::string> arguments{"check",      mesh, "--against", folder_ / "scan.mha",
                                           "--isovalue", "0",  "--json",    folder_ / "check.json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return program::run(arguments);
    }

    [[nodiscard]] nlohmann::json json() const
    {
        return nlohmann::json::parse(program::read_text(folder_ / "check.json"));
    }
};

TEST_F(CheckTest, a_closed_mesh_passes_and_is_described)
{
    const program::Outcome outcome = program::run(
        {"check", file("t.off", kTetrahedron), "--json", folder_ / "check.json", "--angle", "50"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("closed, manifold, oriented"), std::string::npos) << outcome.out;

    const auto mesh = json().at("mesh");
    EXPECT_EQ(mesh.at("faces"), 4);
    EXPECT_EQ(mesh.at("euler_characteristic"), 2);
    EXPECT_EQ(mesh.at("self_intersections"), 0);
    EXPECT_EQ(mesh.at("faces_below_angle_bound"), 3);
    EXPECT_NEAR(mesh.at("volume").get<double>(), 1.0 / 6.0, 1e-12);
    EXPECT_EQ(json().at("status"), "done");
    EXPECT_FALSE(json().contains("certificate"));
}

TEST_F(CheckTest, objects_that_overlap_are_told_and_pass_and_one_that_crosses_itself_fails)
{
    const std::string both = file("both.off", "OFF\n8 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                              "0.2 0.2 0.2\n1.2 0.2 0.2\n0.2 1.2 0.2\n0.2 0.2 1.2\n"
                                              "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"
                                              "3 4 6 5\n3 4 5 7\n3 5 6 7\n3 6 4 7\n");
    const program::Outcome as_one = program::run({"check", both});
    EXPECT_EQ(as_one.status, 5);
    EXPECT_NE(as_one.err.find("cross or overlap"), std::string::npos) << as_one.err;

    const std::string apart = folder_ / "apart.3mf";
    const program::Outcome split = program::run({"process", both, "--split", "-o", apart, "-q"});
    ASSERT_EQ(split.status, 0) << split.err;
    const program::Outcome as_two = program::run({"check", apart, "--json", folder_ / "check.json"});
    EXPECT_EQ(as_two.status, 0) << as_two.err;
    EXPECT_NE(as_two.out.find("2; 1 pair of them touches or overlaps"), std::string::npos) << as_two.out;
    const nlohmann::json mesh = json()["mesh"];
    EXPECT_EQ(mesh["self_intersections"], 0);
    EXPECT_EQ(mesh["objects"], 2);
    ASSERT_EQ(mesh["object_overlaps"].size(), 1U);
    EXPECT_EQ(mesh["object_overlaps"][0]["objects"], nlohmann::json::array({1, 2}));
    EXPECT_GT(mesh["object_overlaps"][0]["face_pairs"], 0);
}

TEST_F(CheckTest, faces_without_area_are_counted_apart_from_pairs_that_cross)
{
    // Two tetrahedra that stand in each other, and a face that is a segment.
    const std::string mesh = file("flat.off", "OFF\n11 9 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                              "0.2 0.2 0.2\n1.2 0.2 0.2\n0.2 1.2 0.2\n0.2 0.2 1.2\n"
                                              "5 0 0\n6 0 0\n7 0 0\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"
                                              "3 4 6 5\n3 4 5 7\n3 5 6 7\n3 6 4 7\n3 8 9 10\n");
    const program::Outcome checked = program::run({"check", mesh, "--json", folder_ / "check.json"});
    EXPECT_EQ(checked.status, 5);
    const nlohmann::json told = json()["mesh"];
    const std::string pairs = std::to_string(told["self_intersections"].get<int>());
    EXPECT_EQ(told["flat_faces"], 1);
    for (const auto& pair : told["first_self_intersections"])
        EXPECT_NE(pair[0], pair[1]);
    EXPECT_EQ(told["first_self_intersections"].size(), told["self_intersections"]);
    EXPECT_NE(checked.out.find(pairs + " pairs of faces cross or overlap; 1 face without area"),
              std::string::npos)
        << checked.out;
    EXPECT_NE(checked.err.find("1 face without area, " + pairs + " pairs of faces"), std::string::npos)
        << checked.err;

    const program::Outcome processed = program::run(
        {"process", mesh, "-o", folder_ / "same.off", "--center", "--summary", folder_ / "check.json"});
    EXPECT_EQ(processed.status, 5);
    EXPECT_EQ(json()["before"]["self_intersections"], told["self_intersections"]);
    EXPECT_EQ(json()["before"]["flat_faces"], 1);
    EXPECT_NE(processed.out.find(pairs + " crossings, 1 face without area"), std::string::npos)
        << processed.out;
}

TEST_F(CheckTest, against_a_scan_a_face_without_area_still_fails)
{
    const std::string mesh = mesh_of(ball_phantom());
    ASSERT_EQ(check_against_scan(mesh).status, 0);
    TriangleMesh flat = read_mesh(mesh);
    // Between a face and its neighbour, cut in two, lies one whose corners are on their edge.
    const TriangleMesh::Face face = flat.faces.front();
    flat.vertices.push_back(0.5 * (flat.vertices[face[0]] + flat.vertices[face[1]]));
    const auto middle = static_cast<std::uint32_t>(flat.vertices.size() - 1);
    for (TriangleMesh::Face& neighbour : flat.faces)
        if (const auto at = std::find(neighbour.begin(), neighbour.end(), face[1]);
            at != neighbour.end() && *(at + 1 == neighbour.end() ? neighbour.begin() : at + 1) == face[0])
        {
            const std::uint32_t apex = neighbour[0] + neighbour[1] + neighbour[2] - face[0] - face[1];
            neighbour = {face[1], middle, apex};
            flat.faces.push_back({middle, face[0], apex});
            break;
        }
    flat.faces.push_back({face[1], face[0], middle});
    write_mesh(flat, folder_ / "flat.vtp", MeshFormat::kVtp);
    const program::Outcome outcome = check_against_scan(folder_ / "flat.vtp");
    EXPECT_EQ(outcome.status, 5) << outcome.out;
    EXPECT_NE(outcome.err.find("1 face without area"), std::string::npos) << outcome.err;
    // The halves of the edge lie on the whole of it.
    EXPECT_EQ(json()["mesh"]["self_intersections"], 2);
    EXPECT_EQ(json()["certificate"]["self_intersections"], 2);
}

TEST_F(CheckTest, an_open_mesh_fails_with_the_reason_on_one_line)
{
    const program::Outcome outcome = program::run({"check", file("t.off", kOpenTetrahedron), "-q"});
    EXPECT_EQ(outcome.status, 5);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(is_one_error_line(outcome.err)) << outcome.err;
    EXPECT_NE(outcome.err.find("3 edges on one face only"), std::string::npos) << outcome.err;
}

TEST_F(CheckTest, a_broken_file_is_refused_as_input)
{
    EXPECT_EQ(program::run({"check", folder_ / "none.stl"}).status, 3);
    EXPECT_EQ(program::run({"check", file("t.off", "OFF\n4 4 0\n0 0")}).status, 3);
    EXPECT_EQ(program::run({"check", file("t.txt", kTetrahedron)}).status, 3);
}

TEST_F(CheckTest, options_of_the_scan_are_refused_without_one)
{
    const std::string mesh = file("t.off", kTetrahedron);
    for (const char* option : {"--isovalue", "--size", "--samples", "--spacing"})
    {
        const program::Outcome outcome =
            program::run({"check", mesh, option, option == std::string("--spacing") ? "1,1,1" : "100"});
        EXPECT_EQ(outcome.status, 2) << option;
        EXPECT_NE(outcome.err.find("only with --against"), std::string::npos) << outcome.err;
    }
}

TEST_F(CheckTest, the_json_never_overwrites_what_is_read)
{
    const std::string mesh = file("t.off", kTetrahedron);
    EXPECT_EQ(program::run({"check", mesh, "--json", mesh}).status, 2);
    EXPECT_EQ(program::read_text(mesh), kTetrahedron);
}

TEST_F(CheckTest, a_mesh_of_the_scan_is_complete_in_every_frame)
{
    Phantom phantom = ball_phantom();
    phantom.origin = {30, -20, 5};
    phantom.direction = {{Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}}};
    phantom.field = ball(world_from_index(phantom) * Point3{11.5, 11.5, 11.5}, 8.0);
    for (const char* frame : {"lps", "ras", "index"})
    {
        const std::string mesh = mesh_of(phantom, {"--frame-of-reference", frame});
        const program::Outcome outcome =
            check_against_scan(mesh, {"--frame-of-reference", frame, "--samples", "2000"});
        EXPECT_EQ(outcome.status, 0) << frame << ": " << outcome.err;
        const auto certificate = json().at("certificate");
        EXPECT_EQ(certificate.at("surfaces_expected"), 1);
        EXPECT_TRUE(certificate.at("complete"));
        EXPECT_EQ(certificate.at("genus_mismatches").size(), 0U);
        EXPECT_LT(certificate.at("distance_max_mm").get<double>(), 0.6);
    }
}

TEST_F(CheckTest, a_mesh_in_another_frame_is_told_so)
{
    Phantom phantom = ball_phantom();
    phantom.origin = {30, -20, 5};
    phantom.field = ball({41.5, -8.5, 16.5}, 8.0);
    const std::string mesh = mesh_of(phantom, {"--frame-of-reference", "ras"});
    const program::Outcome outcome = check_against_scan(mesh);
    EXPECT_EQ(outcome.status, 5);
    EXPECT_NE(outcome.err.find("--frame-of-reference"), std::string::npos) << outcome.err;
}

TEST_F(CheckTest, a_mesh_of_one_ball_misses_the_cavity_and_the_speck_of_the_scan)
{
    Phantom whole = shell_and_speck();
    Phantom filled = whole;
    filled.field = ball({12.0, 12.0, 12.0}, 9.0);
    const std::string mesh = mesh_of(filled);
    write_phantom(whole, folder_ / "scan.mha");
    const program::Outcome outcome = check_against_scan(mesh);
    EXPECT_EQ(outcome.status, 5);
    EXPECT_TRUE(is_one_error_line(outcome.err)) << outcome.err;
    EXPECT_NE(outcome.err.find("2 surfaces missing"), std::string::npos) << outcome.err;

    const auto certificate = json().at("certificate");
    EXPECT_EQ(certificate.at("surfaces_expected"), 3);
    EXPECT_EQ(certificate.at("surfaces_meshed"), 1);
    EXPECT_FALSE(certificate.at("complete"));
    ASSERT_EQ(certificate.at("missing").size(), 2U);
    bool found_speck = false;
    for (const auto& surface : certificate.at("missing"))
    {
        const auto box = surface.at("box_mm");
        found_speck = found_speck || (surface.at("voxels") == 1 && box.at("max").at(0).get<double>() < 3.0);
        EXPECT_EQ(surface.at("reason"), "no vertex of the mesh lies on it");
    }
    EXPECT_TRUE(found_speck);
    EXPECT_GT(certificate.at("distance_max_mm").get<double>(), 4.0);
}

TEST_F(CheckTest, criteria_are_counted_where_they_are_asked_for)
{
    const std::string mesh = mesh_of(ball_phantom(), {"--size", "2"});
    EXPECT_EQ(check_against_scan(mesh, {"--size", "2.001", "--distance", "1"}).status, 0);
    EXPECT_EQ(json().at("certificate").at("criteria_exceptions").at("size"), 0);
    EXPECT_EQ(json().at("certificate").at("criteria_exceptions").at("distance"), 0);
    EXPECT_TRUE(json().at("certificate").at("criteria_exceptions").at("angle").is_null());
    EXPECT_EQ(check_against_scan(mesh, {"--size", "0.01"}).status, 0);
    EXPECT_EQ(json().at("certificate").at("criteria_exceptions").at("size"), json().at("mesh").at("faces"));
}

} // namespace
} // namespace voroprobe
