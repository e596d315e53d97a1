#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>

#include "../mesh/sample_meshes.h"
#include "io/mesh_reader.h"
#include "io/mesh_writer.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "support/error.h"
#include "support/random.h"
#include "temporary_folder.h"

namespace voroprobe
{
namespace
{

namespace fs = std::filesystem;

//! The message of the InputError that reading a file of this content gives; empty when it is read.
std::string refusal(const std::string& name, const std::string& content)
{
    const TemporaryFolder folder;
    try
    {
        read_mesh(folder.file(name, content));
    }
    catch (const InputError& error)
    {
        return error.what();
    }
    return "";
}

TriangleMesh read(const std::string& name, const std::string& content)
{
    const TemporaryFolder folder;
    return read_mesh(folder.file(name, content));
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

TEST(MeshReader, tells_that_a_file_may_not_be_read)
{
    const TemporaryFolder folder;
    for (const char* name : {"a.stl", "a.ply", "a.obj", "a.off", "a.vtp", "a.3mf"})
    {
        const fs::path path = folder.file(name, "anything");
        fs::permissions(path, fs::perms::none);
        if (std::ifstream(path))
            GTEST_SKIP() << "this user may read every file";
        try
        {
            read_mesh(path);
            ADD_FAILURE() << name << " was read";
        }
        catch (const InputError& error)
        {
            EXPECT_TRUE(contains(error.what(), "Permission denied")) << error.what();
        }
    }
}

// ---- What others write ----

TEST(MeshReader, reads_off_with_comments_colours_and_polygons)
{
    const TriangleMesh mesh =
        read("a.off", "# made by hand\nCOFF\n\n5 2 0 # counts\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n"
                      "1 1 0 0 0 0 0\n0 1 0 0 0 0 0\n  0.5\t0.5 +1e0 0 0 0 0\r\n"
                      "4 3 2 1 0 0.5 0.5 0.5\n3 0 1 4\n");
    EXPECT_EQ(mesh.vertices.size(), 5U);
    ASSERT_EQ(mesh.faces.size(), 3U);
    EXPECT_EQ(mesh.faces[1], (TriangleMesh::Face{3, 1, 0}));
    EXPECT_EQ(mesh.vertices[4], (Point3{0.5, 0.5, 1.0}));
}

TEST(MeshReader, reads_off_with_the_counts_in_the_first_line)
{
    EXPECT_EQ(read("a.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2").faces.size(), 1U);
}

TEST(MeshReader, reads_obj_with_normals_textures_and_indices_from_the_end)
{
    const TriangleMesh mesh = read(
        "a.obj",
        "mtllib x.mtl\no thing\nv 0 0 0 1.0\nv 1 0 0\nvn 0 0 1\nvt 0 0\nv 0 1 0\nv 0 0 1\ng g\nusemtl m\n"
        "f 1/1/1 3/1/1 2/1/1\nf 1//1 2//1 4//1 # side\nf -3/1 -2/1 -1/1\nf 3 1 4\n");
    EXPECT_TRUE(is_closed_manifold(mesh));
    EXPECT_NEAR(enclosed_volume(mesh), 1.0 / 6.0, 1e-15);
}

TEST(MeshReader, reads_ply_text_with_other_elements_and_properties)
{
    const TriangleMesh mesh =
        read("a.ply", "ply\r\nformat ascii 1.0\r\ncomment c\r\nelement vertex 4\r\nproperty uchar "
                      "red\r\nproperty double x\r\n"
                      "property double y\r\nproperty float z\r\nelement edge 1\r\nproperty int vertex1\r\n"
                      "property list uchar int extras\r\nelement face 1\r\nproperty uchar flag\r\n"
                      "property list uchar uint vertex_index\r\nend_header\r\n"
                      "7 0.1 0 0\r\n7 1 0 0\r\n7 1 1 0\r\n7 0 1 0\r\n5 2 8 9\r\n1 4 0 1 2 3\r\n");
    ASSERT_EQ(mesh.faces.size(), 2U);
    EXPECT_EQ(mesh.vertices[0].x, 0.1); // all 64 bits
}

//! The bytes of a number in the given order.
template <typename Number>
std::string bytes_of(Number number, bool big_endian)
{
    auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if (big_endian)
        std::reverse(bytes.begin(), bytes.end());
    return {bytes.begin(), bytes.end()};
}

TEST(MeshReader, reads_binary_ply_of_either_byte_order_with_64_bit_coordinates)
{
    for (const bool big_endian : {false, true})
    {
        std::string content =
            std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
            "_endian 1.0\nelement vertex 3\nproperty float64 x\nproperty float64 y\n"
            "property float64 z\nelement face 1\nproperty list int16 uint32 vertex_indices\nend_header\n";
        for (const double x : {0.1, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, -1e-300})
            content += bytes_of(x, big_endian);
        content += bytes_of(std::int16_t{3}, big_endian);
        for (const std::uint32_t v : {2U, 0U, 1U})
            content += bytes_of(v, big_endian);
        const TriangleMesh mesh = read("a.ply", content);
        ASSERT_EQ(mesh.vertices.size(), 3U);
        EXPECT_EQ(mesh.vertices[0].x, 0.1);
        EXPECT_EQ(mesh.vertices[2].z, -1e-300);
        EXPECT_EQ(mesh.faces[0], (TriangleMesh::Face{2, 0, 1}));
    }
}

TEST(MeshReader, keeps_the_faces_of_a_mesh_that_is_not_manifold)
{
    // Two tetrahedra that share an edge, one face twice, one face degenerate: ten faces, whatever the format.
    TriangleMesh mesh = sample::tetrahedron();
    mesh.vertices.insert(mesh.vertices.end(), {{0, -1, 0}, {0, 0, -1}});
    mesh.faces.insert(mesh.faces.end(), {{0, 4, 1}, {0, 1, 5}, {1, 4, 5}, {4, 0, 5}, {0, 2, 1}, {3, 3, 1}});
    const MeshTopology expected = analyze_topology(mesh);

    const TemporaryFolder folder;
    for (const char* name : {"a.stl", "a.ply", "a.obj", "a.off", "a.vtp"})
    {
        write_mesh(mesh, folder.path() / name, mesh_format(name));
        const TriangleMesh read = read_mesh(folder.path() / name);
        EXPECT_EQ(read.faces.size(), 10U) << name;
        EXPECT_EQ(analyze_topology(read).non_manifold_edges, expected.non_manifold_edges) << name;
        EXPECT_EQ(analyze_topology(read).degenerate_faces, 1U) << name;
    }
}

TEST(MeshReader, the_extension_counts_in_any_case)
{
    const TemporaryFolder folder;
    write_mesh(sample::tetrahedron(), folder.path() / "A.STL", MeshFormat::kStlBinary);
    EXPECT_TRUE(is_closed_manifold(read_mesh(folder.path() / "A.STL")));
}

// ---- What cannot be read ----

TEST(MeshReader, a_file_that_is_not_there_or_not_a_mesh_is_refused_with_the_reason)
{
    const TemporaryFolder folder;
    EXPECT_THROW(read_mesh(folder.path() / "missing.stl"), InputError);
    EXPECT_THROW(read_mesh(folder.path()), InputError);
    EXPECT_TRUE(contains(refusal("a.xyz", "data"), "known: .stl, .ply, .obj, .off, .vtp"));
    for (const char* name : {"a.stl", "a.ply", "a.obj", "a.off", "a.vtp"})
    {
        EXPECT_TRUE(contains(refusal(name, ""), "is empty")) << name;
        EXPECT_NE(refusal(name, "hello"), "") << name;
        EXPECT_NE(refusal(name, std::string(1000, '\0')), "") << name;
        EXPECT_NE(refusal(name, std::string(1000, '\xff')), "") << name;
        EXPECT_TRUE(contains(refusal(name, "hello"), name)) << name;
        EXPECT_FALSE(contains(refusal(name, "hello\n"), "\n")) << name;
    }
}

TEST(MeshReader, defects_are_named_with_their_line)
{
    EXPECT_TRUE(
        contains(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n"), "line 5 does not hold"));
    EXPECT_TRUE(
        contains(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), "vertices from 0 to 2"));
    EXPECT_TRUE(contains(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n"), "where a face is expected"));
    EXPECT_TRUE(contains(refusal("a.off", "OFF\n99999999999 1 0\n0 0 0\n"), "more vertices or faces"));
    EXPECT_TRUE(contains(refusal("a.off", "OFF\n3 -1 0\n0 0 0\n"), "numbers of vertices and faces"));
    EXPECT_TRUE(
        contains(refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"), "line 4 names the vertex '4'"));
    EXPECT_TRUE(contains(refusal("a.obj", "v 0 0 0\nv 1 0\n"), "line 2"));
    EXPECT_TRUE(contains(refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n"), "fewer than three"));
    EXPECT_TRUE(contains(refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n"), "not a finite number"));
    EXPECT_TRUE(contains(refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\n"),
                         "type 'real'"));
    EXPECT_TRUE(contains(refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex 99999999\n"),
                         "than the file can hold"));
}

//! Every format with a small mesh, as bytes.
std::string sample_file(const std::string& name, const std::string& format)
{
    const TemporaryFolder folder;
    write_mesh(sample::icosphere(1), folder.path() / name, mesh_format(name, format));
    return content_of(folder.path() / name);
}

TEST(MeshReader, truncated_files_are_refused)
{
    for (const auto& [name, format] : {std::pair{"a.stl", "stl"},
                                       {"a.stl", "stl-ascii"},
                                       {"a.ply", "ply"},
                                       {"a.off", "off"},
                                       {"a.vtp", "vtp"}})
    {
        const std::string content = sample_file(name, format);
        for (const std::size_t percent : {1, 5, 20, 50, 80, 99})
            EXPECT_NE(refusal(name, content.substr(0, content.size() * percent / 100)), "")
                << format << percent;
    }
}

TEST(MeshReader, a_binary_stl_that_begins_with_solid_or_goes_on_behind_its_end_is_read)
{
    std::string content = sample_file("a.stl", "stl");
    content.replace(0, 5, "solid");
    EXPECT_TRUE(is_closed_manifold(read("a.stl", content)));
    content.replace(0, 5, "other");
    EXPECT_TRUE(is_closed_manifold(read("a.stl", content + std::string(120, 'x'))));
}

TEST(MeshReader, a_binary_stl_of_no_faces_is_told_so)
{
    EXPECT_TRUE(contains(refusal("a.stl", std::string(84, '\0')), "it holds no faces"));
}

TEST(MeshReader, a_text_stl_in_capitals_or_after_empty_lines_is_read)
{
    const std::string content = sample_file("a.stl", "stl-ascii");
    ASSERT_EQ(content.substr(0, 5), "solid");
    EXPECT_TRUE(is_closed_manifold(read("a.stl", "SOLID" + content.substr(5))));
    EXPECT_TRUE(is_closed_manifold(read("a.stl", "  " + content)));
    EXPECT_TRUE(is_closed_manifold(read("a.stl", "\r\n\n" + content)));
}

TEST(MeshReader, damaged_files_are_read_or_refused_in_silence)
{
    Random random(3);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    for (const auto& [name, format] : {std::pair{"a.stl", "stl"},
                                       {"a.stl", "stl-ascii"},
                                       {"a.ply", "ply"},
                                       {"a.obj", "obj"},
                                       {"a.off", "off"},
                                       {"a.vtp", "vtp"}})
    {
        const std::string intact = sample_file(name, format);
        for (int trial = 0; trial < 60; ++trial)
        {
            std::string content = intact;
            for (int i = 0; i < 5; ++i)
            {
                // Half of the damage in the header, where the counts are.
                const auto place = random.below(i % 2 == 0 ? 200 : content.size());
                content[place] = static_cast<char>(random.below(256));
            }
            refusal(name, content); // anything but InputError fails the test
        }
    }
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

} // namespace
} // namespace voroprobe
