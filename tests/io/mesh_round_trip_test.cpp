#include <cstdio>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>

#include "../mesh/sample_meshes.h"
#include "io/mesh_reader.h"
#include "io/mesh_writer.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "temporary_folder.h"

namespace voroprobe
{
namespace
{

using sample::append;
using sample::icosphere;
using sample::torus;

//! Half a unit in the last place of a 32-bit float, relative.
constexpr double kFloatRounding = 0x1.0p-24;

struct NamedFormat
{
    std::string name;
    std::string extension;
    MeshFormat format;
    double step = 0.0; //!< of fixed-point numbers
};

class MeshRoundTrip : public testing::TestWithParam<NamedFormat>
{
protected:
    TriangleMesh write_and_read(const TriangleMesh& mesh, const std::vector<std::string>& comments = {}) const
    {
        const auto path = folder_.path() / ("mesh" + GetParam().extension);
        write_mesh(mesh, path, GetParam().format, comments);
        return read_mesh(path);
    }

    TemporaryFolder folder_;
};

//! Corner by corner, as far as 32-bit floats (and one nudge) allow.
void expect_same_surface(const TriangleMesh& actual, const TriangleMesh& expected, double step)
{
    ASSERT_EQ(actual.vertices.size(), expected.vertices.size());
    ASSERT_EQ(actual.faces.size(), expected.faces.size());
    const Box3 box = bounding_box(expected);
    const double tolerance = 4.0 * kFloatRounding * std::max(norm(box.min), norm(box.max)) + step;
    for (std::size_t f = 0; f < expected.faces.size(); ++f)
        for (std::size_t i = 0; i < 3; ++i)
            ASSERT_LT(distance(actual.corner(actual.faces[f], i), expected.corner(expected.faces[f], i)),
                      tolerance);
}

TEST_P(MeshRoundTrip, a_mesh_of_several_pieces_keeps_its_topology)
{
    TriangleMesh mesh = icosphere(3, 10.0);
    append(mesh, torus(40, 30), {100.5, -30.25, 7.0});
    append(mesh, icosphere(2, 0.01), {-77.7, 33.3, 11.1});

    const TriangleMesh read = write_and_read(mesh);
    EXPECT_TRUE(is_closed_manifold(read));
    EXPECT_EQ(count_components(read), 3U);
    EXPECT_EQ(euler_characteristic(read), 4);
    EXPECT_NEAR(enclosed_volume(read), enclosed_volume(mesh), 1e-5 * enclosed_volume(mesh));
    expect_same_surface(read, mesh, GetParam().step);
}

TEST_P(MeshRoundTrip, a_hundred_thousand_faces_keep_their_topology)
{
    const TriangleMesh mesh = torus(250, 200);
    const TriangleMesh read = write_and_read(mesh);
    EXPECT_TRUE(is_closed_manifold(read));
    EXPECT_EQ(euler_characteristic(read), 0);
    expect_same_surface(read, mesh, GetParam().step);
}

TEST_P(MeshRoundTrip, comments_do_not_disturb_the_reader)
{
    const TriangleMesh mesh = icosphere(1);
    const std::vector<std::string> comments{"solid made by hand", "two\nlines", std::string(300, 'x'),
                                            "units: mm"};
    expect_same_surface(write_and_read(mesh, comments), mesh, GetParam().step);
}

TEST_P(MeshRoundTrip, vertices_a_hair_apart_stay_apart)
{
    // Two spheres that touch but for 1e-9: after rounding alone the two poles would be one vertex.
    TriangleMesh mesh = icosphere(2, 10.0);
    append(mesh, mesh, {0, 0, 20.0 + 1e-9});

    const TriangleMesh read = write_and_read(mesh);
    EXPECT_TRUE(is_closed_manifold(read));
    EXPECT_EQ(count_components(read), 2U);
    expect_same_surface(read, mesh, GetParam().step);
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshRoundTrip,
                         testing::Values(NamedFormat{"stl", ".stl", MeshFormat::kStlBinary},
                                         NamedFormat{"stl_ascii", ".stl", MeshFormat::kStlAscii},
                                         NamedFormat{"ply", ".ply", MeshFormat::kPly},
                                         NamedFormat{"obj", ".obj", MeshFormat::kObj},
                                         NamedFormat{"off", ".off", MeshFormat::kOff},
                                         NamedFormat{"vtp", ".vtp", MeshFormat::kVtp},
                                         NamedFormat{"3mf", ".3mf", MeshFormat::k3mf, 0x1p-16}),
                         [](const auto& instance) { return instance.param.name; });

} // namespace
} // namespace voroprobe
