#include "support/text.h"

#include <gtest/gtest.h>

namespace voroprobe
{
namespace
{

TEST(Text, lower_case_leaves_what_is_no_letter_of_ascii)
{
    EXPECT_EQ(lower_case(".NII.gz Z[@`"), ".nii.gz z[@`");
    EXPECT_EQ(lower_case("\xC4\xC3\x84"), "\xC4\xC3\x84");
}

TEST(Text, trimmed_takes_blanks_from_both_ends_only)
{
    EXPECT_EQ(trimmed(" \t left kidney\r"), "left kidney");
    EXPECT_EQ(trimmed(" \t\r"), "");
    EXPECT_EQ(trimmed(""), "");
}

} // namespace
} // namespace voroprobe
