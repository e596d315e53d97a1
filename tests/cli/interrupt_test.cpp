#include <algorithm>
#include <csignal>

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

INSTANTIATE_TEST_SUITE_P(Signals, InterruptTest, testing::Values(SIGINT, SIGTERM),
                         [](const auto& test) { return test.param == SIGINT ? "SIGINT" : "SIGTERM"; });

} // namespace
} // namespace voroprobe
