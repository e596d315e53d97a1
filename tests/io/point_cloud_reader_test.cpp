#include "io/point_cloud_reader.h"

#include <gtest/gtest.h>

#include "support/error.h"
#include "temporary_folder.h"

namespace voroprobe
{
namespace
{

std::string refusal_of(const std::filesystem::path& path)
{
    try
    {
        read_point_cloud(path);
    }
    catch (const InputError& error)
    {
        return error.what();
    }
    return {};
}

TEST(PointCloudReader, reads_six_numbers_a_line_and_passes_over_the_rest)
{
    const TemporaryFolder folder;
    const auto cloud = read_point_cloud(folder.file("cloud.xyz", "# x y z nx ny nz\n"
                                                                 "1 2 3 0 0 1\r\n"
                                                                 "\n"
                                                                 "  -1e2\t+0.5 .25  1 0 0 255 255 0\n"
                                                                 "4 5 6 0 1 0"));
    ASSERT_EQ(cloud.size(), 3U);
    EXPECT_EQ(cloud[0].position, (Point3{1, 2, 3}));
    EXPECT_EQ(cloud[0].normal, (Vec3{0, 0, 1}));
    EXPECT_EQ(cloud[1].position, (Point3{-100, 0.5, 0.25}));
    EXPECT_EQ(cloud[2].normal, (Vec3{0, 1, 0}));
}

TEST(PointCloudReader, refuses_what_is_no_point_with_its_line)
{
    const TemporaryFolder folder;
    EXPECT_NE(refusal_of(folder.file("bare.xyz", "1 2 3 0 0 1\n1 2 3\n")).find("line 2"), std::string::npos);
    EXPECT_NE(refusal_of(folder.file("words.xyz", "one 2 3 0 0 1\n")).find("line 1"), std::string::npos);
    EXPECT_NE(refusal_of(folder.file("comma.xyz", "1,2,3,0,0,1\n")).find("line 1"), std::string::npos);
    EXPECT_NE(refusal_of(folder.file("none.xyz", "# nothing\n")).find("no points"), std::string::npos);
    EXPECT_NE(refusal_of(folder.path() / "absent.xyz").find("absent.xyz"), std::string::npos);
}

} // namespace
} // namespace voroprobe
