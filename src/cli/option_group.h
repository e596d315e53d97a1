#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include "cli/option_values.h"
#include "volume/level.h"

namespace voroprobe
{

//! One group of the help; every option checks its own text and names itself where it refuses it.
class OptionGroup
{
public:
    OptionGroup(CLI::App& command, std::string name) : command_(command), name_(std::move(name)) {}

    CLI::Option* text(const std::string& flag, const std::string& type, const std::string& help,
                      const std::function<void(const std::string&)>& take)
    {
        return command_.add_option_function<std::string>(flag, take, help)->type_name(type)->group(name_);
    }

    void number(const std::string& flag, const std::string& type, std::optional<double>& value,
                const NumberRule& rule, const std::string& help)
    {
        text(flag, type, help,
             [flag, &value, &rule](const std::string& given) { value = parse_number(flag, given, rule); });
    }

    template <typename Target, typename Value>
    void choice(const std::string& flag, Target& target, const Words<Value>& words, const std::string& help)
    {
        text(flag, joined_words(words), help,
             [flag, &target, words](const std::string& given) { target = parse_word(flag, given, words); });
    }

    //! "auto" leaves the value unset.
    void isovalue(std::optional<double>& value, const std::string& help)
    {
        text("--isovalue", "V|auto", help,
             [&value](const std::string& given)
             {
                 if (given != "auto")
                     value =
                         parse_number("--isovalue", given, {kAnyFinite.allows, "a finite number, or auto"});
             });
    }

    void inside(std::optional<InsideIs>& value, const std::string& help)
    {
        choice("--inside", value,
               Words<std::optional<InsideIs>>{
                   {"auto", std::nullopt}, {"above", InsideIs::kAbove}, {"below", InsideIs::kBelow}},
               help);
    }

private:
    CLI::App& command_;
    std::string name_;
};

} // namespace voroprobe
