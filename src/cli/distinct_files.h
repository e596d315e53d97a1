#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace voroprobe
{

//! A file that a command reads or writes, and what its user calls it: "INPUT", "--summary", "OUT for body 2".
struct NamedFile
{
    std::string name;
    std::filesystem::path path;
};

//! \throw UsageError that names both where an output is an input or another output, however the paths are
//! written: it would be overwritten.
void check_distinct(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

} // namespace voroprobe
