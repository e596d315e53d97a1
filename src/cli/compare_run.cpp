#include "cli/compare_run.h"

#include <algorithm>
#include <ctime>
#include <string_view>
#include <thread>
#include <utility>

namespace voroprobe
{

namespace
{

constexpr std::string_view kPlainCharacters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=,:+@%";

std::string today()
{
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%d", &utc);
    return text;
}

//! What the shell would have to be given: words with anything else than the usual are quoted.
std::string command_text(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words)
    {
        const bool plain = !word.empty() && word.find_first_not_of(kPlainCharacters) == std::string::npos;
        std::string quoted = "'";
        for (const char c : word)
            quoted += c == '\'' ? "'\\''" : std::string(1, c);
        text += (text.empty() ? "" : " ") + (plain ? word : quoted + "'");
    }
    return text;
}

} // namespace

ScanFacts run_facts(const CompareArguments& arguments, const std::filesystem::path& path)
{
    const std::filesystem::path name =
        path.filename().empty() ? path.parent_path().filename() : path.filename();
    return {.name = name.string(),
            .path = path.string(),
            .format = {},
            .stored_type = {},
            .size = {},
            .spacing = {},
            .warnings = {},
            .version = VOROPROBE_VERSION,
            .command = command_text(arguments.command),
            .date = today(),
            .stem = {}};
}

CompetitionOptions competition_options(const CompareArguments& arguments, double angle_bound_deg,
                                       bool pictures_fail, std::function<void(const std::string&)> tell)
{
    return {.measuring = {.mesh_samples = arguments.samples, .angle_bound_deg = angle_bound_deg},
            .contestant_seconds = arguments.contestant_seconds,
            .sweep_seconds = arguments.sweep_seconds,
            .at_once = arguments.at_once.value_or(std::max(1U, std::thread::hardware_concurrency())),
            .pictures = arguments.pictures && !pictures_fail,
            .tell = std::move(tell)};
}

bool takes_part(const CompareArguments& arguments, const std::string& name)
{
    return !arguments.contestants || std::find(arguments.contestants->begin(), arguments.contestants->end(),
                                               name) != arguments.contestants->end();
}

} // namespace voroprobe
