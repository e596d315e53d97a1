#pragma once

#include <gtest/gtest.h>

#include "phantom_file.h"
#include "program.h"

namespace voroprobe
{

//! A folder with a small ball to mesh, ball.mha.
class ProgramTest : public testing::Test
{
protected:
    ProgramTest() { write_phantom(ball_phantom(), folder_ / "ball.mha"); }

    //! Arguments that mesh the ball coarsely into `output`, and whatever else is asked.
    [[nodiscard]] std::vector<std::string> mesh_ball(const std::string& output,
                                                     std::vector<std::string> more = {}) const
    {
        std::vector<std::string> arguments{"mesh",           folder_ / "ball.mha", "-o",
                                           folder_ / output, "--isovalue",         "0"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }

    program::ScratchFolder folder_;
};

//! Whether the text is one line that begins as all refusals of the program do.
inline bool is_one_error_line(const std::string& err)
{
    return err.starts_with("voroprobe: error: ") && err.find('\n') + 1 == err.size();
}

} // namespace voroprobe
