#include "io/volume_natural_order.h"

#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace voroprobe
{

namespace
{

TEST(NaturalOrder, numbers_compare_by_value)
{
    const std::vector<std::string_view> ordered{"",    "a",     "a1b2", "a1b10",  "a2b1",
                                                "a10", "a0100", "b",    "s9.tif", "s10.tif"};
    for (std::size_t i = 0; i < ordered.size(); ++i)
        for (std::size_t j = 0; j < ordered.size(); ++j)
            EXPECT_EQ(natural_less(ordered[i], ordered[j]), i < j) << ordered[i] << " and " << ordered[j];
}

TEST(NaturalOrder, numbers_of_any_length_compare)
{
    EXPECT_TRUE(natural_less("x99999999999999999999998", "x99999999999999999999999"));
    EXPECT_FALSE(natural_less("x99999999999999999999999", "x99999999999999999999998"));
}

TEST(NaturalOrder, equal_numbers_are_ordered_by_their_zeros)
{
    EXPECT_TRUE(natural_less("x01", "x1"));
    EXPECT_FALSE(natural_less("x1", "x01"));
    EXPECT_FALSE(natural_less("x01", "x01"));
}

} // namespace

} // namespace voroprobe
