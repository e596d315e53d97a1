#include "cli/distinct_files.h"

#include <map>
#include <system_error>

#include "support/error.h"

namespace voroprobe
{
namespace
{

namespace fs = std::filesystem;

//! Links followed; the same for all ways to write a path, whether the file is there or not.
fs::path one_of_all_spellings(const fs::path& path)
{
    std::error_code unknown; // then it stays as it is written
    const fs::path absolute = fs::absolute(path, unknown);
    const fs::path canonical = fs::weakly_canonical(unknown ? path : absolute, unknown);
    return unknown ? path : canonical;
}

} // namespace

void check_distinct(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs)
{
    std::map<fs::path, std::string> name_of;
    for (const NamedFile& input : inputs)
        name_of.emplace(one_of_all_spellings(input.path), input.name);
    for (const NamedFile& output : outputs)
    {
        const auto [known, is_new] = name_of.emplace(one_of_all_spellings(output.path), output.name);
        if (!is_new)
            throw UsageError(output.name + " and " + known->second + " are both " + output.path.string() +
                             "; allowed: two files");
    }
}

} // namespace voroprobe
