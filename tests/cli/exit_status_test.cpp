#include <csignal>
#include <limits>

#include "program_fixture.h"

namespace voroprobe
{
namespace
{

using program::Outcome;
using program::run;

class ExitStatusTest : public ProgramTest
{
protected:
    //! The status, one line about it that holds `words`, and no mesh.
    void expect_refusal(const Outcome& outcome, int status, const std::string& words)
    {
        EXPECT_EQ(outcome.status, status) << outcome.err;
        EXPECT_TRUE(is_one_error_line(outcome.err)) << outcome.err;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(folder_ / "out.stl"));
    }
};

TEST_F(ExitStatusTest, done_is_0)
{
    const Outcome outcome = run(mesh_ball("out.stl"));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"ball.mha", "out.stl"}));
}

TEST_F(ExitStatusTest, an_output_that_cannot_be_written_is_1_and_told_before_the_input_is_read)
{
    expect_refusal(run({"mesh", folder_ / "no_such.mha", "-o", folder_ / "no_such_folder/out.stl"}), 1,
                   "no_such_folder");
    expect_refusal(run(mesh_ball("out.stl", {"--summary", folder_ / "no_such_folder/out.json"})), 1,
                   "no_such_folder");
    std::filesystem::create_directory(folder_ / "taken.stl");
    expect_refusal(run(mesh_ball("taken.stl")), 1, "taken.stl");
}

TEST_F(ExitStatusTest, an_input_that_is_missing_is_3)
{
    expect_refusal(run({"mesh", folder_ / "no_such.mha", "-o", folder_ / "out.stl"}), 3, "no_such.mha");
    expect_refusal(run({"info", folder_ / "no_such.mha"}), 3, "no_such.mha");
}

TEST_F(ExitStatusTest, an_input_that_is_broken_is_3)
{
    program::write_text(folder_ / "garbage.nrrd", "not a volume at all");
    expect_refusal(run({"mesh", folder_ / "garbage.nrrd", "-o", folder_ / "out.stl"}), 3, "garbage.nrrd");

    const std::string whole = program::read_text(folder_ / "ball.mha");
    program::write_text(folder_ / "half.mha", whole.substr(0, whole.size() / 2));
    expect_refusal(run({"mesh", folder_ / "half.mha", "-o", folder_ / "out.stl"}), 3, "half.mha");
    expect_refusal(run({"info", folder_ / "half.mha"}), 3, "half.mha");

    program::write_text(folder_ / "empty.nii.gz", "");
    expect_refusal(run({"mesh", folder_ / "empty.nii.gz", "-o", folder_ / "out.stl"}), 3, "empty.nii.gz");
}

TEST_F(ExitStatusTest, an_isovalue_beyond_the_samples_is_4_with_one_that_works)
{
    const Outcome outcome =
        run({"mesh", folder_ / "ball.mha", "-o", folder_ / "out.stl", "--isovalue", "1000"});
    expect_refusal(outcome, 4, "try --isovalue ");

    const std::size_t advice = outcome.err.find("--isovalue ") + std::string("--isovalue ").size();
    const std::string working = outcome.err.substr(advice, outcome.err.find(' ', advice) - advice);
    EXPECT_EQ(run({"mesh", folder_ / "ball.mha", "-o", folder_ / "out.stl", "--isovalue", working}).status, 0)
        << working;
}

TEST_F(ExitStatusTest, a_constant_volume_is_4)
{
    Phantom constant = ball_phantom();
    constant.field = [](const Point3&) { return 7.0; };
    write_phantom(constant, folder_ / "constant.mha");
    expect_refusal(run({"mesh", folder_ / "constant.mha", "-o", folder_ / "out.stl"}), 4,
                   "all samples equal 7");
}

TEST_F(ExitStatusTest, a_volume_without_numbers_is_4)
{
    Phantom nothing = ball_phantom();
    nothing.field = [](const Point3&) { return std::numeric_limits<double>::quiet_NaN(); };
    write_phantom(nothing, folder_ / "nothing.mha");
    for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--isovalue", "1"}})
    {
        std::vector<std::string> arguments{"mesh", folder_ / "nothing.mha", "-o", folder_ / "out.stl"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 4);
        const std::size_t warning = outcome.err.find("voroprobe: warning: ");
        const std::size_t error = outcome.err.find("voroprobe: error: no surface: all ");
        EXPECT_NE(outcome.err.find(" samples are NaN or infinite\n"), std::string::npos) << outcome.err;
        EXPECT_LT(warning, error) << outcome.err;
        EXPECT_NE(error, std::string::npos) << outcome.err;
    }
}

TEST_F(ExitStatusTest, a_spent_budget_is_6_and_the_partial_mesh_is_written_and_flagged)
{
    const Outcome outcome = run(
        mesh_ball("out.stl", {"--size", "0.3", "--max-vertices", "200", "--summary", folder_ / "out.json"}));
    EXPECT_EQ(outcome.status, 6) << outcome.err;
    EXPECT_TRUE(is_one_error_line(outcome.err)) << outcome.err;
    EXPECT_NE(outcome.err.find("--max-vertices 200"), std::string::npos) << outcome.err;
    EXPECT_TRUE(std::filesystem::exists(folder_ / "out.stl"));
    EXPECT_NE(program::read_text(folder_ / "out.json").find("\"status\": \"partial\""), std::string::npos);
    EXPECT_NE(outcome.out.find("(partial)"), std::string::npos) << outcome.out;
}

//! A volume of zeros whose samples take no room on the disk.
void write_sparse_volume(const std::filesystem::path& header, std::size_t side)
{
    const std::string raw = header.stem().string() + ".raw";
    program::write_text(header, "ObjectType = Image\nNDims = 3\nDimSize = " + std::to_string(side) + ' ' +
                                    std::to_string(side) + ' ' + std::to_string(side) +
                                    "\nElementType = MET_UCHAR\nElementDataFile = " + raw + '\n');
    program::write_text(header.parent_path() / raw, "");
    std::filesystem::resize_file(header.parent_path() / raw, side * side * side);
}

TEST_F(ExitStatusTest, out_of_memory_is_6)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "the sanitizers need the address space that this test takes away";
#endif
    write_sparse_volume(folder_ / "big.mhd", 1500);
    const program::Limits limits{.address_space =
                                     2'000'000'000}; // less than the samples, more than the libraries
    expect_refusal(run({"mesh", folder_ / "big.mhd", "-o", folder_ / "out.stl"}, limits), 6, "out of memory");
}

TEST_F(ExitStatusTest, a_disk_that_fills_up_is_1_and_leaves_nothing_behind)
{
    const program::Limits limits{.file_size = 1000}; // the mesh has more
    for (const std::string name : {"old.stl", "old.ply", "old.obj", "old.off", "old.vtp", "old.3mf"})
    {
        program::write_text(folder_ / name, "precious");
        expect_refusal(run(mesh_ball(name), limits), 1, name);
        EXPECT_EQ(program::read_text(folder_ / name), "precious");
        std::filesystem::remove(folder_ / name);
    }
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"ball.mha"}));
}

TEST_F(ExitStatusTest, a_signal_while_reading_is_130)
{
    write_sparse_volume(folder_ / "zeros.mhd", 600);
    const auto reads = [](const std::string& err) { return err.find("\"read\"") != std::string::npos; };
    const Outcome outcome = program::run_and_signal(
        {"mesh", folder_ / "zeros.mhd", "-o", folder_ / "out.stl", "--progress", "json"}, SIGINT, reads);
    EXPECT_EQ(outcome.status, 130) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out.stl"));
}

TEST_F(ExitStatusTest, an_older_mesh_survives_every_refusal)
{
    program::write_text(folder_ / "old.stl", "precious");
    EXPECT_EQ(run(mesh_ball("old.stl", {"--angle", "31"})).status, 2);
    EXPECT_EQ(run({"mesh", folder_ / "no_such.mha", "-o", folder_ / "old.stl"}).status, 3);
    EXPECT_EQ(run({"mesh", folder_ / "ball.mha", "-o", folder_ / "old.stl", "--isovalue", "1000"}).status, 4);
    EXPECT_EQ(program::read_text(folder_ / "old.stl"), "precious");
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"ball.mha", "old.stl"}));
}

} // namespace
} // namespace voroprobe
