#include "io/label_table.h"

#include <fstream>

#include <gtest/gtest.h>

#include "support/error.h"
#include "temporary_folder.h"

namespace voroprobe
{
namespace
{

class LabelTable : public testing::Test
{
protected:
    std::vector<LabelEntry> table_of(const std::string& text)
    {
        const std::filesystem::path path = folder_.path() / "names.txt";
        std::ofstream(path) << text;
        return read_label_table(path);
    }

    TemporaryFolder folder_;
};

TEST_F(LabelTable, reads_label_descriptions_of_itk_snap)
{
    const auto table = table_of("################\n"
                                "# IDX   -R-  -G-  -B-  -A--  VIS MSH  LABEL\n"
                                "    0     0    0    0        0  0  0    \"Clear Label\"\n"
                                "    1   255    0   10        1  1  1    \"Left kidney\"\r\n");
    ASSERT_EQ(table.size(), 2U);
    EXPECT_EQ(table[1].value, 1);
    EXPECT_EQ(table[1].name, "Left kidney");
    EXPECT_EQ(table[1].color, (Color{255, 0, 10}));
}

TEST_F(LabelTable, reads_look_up_tables_of_freesurfer_and_slicer)
{
    const auto table = table_of("#No. Label Name:                            R   G   B   A\n"
                                "17  Left-Hippocampus                        220 216 20  0\n"
                                "18  region with blanks                      103 255 255 255\n");
    ASSERT_EQ(table.size(), 2U);
    EXPECT_EQ(table[0].name, "Left-Hippocampus");
    EXPECT_EQ(table[0].color, (Color{220, 216, 20}));
    EXPECT_EQ(table[1].name, "region with blanks");
}

TEST_F(LabelTable, names_in_latin_1_become_utf8_and_those_in_utf8_stay)
{
    for (const std::string text :
         {"1 C\xF4te\n2 rein \xE0 gauche\n", "1 C\xC3\xB4te\n2 rein \xC3\xA0 gauche\n"})
    {
        const auto table = table_of(text);
        ASSERT_EQ(table.size(), 2U);
        EXPECT_EQ(table[0].name, "C\xC3\xB4te");
        EXPECT_EQ(table[1].name, "rein \xC3\xA0 gauche");
    }
}

TEST_F(LabelTable, reads_lines_of_a_number_and_a_name)
{
    const auto table =
        table_of("1 spleen\n\n2\tright kidney\n3,liver\n4: x\n-5 = \"aorta\"\n6 lobe 2\n// end\n");
    ASSERT_EQ(table.size(), 6U);
    EXPECT_EQ(table[0].name, "spleen");
    EXPECT_EQ(table[1].name, "right kidney");
    EXPECT_EQ(table[2].name, "liver");
    EXPECT_EQ(table[3].name, "x");
    EXPECT_EQ(table[4].value, -5);
    EXPECT_EQ(table[4].name, "aorta");
    EXPECT_EQ(table[5].name, "lobe 2");
    EXPECT_FALSE(table[0].color.has_value());
}

TEST_F(LabelTable, what_is_no_table_is_refused_with_its_line)
{
    const auto message_of = [&](const std::string& text)
    {
        try
        {
            table_of(text);
        }
        catch (const InputError& error)
        {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(message_of("1 a\nliver 2\n").find("line 2"), std::string::npos);
    EXPECT_NE(message_of("1 a\n1 b\n").find("label 1"), std::string::npos);
    EXPECT_EQ(message_of("1 a\n1 a\n"), "");
    EXPECT_THROW(read_label_table(folder_.path() / "absent.txt"), InputError);
}

} // namespace
} // namespace voroprobe
