#include "cli/number_text.h"

#include <gtest/gtest.h>

namespace voroprobe
{
namespace
{

TEST(NumberText, has_six_digits_and_no_minus_zero)
{
    EXPECT_EQ(number_text(0.375), "0.375");
    EXPECT_EQ(number_text(1150.5), "1150.5");
    EXPECT_EQ(number_text(-0.0), "0");
    EXPECT_EQ(number_text(1e-9), "1e-09");
    EXPECT_EQ(number_text(1.0 / 3.0), "0.333333");
}

TEST(NumberText, counts_are_grouped_by_thousands)
{
    EXPECT_EQ(count_text(0), "0");
    EXPECT_EQ(count_text(999), "999");
    EXPECT_EQ(count_text(1000), "1,000");
    EXPECT_EQ(count_text(1234567), "1,234,567");
}

TEST(NumberText, one_is_told_in_the_singular)
{
    EXPECT_EQ(plural_text(1, "face"), "1 face");
    EXPECT_EQ(plural_text(0, "face"), "0 faces");
    EXPECT_EQ(plural_text(1234, "vertex", "vertices"), "1,234 vertices");
}

TEST(NumberText, shares_are_percentages)
{
    EXPECT_EQ(percent_text(0.372055), "37.2 %");
    EXPECT_EQ(percent_text(1.0), "100 %");
}

TEST(NumberText, bytes_take_the_unit_that_fits)
{
    EXPECT_EQ(bytes_text(0), "0 bytes");
    EXPECT_EQ(bytes_text(118'000'000), "118 MB");
    EXPECT_EQ(bytes_text(2'500'000'000), "2.5 GB");
}

} // namespace
} // namespace voroprobe
