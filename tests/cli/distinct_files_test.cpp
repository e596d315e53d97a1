#include "cli/distinct_files.h"

#include <fstream>

#include <gtest/gtest.h>

#include "support/error.h"

namespace voroprobe
{
namespace
{

namespace fs = std::filesystem;

std::string refusal(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs)
{
    try
    {
        check_distinct(inputs, outputs);
    }
    catch (const UsageError& error)
    {
        return error.what();
    }
    return "";
}

TEST(DistinctFiles, an_output_that_is_an_input_or_another_output_is_refused_with_both_names)
{
    EXPECT_EQ(refusal({{"INPUT", "a.nrrd"}}, {{"OUTPUT", "b.stl"}, {"--summary", "b.json"}}), "");
    EXPECT_EQ(refusal({{"INPUT", "a.stl"}}, {{"OUTPUT", "a.stl"}}),
              "OUTPUT and INPUT are both a.stl; allowed: two files");
    EXPECT_EQ(refusal({}, {{"OUTPUT", "b.stl"}, {"--summary", "b.stl"}}),
              "--summary and OUTPUT are both b.stl; allowed: two files");
    EXPECT_EQ(refusal({{"MESH", "a.stl"}, {"--against", "a.stl"}}, {}), ""); // reading twice does no harm
}

TEST(DistinctFiles, one_file_is_known_by_all_its_spellings_whether_it_is_there_or_not)
{
    const fs::path here = fs::current_path();
    EXPECT_NE(refusal({}, {{"OUTPUT", "none.stl"}, {"--summary", "./none.stl"}}), "");
    EXPECT_NE(refusal({}, {{"OUTPUT", "none.stl"}, {"--summary", here / "none.stl"}}), "");
    EXPECT_NE(refusal({}, {{"OUTPUT", here / "none.stl"}, {"--summary", here / "x/../none.stl"}}), "");
}

TEST(DistinctFiles, links_are_followed)
{
    const fs::path folder = fs::temp_directory_path() / "voroprobe_distinct_files";
    fs::create_directories(folder);
    std::ofstream(folder / "scan.nrrd") << "scan";
    fs::remove(folder / "link.stl");
    fs::create_symlink(folder / "scan.nrrd", folder / "link.stl");
    EXPECT_NE(refusal({{"INPUT", folder / "scan.nrrd"}}, {{"OUTPUT", folder / "link.stl"}}), "");
    fs::remove_all(folder);
}

} // namespace
} // namespace voroprobe
