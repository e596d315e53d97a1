#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "compare/contestant.h"

namespace voroprobe::bench
{

//! `voroprobe mesh` as users run it, on the file that the task's volume was read from: from the file to an
//! STL file, certificate included. \throw std::runtime_error, on the clock, where the program fails.
std::unique_ptr<Contestant> make_command(const MeshingTask& task, const std::filesystem::path& volume);

//! The same way for another contestant: the file is read as ours is, and the STL file written plainly.
std::unique_ptr<Contestant>
make_file_to_stl(const MeshingTask& task, const std::filesystem::path& volume,
                 std::function<std::unique_ptr<Contestant>(const MeshingTask&)> make);

} // namespace voroprobe::bench
