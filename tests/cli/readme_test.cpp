#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "program.h"

namespace voroprobe
{
namespace
{

const std::filesystem::path kSource = VOROPROBE_SOURCE_DIR;

std::string readme()
{
    return program::read_text(kSource / "README.md");
}

std::set<std::string> long_options_in(const std::string& text)
{
    static const std::regex kOption("--[a-z][a-z-]+");
    std::set<std::string> options;
    for (std::sregex_iterator it(text.begin(), text.end(), kOption), end; it != end; ++it)
        options.insert(it->str());
    return options;
}

TEST(Readme, shows_the_library_example_that_is_compiled)
{
    EXPECT_NE(readme().find(program::read_text(kSource / "tests/cli/library_example.cpp")),
              std::string::npos);
}

TEST(Readme, names_every_option_of_the_commands)
{
    const std::string text = readme();
    const std::set<std::string> named = long_options_in(text);
    for (const char* command : {"mesh", "info", "check", "compare", "process"})
        for (const std::string& option : long_options_in(program::run({command, "--help"}).out))
            EXPECT_TRUE(named.contains(option)) << option;
}

TEST(Readme, names_no_option_of_the_commands_that_does_not_exist)
{
    std::set<std::string> known{"--version"};
    for (const char* command : {"mesh", "info", "check", "compare", "process"})
        known.merge(long_options_in(program::run({command, "--help"}).out));
    static const std::regex kTableRow("\\n\\| `(?:-., )?(--[a-z-]+)");
    const std::string text = readme();
    std::size_t rows = 0;
    for (std::sregex_iterator it(text.begin(), text.end(), kTableRow), end; it != end; ++it, ++rows)
        EXPECT_TRUE(known.contains((*it)[1].str())) << (*it)[1].str();
    EXPECT_GT(rows, 10U);
}

TEST(Readme, points_at_files_that_exist)
{
    static const std::regex kLink("\\]\\(([^):#]+)\\)");
    const std::string text = readme();
    std::size_t links = 0;
    for (std::sregex_iterator it(text.begin(), text.end(), kLink), end; it != end; ++it, ++links)
        EXPECT_TRUE(std::filesystem::exists(kSource / (*it)[1].str())) << (*it)[1].str();
    EXPECT_GT(links, 0U);
}

TEST(LibraryExample, meshes_the_head_ct_of_testdata)
{
    const program::ScratchFolder folder;
    const std::string command = std::string(LIBRARY_EXAMPLE) + " '" +
                                (kSource / "testdata/headsq_ct.nrrd").string() + "' '" + folder / "bone.stl" +
                                "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_GT(std::filesystem::file_size(folder / "bone.stl"), 100'000U);
}

} // namespace
} // namespace voroprobe
