#include <nlohmann/json.hpp>

#include "program_fixture.h"

namespace voroprobe
{
namespace
{

using nlohmann::json;
using program::run;

class SummaryTest : public ProgramTest
{
protected:
    json summary_of(const std::vector<std::string>& more = {})
    {
        std::vector<std::string> arguments = mesh_ball("out.stl", {"--summary", folder_ / "out.json"});
        arguments.insert(arguments.end(), more.begin(), more.end());
        const auto outcome = run(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return json::parse(program::read_text(folder_ / "out.json"));
    }
};

TEST_F(SummaryTest, has_every_key_with_its_type)
{
    const json summary = summary_of();
    EXPECT_EQ(summary.at("version"), VOROPROBE_VERSION);
    EXPECT_EQ(summary.at("status"), "done");
    EXPECT_TRUE(summary.at("peak_memory_bytes").is_number_unsigned());
    for (const char* key : {"path", "type"})
        EXPECT_TRUE(summary.at("input").at(key).is_string()) << key;
    for (const char* key : {"isovalue", "size_mm", "angle_deg", "distance_mm", "floor_mm", "reach_mm"})
        EXPECT_TRUE(summary.at("parameters").at(key).is_number()) << key;
    for (const char* key : {"vertices", "faces", "components", "faces_below_angle_bound"})
        EXPECT_TRUE(summary.at("mesh").at(key).is_number_unsigned()) << key;
    for (const char* key : {"closed", "manifold", "oriented"})
        EXPECT_TRUE(summary.at("mesh").at(key).is_boolean()) << key;
    for (const char* key : {"area_mm2", "volume_mm3", "min_angle_deg", "mean_min_angle_deg"})
        EXPECT_TRUE(summary.at("mesh").at(key).is_number_float()) << key;
    for (const char* key : {"refinement", "initialization", "probing"})
        EXPECT_TRUE(summary.at("oracle_queries").at(key).is_number_unsigned()) << key;
    for (const char* key : {"read", "refinement", "write", "total"})
        EXPECT_TRUE(summary.at("timings_s").at(key).is_number_float()) << key;
    for (const char* key : {"by_initialization", "by_isolated_vertex", "by_probing", "by_refinement"})
        EXPECT_TRUE(summary.at("seeding").at(key).is_number_unsigned()) << key;
}

TEST_F(SummaryTest, tells_of_the_input)
{
    const json input = summary_of().at("input");
    EXPECT_EQ(input.at("path"), folder_ / "ball.mha");
    EXPECT_EQ(input.at("size"), json({24, 24, 24}));
    EXPECT_EQ(input.at("spacing"), json({1.0, 1.0, 1.0}));
    EXPECT_EQ(input.at("type"), "float32");
}

TEST_F(SummaryTest, tells_of_a_ball)
{
    const json mesh = summary_of({"--size", "1", "--distance", "0.05"}).at("mesh");
    EXPECT_EQ(mesh.at("components"), 1);
    EXPECT_EQ(mesh.at("euler_characteristic"), 2);
    EXPECT_EQ(mesh.at("closed"), true);
    EXPECT_EQ(mesh.at("manifold"), true);
    EXPECT_EQ(mesh.at("oriented"), true);
    constexpr double kPi = 3.14159265358979323846;
    EXPECT_NEAR(mesh.at("area_mm2").get<double>(), 4.0 * kPi * 64.0, 0.02 * 4.0 * kPi * 64.0);
    EXPECT_NEAR(mesh.at("volume_mm3").get<double>(), 4.0 / 3.0 * kPi * 512.0, 0.02 * 4.0 / 3.0 * kPi * 512.0);
}

TEST_F(SummaryTest, lengths_follow_the_spacing_of_the_file)
{
    Phantom thick = ball_phantom();
    thick.size = {24, 24, 8};
    thick.spacing = {1, 1, 3.375};
    thick.field = ball({11.5, 11.5, 11.8}, 8.0);
    write_phantom(thick, folder_ / "ball.mha");
    const json parameters = summary_of().at("parameters");
    EXPECT_NEAR(parameters.at("size_mm").get<double>(), 2 * 1.5, 1e-9); // the cube root of 3.375 is 1.5
    EXPECT_NEAR(parameters.at("distance_mm").get<double>(), 0.3, 1e-9);
    EXPECT_NEAR(parameters.at("floor_mm").get<double>(), 0.25, 1e-9);
    EXPECT_NEAR(parameters.at("reach_mm").get<double>(), 1.0, 1e-9);
}

TEST_F(SummaryTest, repeats_the_options_given)
{
    const json parameters =
        summary_of({"--size", "3", "--distance", "0.5", "--floor", "0.4", "--reach", "0.9", "--angle", "25",
                    "--seed", "7", "--threads", "2", "--frame-of-reference", "ras", "--isolated", "one"})
            .at("parameters");
    EXPECT_EQ(parameters.at("size_mm"), 3.0);
    EXPECT_EQ(parameters.at("distance_mm"), 0.5);
    EXPECT_EQ(parameters.at("floor_mm"), 0.4);
    EXPECT_EQ(parameters.at("reach_mm"), 0.9);
    EXPECT_EQ(parameters.at("angle_deg"), 25.0);
    EXPECT_EQ(parameters.at("seed"), 7);
    EXPECT_EQ(parameters.at("threads"), 2);
    EXPECT_EQ(parameters.at("frame_of_reference"), "ras");
    EXPECT_EQ(parameters.at("isolated"), "one");
    EXPECT_EQ(parameters.at("isovalue"), 0.0);
    EXPECT_EQ(parameters.at("isovalue_source"), "given");
}

} // namespace
} // namespace voroprobe
