#include "cli/output_pattern.h"

#include <gtest/gtest.h>

#include "support/error.h"

namespace voroprobe
{
namespace
{

std::vector<std::string> expand(const std::string& pattern, const std::vector<PatternValues>& values)
{
    std::vector<std::string> paths;
    for (const auto& path : expand_pattern(pattern, values))
        paths.push_back(path.string());
    return paths;
}

TEST(OutputPattern, is_filled_in_with_number_and_name)
{
    EXPECT_EQ(expand("out/{label}_{name}.stl", {{"1", "liver"}, {"2", "left kidney"}}),
              (std::vector<std::string>{"out/1_liver.stl", "out/2_left kidney.stl"}));
    EXPECT_TRUE(is_output_pattern("{name}.stl"));
    EXPECT_FALSE(is_output_pattern("name.stl"));
}

TEST(OutputPattern, names_cannot_lead_out_of_the_folder)
{
    EXPECT_EQ(expand("out/{name}.stl", {{"1", "../../etc/passwd"}}),
              std::vector<std::string>{"out/_.._.._etc_passwd.stl"});
    EXPECT_EQ(expand("out/{name}.stl", {{"1", ""}}), std::vector<std::string>{"out/_.stl"});
    EXPECT_EQ(expand("out/{name}.stl", {{"1", "{label}"}}), std::vector<std::string>{"out/{label}.stl"});
}

TEST(OutputPattern, one_that_would_overwrite_itself_is_refused)
{
    EXPECT_THROW(expand("{name}.stl", {{"1", "rib"}, {"2", "rib"}}), UsageError);
    EXPECT_THROW(expand("{name}.stl", {{"1", "rib"}, {"2", "Rib"}}), UsageError);
    EXPECT_THROW(expand("{name}.stl", {{"1", "a/b"}, {"2", "a:b"}}), UsageError);
    EXPECT_EQ(expand("{label}{name}.stl", {{"1", "rib"}, {"2", "rib"}}).size(), 2U);
    EXPECT_THROW(expand("{id}.stl", {{"1", "rib"}}), UsageError);
}

} // namespace
} // namespace voroprobe
