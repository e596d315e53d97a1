#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace voroprobe
{

//! What a pattern is filled in with.
struct PatternValues
{
    std::string label; //!< for {label}
    std::string name;  //!< for {name}; what file names cannot hold is replaced by an underscore
};

//! Whether an output path has a {label} or {name} in it.
bool is_output_pattern(const std::filesystem::path& path);

//! The paths that a pattern gives, one for each of `values`. \throw UsageError where there are other words in
//! braces, and where two are the same path, also but for the case of letters: one would overwrite the other.
std::vector<std::filesystem::path> expand_pattern(const std::filesystem::path& pattern,
                                                  std::span<const PatternValues> values);

//! Makes the folder that a path of a pattern lies in, where it is missing. \throw OutputError with the
//! reason.
void make_folder_of(const std::filesystem::path& path);

} // namespace voroprobe
