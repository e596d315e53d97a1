#include "support/utf8.h"

#include <cstddef>

namespace voroprobe
{
namespace
{

//! What may follow a first byte: how many bytes, and the range of the next one; the others are 0x80 to 0xBF.
struct Sequence
{
    std::size_t more;
    unsigned char low = 0x80;
    unsigned char high = 0xBF;
};

constexpr std::size_t kNoFirstByte = 4;

Sequence sequence_of(unsigned char first)
{
    if (first < 0x80)
        return {0};
    if (first < 0xC2 || first > 0xF4)
        return {kNoFirstByte};
    if (first < 0xE0)
        return {1};
    if (first < 0xF0)
        return {2, static_cast<unsigned char>(first == 0xE0 ? 0xA0 : 0x80),
                static_cast<unsigned char>(first == 0xED ? 0x9F : 0xBF)};
    return {3, static_cast<unsigned char>(first == 0xF0 ? 0x90 : 0x80),
            static_cast<unsigned char>(first == 0xF4 ? 0x8F : 0xBF)};
}

//! Bytes of the character that `text` begins with; 0 where it begins with none.
std::size_t first_character(std::string_view text)
{
    Sequence sequence = sequence_of(static_cast<unsigned char>(text.front()));
    if (sequence.more == kNoFirstByte || sequence.more >= text.size())
        return 0;
    for (std::size_t i = 1; i <= sequence.more; ++i)
    {
        const auto byte = static_cast<unsigned char>(text[i]);
        if (byte < sequence.low || byte > sequence.high)
            return 0;
        sequence = {sequence.more};
    }
    return 1 + sequence.more;
}

} // namespace

bool is_utf8(std::string_view text)
{
    while (!text.empty())
    {
        const std::size_t bytes = first_character(text);
        if (bytes == 0)
            return false;
        text.remove_prefix(bytes);
    }
    return true;
}

std::string as_utf8(std::string text)
{
    if (is_utf8(text))
        return text;
    std::string converted;
    for (const char c : text)
    {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80)
            converted += c;
        else // U+0080 to U+00FF
            converted.append({static_cast<char>(0xC0 | byte >> 6), static_cast<char>(0x80 | (byte & 0x3F))});
    }
    return converted;
}

} // namespace voroprobe
