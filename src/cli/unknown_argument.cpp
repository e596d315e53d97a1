#include "cli/unknown_argument.h"

#include <algorithm>
#include <numeric>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace voroprobe
{
namespace
{

//! Letters to put in, leave out or exchange to make one word of the other (Levenshtein).
std::size_t count_slips(std::string_view word, std::string_view other)
{
    std::vector<std::size_t> slips(other.size() +
                                   1); // from what was read of the word to each beginning of other
    std::iota(slips.begin(), slips.end(), std::size_t{0});
    for (std::size_t i = 0; i < word.size(); ++i)
    {
        std::size_t diagonal = slips[0];
        slips[0] = i + 1;
        for (std::size_t j = 0; j < other.size(); ++j)
        {
            const std::size_t exchanged = diagonal + (word[i] == other[j] ? 0 : 1);
            diagonal = slips[j + 1];
            slips[j + 1] = std::min({exchanged, slips[j] + 1, diagonal + 1});
        }
    }
    return slips.back();
}

//! The known word that is meant, if the given one differs from it in no more than a third of its letters.
std::string nearest(const std::string& given, const std::vector<std::string>& known)
{
    std::string best;
    std::size_t fewest = std::max<std::size_t>(1, given.size() / 3) + 1;
    for (const std::string& word : known)
    {
        const std::size_t slips = count_slips(given, word);
        if (slips >= fewest)
            continue;
        fewest = slips;
        best = word;
    }
    return best;
}

std::string suggestion(const std::string& word)
{
    return word.empty() ? "" : "; did you mean " + word + "?";
}

std::string list_of_commands(const CLI::App& app)
{
    std::string list;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        list += (list.empty() ? "" : ", ") + command->get_name();
    return list;
}

std::vector<std::string> names_of_options(const CLI::App& command)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    return names;
}

} // namespace

std::string unknown_argument_text(const CLI::App& app)
{
    const auto commands = app.get_subcommands();
    const CLI::App& command = commands.empty() ? app : *commands.front();
    const std::vector<std::string> unexpected = command.remaining();
    const std::string argument = unexpected.empty() ? "" : unexpected.front();

    const std::string program = app.get_name();
    const std::string help = program + (commands.empty() ? "" : ' ' + command.get_name()) + " --help";
    if (argument.starts_with('-'))
    {
        const std::string option = argument.substr(0, argument.find('='));
        return option + " is no option" +
               (commands.empty() ? "" : " of " + program + ' ' + command.get_name()) +
               suggestion(nearest(option, names_of_options(command))) + " (see " + help + ')';
    }
    if (commands.empty())
        return '\'' + argument + "' is no command; allowed: " + list_of_commands(app) + " (see " + help + ')';
    return '\'' + argument + "' is one argument too many (see " + help + ')';
}

} // namespace voroprobe
