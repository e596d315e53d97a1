#include "compare/view_mesh.h"

#include <algorithm>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"
#include "compared_phantom.h"
#include "mesh/topology.h"

namespace voroprobe
{

namespace
{

TEST(ViewMesh, base64_is_that_of_rfc_4648)
{
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xFF\xFE"), "//4=");
}

class ViewOfSpheres : public testing::Test
{
protected:
    ViewOfSpheres()
    {
        sample::append(mesh_, sample::icosphere(4, 8.0), {12, 12, 12});
        sample::append(mesh_, sample::icosphere(2, 2.0), {28, 12, 12});
    }

    ComparedPhantom phantom_ = compared_phantom(
        union_of({sphere_phantom({12, 12, 12}, 8.0), sphere_phantom({28, 12, 12}, 2.5)}), {33, 25, 25});
    TriangleMesh mesh_;
};

TEST_F(ViewOfSpheres, a_small_mesh_is_shown_as_it_is)
{
    const ViewMesh view = make_view_mesh(mesh_, phantom_.reference, 10000);
    EXPECT_FALSE(view.decimated());
    EXPECT_EQ(view.mesh.faces, mesh_.faces);
    for (std::size_t face = 0; face < mesh_.faces.size(); ++face)
    {
        const bool second = view.pieces[face] == 1;
        EXPECT_NEAR(view.distances[face], second ? 0.5 : 0.0, 0.25);
        EXPECT_GT(view.smallest_angles_deg[face], 45.0);
    }
}

TEST_F(ViewOfSpheres, a_large_mesh_is_decimated_and_its_small_pieces_are_kept)
{
    const ViewMesh view = make_view_mesh(mesh_, phantom_.reference, 1500);
    EXPECT_TRUE(view.decimated());
    EXPECT_LE(view.mesh.faces.size(), 1700U);
    EXPECT_EQ(view.faces_of_whole, mesh_.faces.size());
    EXPECT_EQ(std::count(view.pieces.begin(), view.pieces.end(), 1U), 20 * 16);
    EXPECT_EQ(count_components(view.mesh), 2U);
    const auto before = [](const Point3& a, const Point3& b)
    { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
    const std::set<Point3, decltype(before)> places(mesh_.vertices.begin(), mesh_.vertices.end(), before);
    EXPECT_TRUE(std::all_of(view.mesh.vertices.begin(), view.mesh.vertices.end(),
                            [&](const Point3& p) { return places.contains(p); })); // none was moved
}

TEST_F(ViewOfSpheres, the_same_mesh_is_packed_into_the_same_bytes)
{
    const ViewMesh view = make_view_mesh(mesh_, phantom_.reference, 10000);
    EXPECT_EQ(pack(view, 1.0), pack(view, 1.0));
    EXPECT_LT(pack(view, 1.0).size(), 20 * mesh_.faces.size());
}

} // namespace

} // namespace voroprobe
