#include "cli/label_ranges.h"

#include <gtest/gtest.h>

#include "support/error.h"

namespace voroprobe
{
namespace
{

TEST(LabelRanges, numbers_and_ranges_are_taken_at_their_word)
{
    const LabelRanges ranges("--labels", "1,5,7-9");
    for (const LabelValue label : {1, 5, 7, 8, 9})
        EXPECT_TRUE(ranges.contains(label)) << label;
    for (const LabelValue label : {0, 2, 6, 10})
        EXPECT_FALSE(ranges.contains(label)) << label;
    EXPECT_TRUE(LabelRanges("--labels", "all").contains(-3));
    EXPECT_TRUE(LabelRanges("--labels", "-3--1").contains(-2));
}

TEST(LabelRanges, what_is_not_among_the_labels_is_named)
{
    EXPECT_EQ(LabelRanges("--labels", "1,4,7-9,20-30").not_among({1, 8, 9}), "4, 20 to 30");
    EXPECT_EQ(LabelRanges("--labels", "all").not_among({1}), "");
}

TEST(LabelRanges, other_texts_are_refused)
{
    for (const char* text :
         {"", "1,", ",1", "1 2", "9-7", "1-", "every", "1.5", "1;2", "99999999999999999999"})
        EXPECT_THROW(LabelRanges("--labels", text), UsageError) << text;
}

TEST(LabelRanges, labels_are_told_in_ranges)
{
    EXPECT_EQ(labels_text({1, 2, 3, 5, 7, 8}), "1 to 3, 5, 7, 8");
    EXPECT_EQ(labels_text({}), "");
    std::vector<LabelValue> many;
    for (LabelValue label = 0; label < 200; label += 2)
        many.push_back(label);
    EXPECT_TRUE(labels_text(many).ends_with(" and 60 more"));
}

} // namespace
} // namespace voroprobe
