#include "io/mesh_label_writer.h"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "io/mesh_reader.h"
#include "mesh/topology.h"
#include "support/error.h"
#include "temporary_folder.h"

namespace voroprobe
{
namespace
{

TriangleMesh tetrahedron(const Point3& corner)
{
    return {{corner, corner + Vec3{1, 0, 0}, corner + Vec3{0, 1, 0}, corner + Vec3{0, 0, 1}},
            {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

class LabelWriter : public testing::Test
{
protected:
    std::string written(const std::string& name, MeshFormat format)
    {
        write_labels(parts_, labels_, folder_.path() / name, format, {"made by a test"});
        std::ifstream in(folder_.path() / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    TemporaryFolder folder_;
    std::vector<MeshPart> parts_{{.name = "left kidney",
                                  .color = Color{.red = 255, .green = 0, .blue = 51},
                                  .mesh = tetrahedron({0, 0, 0})},
                                 {.name = "tail\nbone", .mesh = tetrahedron({5, 0, 0})}};
    std::vector<std::int64_t> labels_{7, -2};
};

TEST_F(LabelWriter, obj_has_a_group_for_each_label_and_colours_where_there_are)
{
    const std::string text = written("a.obj", MeshFormat::kObj);
    EXPECT_NE(text.find("g label_7 left_kidney\nv 0 0 0 1 0 0.2\n"), std::string::npos) << text;
    EXPECT_NE(text.find("g label_-2 tail_bone\nv 5 0 0\n"), std::string::npos) << text;
    EXPECT_NE(text.find("f 5 7 6\n"), std::string::npos) << text;
}

TEST_F(LabelWriter, ply_has_the_label_and_colour_of_every_face)
{
    const std::string text = written("a.ply", MeshFormat::kPly);
    EXPECT_NE(text.find("comment label 7 left kidney\ncomment label -2 tail bone\n"), std::string::npos);
    const std::size_t begin = text.find("end_header\n") + 11;
    const std::size_t face = 1 + 3 * 4 + 4 + 3;
    ASSERT_EQ(text.size(), begin + 8 * 3 * 4 + 8 * face);
    const std::string first = text.substr(begin + 8 * 3 * 4 + 13, 7);
    EXPECT_EQ(first, std::string("\x07\0\0\0\xff\0\x33", 7));
    const std::string last = text.substr(text.size() - 7);
    EXPECT_EQ(last, "\xfe\xff\xff\xff\xc0\xc0\xc0");
}

TEST_F(LabelWriter, what_it_writes_reads_back_as_all_the_meshes_together)
{
    for (const auto& [name, format] :
         {std::pair{"a.obj", MeshFormat::kObj}, {"a.ply", MeshFormat::kPly}, {"a.3mf", MeshFormat::k3mf}})
    {
        written(name, format);
        const TriangleMesh read = weld(read_mesh(folder_.path() / name));
        EXPECT_EQ(read.vertices.size(), 8U) << name;
        EXPECT_TRUE(is_closed_manifold(read)) << name;
        EXPECT_EQ(count_components(read), 2U) << name;
    }
}

TEST_F(LabelWriter, a_label_that_ply_cannot_hold_is_refused)
{
    labels_[0] = std::int64_t{1} << 40;
    EXPECT_THROW(written("a.ply", MeshFormat::kPly), OutputError);
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "a.ply"));
    EXPECT_NE(written("a.obj", MeshFormat::kObj).find("g label_1099511627776"), std::string::npos);
}

} // namespace
} // namespace voroprobe
