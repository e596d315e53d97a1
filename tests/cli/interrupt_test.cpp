#include <algorithm>
#include <csignal>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <string>

#include "program_fixture.h"

namespace voroprobe
{
namespace
{

//! So small that the mesh would have millions of vertices: every signal comes in the middle.
const std::vector<std::string> kLongRun{"--size", "0.01", "--progress", "json"};

bool refines(const std::string& err)
{
    return err.find("\"vertices\":1") != std::string::npos || err.find("\"vertices\":2") != std::string::npos;
}

class InterruptTest : public ProgramTest, public testing::WithParamInterface<int>
{
};

TEST_P(InterruptTest, ends_with_130_and_leaves_no_file)
{
    const auto outcome = program::run_and_signal(mesh_ball("out.stl", kLongRun), GetParam(), refines);
    EXPECT_EQ(outcome.status, 130) << outcome.err;
    EXPECT_NE(outcome.err.find("voroprobe: error: interrupted"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("\n\n"), std::string::npos) << "an empty line in " << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"ball.mha"}));
}

TEST_P(InterruptTest, leaves_an_older_mesh_and_summary_as_they_were)
{
    program::write_text(folder_ / "out.stl", "precious");
    program::write_text(folder_ / "out.json", "precious too");
    std::vector<std::string> arguments = mesh_ball("out.stl", kLongRun);
    arguments.insert(arguments.end(), {"--summary", folder_ / "out.json"});

    EXPECT_EQ(program::run_and_signal(arguments, GetParam(), refines).status, 130);
    EXPECT_EQ(program::read_text(folder_ / "out.stl"), "precious");
    EXPECT_EQ(program::read_text(folder_ / "out.json"), "precious too");
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"ball.mha", "out.json", "out.stl"}));
}

TEST_P(InterruptTest, while_the_file_is_being_written_it_still_leaves_no_trace)
{
    program::write_text(folder_ / "out.obj", "precious");
    const std::vector<std::string> names = folder_.names();
    const auto writes = [&](const std::string& err)
    { return err.find("\"phase\":\"write\"") != std::string::npos && folder_.names().size() > names.size(); };

    // On a busy machine the signal may be sent after the end: then again, with more to write.
    int status = 0;
    for (const char* size : {"0.2", "0.15", "0.1"})
        if (status == 0)
        {
            program::write_text(folder_ / "out.obj", "precious");
            status = program::run_and_signal(
                         mesh_ball("out.obj", {"--size", size, "--distance", "1", "--progress", "json"}),
                         GetParam(), writes)
                         .status;
        }
    EXPECT_EQ(status, 130);
    EXPECT_EQ(program::read_text(folder_ / "out.obj"), "precious");
    EXPECT_EQ(folder_.names(), names);
}

std::ptrdiff_t files_in(const std::filesystem::path& folder)
{
    std::error_code missing; // then there are none
    const std::filesystem::directory_iterator files(folder, missing);
    return missing ? 0 : std::distance(begin(files), end(files));
}

class ManyFilesTest : public InterruptTest
{
protected:
    //! Interrupts a command once three of its files are there: it tells how many there are in the end.
    void expect_files_counted(const std::vector<std::string>& arguments, std::size_t expected)
    {
        const std::filesystem::path out = folder_ / "out";
        const auto outcome = program::run_and_signal(arguments, GetParam(),
                                                     [&](const std::string&) { return files_in(out) > 3; });
        EXPECT_EQ(outcome.status, 130) << outcome.err;
        EXPECT_EQ(outcome.err, "voroprobe: error: interrupted; " + std::to_string(files_in(out)) + " of " +
                                   std::to_string(expected) + " files were written\n");
        EXPECT_LT(files_in(out), expected);
        for (const auto& file : std::filesystem::directory_iterator(out))
            EXPECT_EQ(file.path().extension(), ".stl") << file.path();
    }
};

//! OFF: tetrahedra in a row.
std::string tetrahedra(std::size_t count)
{
    std::ostringstream vertices;
    std::ostringstream faces;
    for (std::size_t n = 0; n < count; ++n)
    {
        const std::size_t x = 2 * n;
        vertices << x << " 0 0\n" << x + 1 << " 0 0\n" << x << " 1 0\n" << x << " 0 1\n";
        const std::size_t v = 4 * n;
        faces << "3 " << v << ' ' << v + 2 << ' ' << v + 1 << "\n3 " << v << ' ' << v + 1 << ' ' << v + 3
              << "\n3 " << v + 1 << ' ' << v + 2 << ' ' << v + 3 << "\n3 " << v + 2 << ' ' << v << ' '
              << v + 3 << '\n';
    }
    const std::string total = std::to_string(4 * count);
    return "OFF\n" + total + ' ' + total + " 0\n" + vertices.str() + faces.str();
}

TEST_P(ManyFilesTest, bodies_that_were_written_are_counted)
{
    constexpr std::size_t kBodies = 2000;
    program::write_text(folder_ / "bodies.off", tetrahedra(kBodies));
    expect_files_counted({"process", folder_ / "bodies.off", "--split", "-o", folder_ / "out/{n}.stl"},
                         kBodies);
}

TEST_P(ManyFilesTest, labels_that_were_written_are_counted)
{
    Phantom columns = ball_phantom();
    columns.field = [](const Point3& p) { return 1.0 + p.y + 24.0 * p.z; };
    write_phantom(columns, folder_ / "labels.mha");
    expect_files_counted({"mesh", folder_ / "labels.mha", "--labels", "all", "--max-labels", "576", "-o",
                          folder_ / "out/{label}.stl"},
                         576);
}

INSTANTIATE_TEST_SUITE_P(Signals, ManyFilesTest, testing::Values(SIGINT, SIGTERM),
                         [](const auto& test) { return test.param == SIGINT ? "SIGINT" : "SIGTERM"; });

INSTANTIATE_TEST_SUITE_P(Signals, InterruptTest, testing::Values(SIGINT, SIGTERM),
                         [](const auto& test) { return test.param == SIGINT ? "SIGINT" : "SIGTERM"; });

} // namespace
} // namespace voroprobe
