#include <cmath>

#include <nlohmann/json.hpp>

#include "program_fixture.h"

namespace voroprobe
{
namespace
{

using nlohmann::json;
using program::run;

class InfoTest : public ProgramTest
{
protected:
    json info_of(const std::string& path, const std::vector<std::string>& more = {})
    {
        std::vector<std::string> arguments{"info", path, "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const auto outcome = run(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return json::parse(outcome.out);
    }
};

TEST_F(InfoTest, text_tells_size_spacing_orientation_type_range_and_draws_a_histogram)
{
    const auto outcome = run({"info", folder_ / "ball.mha"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    for (const char* part :
         {"24 x 24 x 24 voxels", "1 x 1 x 1 mm", "LPS", "float32", "MetaImage", "isovalues", "Otsu",
          "% of the voxels inside", "0 NaN, 0 infinite", "|####", "<- "})
        EXPECT_NE(outcome.out.find(part), std::string::npos) << part << " is not in:\n" << outcome.out;
}

TEST_F(InfoTest, json_tells_the_same)
{
    const json info = info_of(folder_ / "ball.mha");
    EXPECT_EQ(info.at("size"), json({24, 24, 24}));
    EXPECT_EQ(info.at("type"), "float32");
    EXPECT_EQ(info.at("orientation"), "LPS");
    EXPECT_LT(info.at("min").get<double>(), -11.0);
    EXPECT_GT(info.at("max").get<double>(), 7.0);
    EXPECT_EQ(info.at("label_map"), false);
    std::size_t samples = 0;
    for (const auto& bin : info.at("histogram"))
        samples += bin.get<std::size_t>();
    EXPECT_EQ(samples, 24U * 24U * 24U);
    for (const auto& suggestion : info.at("suggested_isovalues"))
    {
        EXPECT_GT(suggestion.at("share_inside").get<double>(), 0.0);
        EXPECT_LT(suggestion.at("share_inside").get<double>(), 1.0);
    }
}

TEST_F(InfoTest, an_oblique_left_handed_lattice_is_told_as_the_file_has_it)
{
    Phantom oblique = ball_phantom();
    oblique.spacing = {1.0, 0.8, 1.4};
    oblique.direction = {{Vec3{-0.8, 0.6, 0}, Vec3{0.6, 0.8, 0}, Vec3{0, 0, 1}}};
    oblique.origin = {30, -40, 50};
    write_phantom(oblique, folder_ / "oblique.mha");
    const json info = info_of(folder_ / "oblique.mha");
    EXPECT_EQ(info.at("orientation"), "RPS");
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        EXPECT_NEAR(info.at("spacing")[axis].get<double>(), oblique.spacing[axis], 1e-9);
        EXPECT_NEAR(info.at("origin")[axis].get<double>(), oblique.origin[axis], 1e-9);
        for (std::size_t row = 0; row < 3; ++row)
            EXPECT_NEAR(info.at("direction")[axis][row].get<double>(), oblique.direction.column[axis][row],
                        1e-9);
    }
    EXPECT_NE(run({"info", folder_ / "oblique.mha"}).out.find("left-handed"), std::string::npos);
}

TEST_F(InfoTest, samples_that_are_not_numbers_are_counted)
{
    Phantom holed = ball_phantom();
    holed.field = [](const Point3& p) { return p.x < 0.5 ? std::nan("") : p.x < 1.5 ? INFINITY : p.y; };
    write_phantom(holed, folder_ / "holed.mha");
    const json info = info_of(folder_ / "holed.mha");
    EXPECT_EQ(info.at("nan_count"), 24 * 24);
    EXPECT_EQ(info.at("infinite_count"), 24 * 24);
}

TEST_F(InfoTest, a_volume_without_any_finite_sample_has_no_range)
{
    Phantom empty = ball_phantom();
    empty.field = [](const Point3& p) { return p.x < 5.5 ? INFINITY : std::nan(""); };
    write_phantom(empty, folder_ / "empty.mha");
    const json info = info_of(folder_ / "empty.mha");
    for (const char* key : {"min", "max", "mean"})
        EXPECT_TRUE(info.at(key).is_null()) << key;
    const std::string text = run({"info", folder_ / "empty.mha"}).out;
    EXPECT_NE(text.find("no sample is a finite number"), std::string::npos) << text;
    EXPECT_EQ(text.find("0 to 0"), std::string::npos) << text;
}

TEST_F(InfoTest, a_label_map_is_called_one)
{
    Phantom labels = ball_phantom();
    labels.field = [](const Point3& p) { return std::floor(p.x / 6.0); };
    write_phantom(labels, folder_ / "labels.mha");
    EXPECT_EQ(info_of(folder_ / "labels.mha").at("label_map"), true);
    EXPECT_NE(run({"info", folder_ / "labels.mha"}).out.find("label map"), std::string::npos);
}

TEST_F(InfoTest, a_signed_distance_is_called_one)
{
    Phantom distances = ball_phantom();
    distances.field = [](const Point3& p) { return distance(p, {11.5, 11.5, 11.5}) - 8.0; };
    write_phantom(distances, folder_ / "distances.mha");
    EXPECT_EQ(info_of(folder_ / "distances.mha").at("signed_distance"), true);
    EXPECT_NE(run({"info", folder_ / "distances.mha"}).out.find("--isovalue 0 --inside below"),
              std::string::npos);
    EXPECT_EQ(info_of(folder_ / "ball.mha").at("signed_distance"), false); // the other way round
}

TEST_F(InfoTest, a_constant_volume_has_no_suggestion)
{
    Phantom constant = ball_phantom();
    constant.field = [](const Point3&) { return 7.0; };
    write_phantom(constant, folder_ / "constant.mha");
    EXPECT_EQ(info_of(folder_ / "constant.mha").at("suggested_isovalues"), json::array());
    EXPECT_NE(run({"info", folder_ / "constant.mha"}).out.find("none separates"), std::string::npos);
}

TEST_F(InfoTest, the_head_ct_of_testdata_is_read)
{
    const json info = info_of(VOROPROBE_SOURCE_DIR "/testdata/headsq_ct.nrrd");
    EXPECT_EQ(info.at("size"), json({64, 64, 93}));
    EXPECT_EQ(info.at("min"), 0.0);
    EXPECT_EQ(info.at("max"), 3926.0);
    EXPECT_EQ(info.at("label_map"), false);
}

} // namespace
} // namespace voroprobe
