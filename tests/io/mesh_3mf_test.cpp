#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <string>

#include "../mesh/sample_meshes.h"
#include "io/mesh_reader.h"
#include "io/mesh_writer.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "stored_zip.h"
#include "support/error.h"
#include "temporary_folder.h"

namespace voroprobe
{
namespace
{

namespace fs = std::filesystem;

using sample::icosphere;

constexpr const char* kTetrahedron =
    R"(<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/>)"
    R"(<vertex x="0" y="0" z="1"/></vertices><triangles><triangle v1="0" v2="2" v3="1"/>)"
    R"(<triangle v1="0" v2="1" v3="3"/><triangle v1="1" v2="2" v3="3"/><triangle v1="2" v2="0" v3="3"/>)"
    R"(</triangles></mesh>)";

class Mesh3mf : public testing::Test
{
protected:
    [[nodiscard]] fs::path path(const std::string& name = "mesh.3mf") const { return folder_.path() / name; }

    //! A package around the inside of <model>.
    void write_package(const std::string& unit, const std::string& model) const
    {
        StoredZip zip;
        zip.add(
            "[Content_Types].xml",
            R"(<?xml version="1.0" encoding="UTF-8"?><Types xmlns="http://schemas.openxmlformats.org/)"
            R"(package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxml)"
            R"(formats-package.relationships+xml"/><Default Extension="model" ContentType="application/)"
            R"(vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>)");
        zip.add(
            "_rels/.rels",
            R"(<?xml version="1.0" encoding="UTF-8"?><Relationships xmlns="http://schemas.openxmlformats.)"
            R"(org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" )"
            R"(Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)");
        zip.add("3D/3dmodel.model",
                R"(<?xml version="1.0" encoding="UTF-8"?><model unit=")" + unit +
                    R"(" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">)" + model +
                    "</model>");
        zip.write(path());
    }

    [[nodiscard]] std::string refusal() const
    {
        try
        {
            static_cast<void>(read_parts(path()));
        }
        catch (const InputError& error)
        {
            return error.what();
        }
        return "";
    }

    TemporaryFolder folder_;
};

std::string bytes_of(const fs::path& path)
{
    std::stringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    return bytes.str();
}

TEST_F(Mesh3mf, objects_keep_names_and_colours)
{
    const std::vector<MeshPart> parts{{.name = "Foie \xC3\xA9 <left> & \"right\"",
                                       .color = Color{200, 100, 50},
                                       .mesh = icosphere(2, 10.0)},
                                      {.name = "no colour", .mesh = icosphere(1, 5.0)},
                                      {.name = "", .color = Color{0, 0, 0}, .mesh = icosphere(1, 3.0)}};
    write_parts(parts, path());
    const std::vector<MeshPart> read = read_parts(path());
    ASSERT_EQ(read.size(), parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
        EXPECT_EQ(read[i].name, parts[i].name);
        EXPECT_EQ(read[i].color, parts[i].color);
        EXPECT_EQ(read[i].mesh.faces, parts[i].mesh.faces);
        EXPECT_NEAR(enclosed_volume(read[i].mesh), enclosed_volume(parts[i].mesh), 1e-3);
    }
}

TEST_F(Mesh3mf, a_single_mesh_has_no_name_and_comments_do_not_disturb)
{
    write_mesh(icosphere(1), path("skull.3mf"), MeshFormat::k3mf, {"frame: lps", "a < b & c"});
    const std::vector<MeshPart> read = read_parts(path("skull.3mf"));
    ASSERT_EQ(read.size(), 1U);
    EXPECT_EQ(read[0].name, "");
    EXPECT_TRUE(is_closed_manifold(read[0].mesh));
}

TEST_F(Mesh3mf, same_parts_give_the_same_bytes)
{
    const std::vector<MeshPart> parts{{.name = "a", .color = Color{1, 2, 3}, .mesh = icosphere(1)},
                                      {.name = "b", .mesh = icosphere(1)}};
    write_parts(parts, path("a.3mf"), {"one"});
    write_parts(parts, path("b.3mf"), {"one"});
    EXPECT_EQ(bytes_of(path("a.3mf")), bytes_of(path("b.3mf")));
}

TEST_F(Mesh3mf, an_object_on_one_face_of_another_keeps_its_own_vertices)
{
    TriangleMesh other = sample::tetrahedron();
    transform(other, {{{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, -1}}}, {}}); // shares the face z = 0
    write_parts(
        std::vector<MeshPart>{{.name = "a", .mesh = sample::tetrahedron()}, {.name = "b", .mesh = other}},
        path());
    const TriangleMesh both = read_mesh(path());
    EXPECT_EQ(both.vertices.size(), 8U);
    EXPECT_TRUE(is_closed_manifold(both));
}

TEST_F(Mesh3mf, neighbours_stay_apart_at_every_magnitude)
{
    // Vertices as near one another as the numbers allow, where lib3mf's own rounding is coarsest.
    for (const double size : {1e-3, 0.7, 3.9, 4.1, 7.9, 8.1, 33.0, 511.0, 4097.0, 65537.0})
    {
        TriangleMesh mesh = icosphere(2, 1e-6 * size);
        for (Point3& p : mesh.vertices)
            p += Vec3{size, -size, 0.3 * size};
        sample::append(mesh, icosphere(2, 0.1 * size));
        try
        {
            write_mesh(mesh, path(), MeshFormat::k3mf);
        }
        catch (const OutputError& error) // the speck is smaller than the numbers are apart
        {
            EXPECT_NE(std::string(error.what()).find("too fine"), std::string::npos) << error.what();
            continue;
        }
        const TriangleMesh read = read_mesh(path());
        EXPECT_EQ(read.vertices.size(), mesh.vertices.size()) << size;
        EXPECT_TRUE(is_closed_manifold(read)) << size;
    }
}

TEST_F(Mesh3mf, items_are_moved_and_units_become_millimetres)
{
    write_package("inch",
                  std::string(R"(<resources><object id="1" type="model">)") + kTetrahedron +
                      R"(</object></resources><build><item objectid="1" transform="1 0 0 0 1 0 0 0 1 )"
                      R"(10 20 30"/></build>)");
    const Box3 box = bounding_box(read_mesh(path()));
    EXPECT_NEAR(box.min.x, 254.0, 1e-4);
    EXPECT_NEAR(box.min.y, 508.0, 1e-4);
    EXPECT_NEAR(box.max.z, 31 * 25.4, 1e-4);
}

TEST_F(Mesh3mf, components_are_turned_and_moved_into_one_part)
{
    // The item turns x to y and y to -x: its rows are the images of the axes.
    write_package(
        "millimeter",
        std::string(R"(<resources><object id="1" type="model">)") + kTetrahedron +
            R"(</object><object id="2" type="model" name="pair"><components><component objectid="1"/>)"
            R"(<component objectid="1" transform="1 0 0 0 1 0 0 0 1 5 0 0"/></components></object>)"
            R"(</resources><build><item objectid="2" transform="0 1 0 -1 0 0 0 0 1 0 0 0"/></build>)");
    const std::vector<MeshPart> parts = read_parts(path());
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].name, "pair");
    EXPECT_EQ(count_components(parts[0].mesh), 2U);
    const Box3 box = bounding_box(parts[0].mesh);
    EXPECT_NEAR(box.max.y, 6.0, 1e-6);
    EXPECT_NEAR(box.min.x, -1.0, 1e-6);
    EXPECT_NEAR(enclosed_volume(parts[0].mesh), 2.0 / 6.0, 1e-6);
}

TEST_F(Mesh3mf, broken_packages_are_refused_with_a_reason)
{
    std::ofstream(path()) << "this is no archive";
    EXPECT_NE(refusal().find("lib3mf"), std::string::npos) << refusal();

    write_package("millimeter", "<resources/><build/>");
    EXPECT_NE(refusal().find("no object"), std::string::npos) << refusal();

    write_mesh(icosphere(3), path(), MeshFormat::k3mf);
    const std::string whole = bytes_of(path());
    for (const std::size_t share : {1U, 3U, 5U, 7U})
    {
        std::ofstream(path(), std::ios::binary) << whole.substr(0, share * whole.size() / 8);
        EXPECT_NE(refusal(), "") << share;
    }
}

TEST_F(Mesh3mf, a_face_that_names_a_vertex_beyond_the_last_is_refused)
{
    std::string mesh = kTetrahedron;
    mesh.replace(mesh.find("v1=\"2\""), 6, "v1=\"9\"");
    write_package("millimeter", R"(<resources><object id="1" type="model">)" + mesh +
                                    R"(</object></resources><build><item objectid="1"/></build>)");
    EXPECT_NE(refusal(), "");
}

} // namespace
} // namespace voroprobe
