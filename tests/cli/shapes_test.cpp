#include <cmath>
#include <fstream>

#include <nlohmann/json.hpp>

#include "program_fixture.h"

namespace voroprobe
{
namespace
{

using program::Outcome;
using program::run;

//! What is no volume: formulas, meshes, point clouds.
class ShapesTest : public ProgramTest
{
protected:
    //! Runs `mesh` with a summary and returns that.
    nlohmann::json summary_of(std::vector<std::string> arguments, const std::string& output)
    {
        arguments.insert(arguments.begin(), "mesh");
        arguments.insert(arguments.end(), {"-o", folder_ / output, "--summary", folder_ / "summary.json"});
        last_ = run(arguments);
        EXPECT_EQ(last_.status, 0) << last_.err;
        return nlohmann::json::parse(program::read_text(folder_ / "summary.json"));
    }

    void expect_refusal(const std::vector<std::string>& arguments, int status, const std::string& words)
    {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, status) << outcome.err;
        EXPECT_TRUE(is_one_error_line(outcome.err)) << outcome.err;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << words << " is not in: " << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(folder_ / "out.stl"));
    }

    std::vector<std::string> formula(const std::string& text, const std::string& domain)
    {
        return {"mesh", "--implicit", text, "--domain", domain, "-o", folder_ / "out.stl"};
    }

    Outcome last_;
};

TEST_F(ShapesTest, a_formula_is_meshed)
{
    const auto summary = summary_of({"--implicit", "(sqrt(x^2+y^2)-3)^2+z^2-1", "--domain",
                                     "box:-5,-5,-2,5,5,2", "--size", "0.5", "--distance", "0.02"},
                                    "torus.stl");
    EXPECT_TRUE(summary["mesh"]["closed"] && summary["mesh"]["manifold"]);
    EXPECT_EQ(summary["mesh"]["euler_characteristic"], 0);
    EXPECT_NEAR(summary["mesh"]["volume_mm3"].get<double>(), 6.0 * M_PI * M_PI, 1.0);
    EXPECT_EQ(summary["input"]["kind"], "formula");
    EXPECT_EQ(summary["input"]["formula"], "(sqrt(x^2+y^2)-3)^2+z^2-1");
    EXPECT_TRUE(summary["input"]["size"].is_null());
    EXPECT_EQ(summary["mesh"]["vertices_on_domain_border"], 0);
    EXPECT_EQ(last_.err, "");
}

TEST_F(ShapesTest, a_domain_that_cuts_the_object_caps_it_and_warns_with_a_count)
{
    const auto summary = summary_of(
        {"--implicit", "x^2+y^2", "--isovalue", "1", "--domain", "box:-2,-2,-1,2,2,1", "--size", "0.3"},
        "cylinder.stl");
    EXPECT_TRUE(summary["mesh"]["closed"]);
    EXPECT_NEAR(summary["mesh"]["volume_mm3"].get<double>(), 2.0 * M_PI, 0.2);
    EXPECT_GT(summary["mesh"]["vertices_on_domain_border"], 10);
    EXPECT_NE(last_.err.find("the object leaves the domain"), std::string::npos) << last_.err;
    const auto outside = summary_of({"--implicit", "x^2+y^2+z^2", "--isovalue", "1", "--inside", "above",
                                     "--domain", "ball:0,0,0,2", "--size", "0.3"},
                                    "shell.stl");
    EXPECT_EQ(outside["mesh"]["components"], 2);
    EXPECT_NEAR(outside["mesh"]["volume_mm3"].get<double>(), 28.0 / 3.0 * M_PI, 1.0);
}

TEST_F(ShapesTest, formulas_that_make_no_sense_are_refused_with_the_place)
{
    expect_refusal(formula("x^2+y^2+q", "ball:0,0,0,1"), 2, "character 9");
    expect_refusal(formula("sqrt(x)", "ball:0,0,0,1"), 2, "not a number at (-");
    expect_refusal(formula("x^2+100", "ball:0,0,0,1"), 4, "no probe met a surface");
    expect_refusal(formula("x^2+y^2+z^2-1e-6", "ball:0,0,0,1"), 4, "no probe met a surface");
}

TEST_F(ShapesTest, domains_that_make_no_sense_are_refused)
{
    for (const char* domain : {"box", "box:1,2,3", "box:0,0,0,1,1,0", "ball:0,0,0,0", "ball:0,0,0,x",
                               "cone:0,0,0,1", "ball:0,0,0,1,", "box:0,0,0,1,1,inf"})
        expect_refusal(formula("x", domain), 2, domain);
    expect_refusal({"mesh", "--implicit", "x", "-o", folder_ / "out.stl"}, 2, "--domain");
    expect_refusal(mesh_ball("out.stl", {"--domain", "ball:0,0,0,1"}), 2, "only with --implicit");
}

TEST_F(ShapesTest, options_of_volumes_are_refused)
{
    auto with_input = formula("x", "ball:0,0,0,1");
    with_input.push_back(folder_ / "ball.mha");
    expect_refusal(with_input, 2, "--implicit");
    auto with_spacing = formula("x", "ball:0,0,0,1");
    with_spacing.insert(with_spacing.end(), {"--spacing", "1,1,1"});
    expect_refusal(with_spacing, 2, "--spacing");
    auto in_voxels = formula("x", "ball:0,0,0,1");
    in_voxels.insert(in_voxels.end(), {"--frame-of-reference", "index"});
    expect_refusal(in_voxels, 2, "no voxels");
    expect_refusal({"mesh", folder_ / "any.stl", "-o", folder_ / "out.stl", "--isovalue", "1"}, 2,
                   "--isovalue");
}

TEST_F(ShapesTest, a_mesh_is_meshed_anew_and_its_defaults_follow_its_diagonal)
{
    ASSERT_EQ(run(mesh_ball("before.ply")).status, 0);
    const auto summary = summary_of({folder_ / "before.ply"}, "after.stl");
    EXPECT_EQ(summary["input"]["kind"], "mesh");
    EXPECT_TRUE(summary["mesh"]["closed"] && summary["mesh"]["manifold"]);
    EXPECT_EQ(summary["mesh"]["euler_characteristic"], 2);
    EXPECT_TRUE(summary["parameters"]["isovalue"].is_null());
    EXPECT_GT(summary["mesh"]["min_angle_deg"], 29.0);
    const double size = summary["parameters"]["size_mm"];
    EXPECT_NEAR(summary["parameters"]["reach_mm"].get<double>(), 0.5 * size, 1e-9 * size);
}

TEST_F(ShapesTest, a_mesh_is_no_scan_to_check_another_against)
{
    ASSERT_EQ(run(mesh_ball("ball.ply")).status, 0);
    expect_refusal({"check", folder_ / "ball.ply", "--against", folder_ / "ball.ply"}, 2, "no volume");
}

TEST_F(ShapesTest, a_mesh_that_bounds_nothing_is_an_input_error_that_tells_why)
{
    std::ofstream(folder_ / "open.off") << "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                           "3 0 2 1\n3 0 1 3\n3 1 2 3\n";
    expect_refusal({"mesh", folder_ / "open.off", "-o", folder_ / "out.stl"}, 3, "not closed: 3 edges");
    expect_refusal({"mesh", folder_ / "absent.stl", "-o", folder_ / "out.stl"}, 3, "absent.stl");
}

TEST_F(ShapesTest, points_with_normals_are_fitted_and_meshed)
{
    std::ofstream file(folder_ / "ball.xyz");
    file << "# x y z nx ny nz\n\n";
    constexpr int kCount = 1000;
    for (int i = 0; i < kCount; ++i)
    {
        const double z = 1.0 - (2.0 * i + 1.0) / kCount;
        const double r = std::sqrt(1.0 - z * z);
        const double x = r * std::cos(2.4 * i);
        const double y = r * std::sin(2.4 * i);
        file << 10 * x << ' ' << 10 * y << '\t' << 10 * z << "  " << x << ' ' << y << ' ' << z << " 0.5\n";
    }
    file.close();
    const auto summary = summary_of({folder_ / "ball.xyz", "--size", "1"}, "ball.stl");
    EXPECT_EQ(summary["input"]["kind"], "points");
    EXPECT_EQ(summary["mesh"]["euler_characteristic"], 2);
    EXPECT_NEAR(summary["mesh"]["volume_mm3"].get<double>(), 4.0 / 3.0 * M_PI * 1000.0, 200.0);

    std::ofstream(folder_ / "bare.xyz") << "1 2 3 0 0 1\n1 2 3\n";
    expect_refusal({"mesh", folder_ / "bare.xyz", "-o", folder_ / "out.stl"}, 3, "line 2");
    expect_refusal({"mesh", folder_ / "absent.xyz", "-o", folder_ / "out.stl"}, 3, "no such file");
}

} // namespace
} // namespace voroprobe
