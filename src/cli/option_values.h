#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/vec3.h"

namespace voroprobe
{

//! Which numbers an option takes, as a test and in words.
struct NumberRule
{
    bool (*allows)(double);
    std::string_view words;
};

extern const NumberRule kAnyFinite;  //!< "a finite number"
extern const NumberRule kLength;     //!< "a number > 0, mm"
extern const NumberRule kVolume;     //!< "a number > 0, mm3"
extern const NumberRule kFacetAngle; //!< "a number from 0 to 30, degrees"

//! \throw UsageError "OPTION is 'TEXT'; allowed: ALLOWED".
[[noreturn]] void refuse_value(std::string_view option, std::string_view text, std::string_view allowed);

//! The words an option takes, in the order of the help, and what each stands for.
template <typename Value>
using Words = std::vector<std::pair<std::string, Value>>;

//! "closed|open"
template <typename Value>
std::string joined_words(const Words<Value>& words, const std::string& separator = "|")
{
    std::string names;
    for (const auto& [word, value] : words)
        names += (names.empty() ? "" : separator) + word;
    return names;
}

//! What the word stands for. \throw UsageError that lists the allowed words.
template <typename Value>
Value parse_word(std::string_view option, std::string_view text, const Words<Value>& words)
{
    for (const auto& [word, value] : words)
        if (word == text)
            return value;
    refuse_value(option, text, joined_words(words, ", "));
}

//! The number that `text` spells from its first to its last character.
//! \throw UsageError that names the option, the text and what is allowed; NaN and infinities are never
//! allowed.
double parse_number(std::string_view option, std::string_view text, const NumberRule& rule);

//! The whole number >= `lowest` that `text` spells. \throw UsageError as parse_number.
std::size_t parse_count(std::string_view option, std::string_view text, std::size_t lowest);

//! Three lengths separated by commas, "0.5,0.5,3". \throw UsageError as parse_number.
Vec3 parse_spacing(std::string_view option, std::string_view text);

} // namespace voroprobe
