#include "cli/option_values.h"

#include <gtest/gtest.h>

#include "support/error.h"

namespace voroprobe
{
namespace
{

TEST(OptionValues, numbers_are_read_whole)
{
    EXPECT_EQ(parse_number("--isovalue", "-200", kAnyFinite), -200.0);
    EXPECT_EQ(parse_number("--size", "+2.5e-1", kLength), 0.25);
    EXPECT_EQ(parse_number("--angle", "0", kFacetAngle), 0.0);
    EXPECT_EQ(parse_number("--angle", "30", kFacetAngle), 30.0);
}

TEST(OptionValues, nonsense_is_refused)
{
    for (const char* text :
         {"", " ", "two", "2mm", "2,5", "nan", "NaN", "inf", "-inf", "1e999", "0x10", "--", "+", "2 3"})
        EXPECT_THROW(parse_number("--isovalue", text, kAnyFinite), UsageError) << text;
    for (const char* text : {"0", "-1", "-0"})
        EXPECT_THROW(parse_number("--size", text, kLength), UsageError) << text;
    for (const char* text : {"-0.001", "30.001"})
        EXPECT_THROW(parse_number("--angle", text, kFacetAngle), UsageError) << text;
}

TEST(OptionValues, refusals_name_option_value_and_range)
{
    try
    {
        parse_number("--size", "nan", kLength);
        FAIL() << "nan was taken";
    }
    catch (const UsageError& error)
    {
        EXPECT_STREQ(error.what(), "--size is 'nan'; allowed: a number > 0, mm");
    }
}

TEST(OptionValues, counts_are_whole_and_not_below_their_bound)
{
    EXPECT_EQ(parse_count("--seed", "0", 0), 0U);
    EXPECT_EQ(parse_count("--seed", "18446744073709551615", 0), 18446744073709551615U);
    for (const char* text : {"", "-1", "1.5", "1e3", "18446744073709551616", "one"})
        EXPECT_THROW(parse_count("--seed", text, 0), UsageError) << text;
    EXPECT_THROW(parse_count("--threads", "0", 1), UsageError);
}

TEST(OptionValues, spacing_is_three_lengths)
{
    EXPECT_EQ(parse_spacing("--spacing", "0.5,0.25,3"), (Vec3{0.5, 0.25, 3}));
    for (const char* text :
         {"", "1", "1,2", "1,2,", "1,2,3,", "1,2,3,4", "1,2,0", "1,-2,3", "1,nan,3", "1;2;3", ",,"})
        EXPECT_THROW(parse_spacing("--spacing", text), UsageError) << text;
}

TEST(OptionValues, words_are_looked_up)
{
    const Words<int> words{{"closed", 1}, {"open", 2}};
    EXPECT_EQ(parse_word("--border", "open", words), 2);
    EXPECT_THROW(parse_word("--border", "ajar", words), UsageError);
    EXPECT_EQ(joined_words(words), "closed|open");
}

} // namespace
} // namespace voroprobe
