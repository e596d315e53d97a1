#include "support/utf8.h"

#include <gtest/gtest.h>

namespace voroprobe
{
namespace
{

TEST(Utf8, characters_of_one_to_four_bytes_are_well_formed)
{
    for (const char* text : {"", "rib", "C\xC3\xB4te", "\xE2\x82\xAC", "\xED\x9F\xBF", "\xF0\x9F\xA6\xB4",
                             "\xF4\x8F\xBF\xBF", "\xE0\xA0\x80", "\xF0\x90\x80\x80"})
        EXPECT_TRUE(is_utf8(text)) << text;
}

TEST(Utf8, cut_overlong_surrogate_and_too_large_are_not)
{
    for (const char* text :
         {"C\xF4te", "\xC3", "\xE2\x82", "\x80", "\xC0\x80", "\xC1\xBF", "\xE0\x9F\xBF", "\xED\xA0\x80",
          "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF", "a\xC3z"})
        EXPECT_FALSE(is_utf8(text)) << text;
}

TEST(Utf8, what_is_no_utf8_is_taken_for_latin_1)
{
    EXPECT_EQ(as_utf8("C\xF4te \xE0 gauche \xFF\x80"), "C\xC3\xB4te \xC3\xA0 gauche \xC3\xBF\xC2\x80");
    EXPECT_EQ(as_utf8("C\xC3\xB4te"), "C\xC3\xB4te");
    EXPECT_EQ(as_utf8(""), "");
}

} // namespace
} // namespace voroprobe
