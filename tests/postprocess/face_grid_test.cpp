#include <algorithm>
#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"
#include "postprocess/face_grid.h"
#include "support/random.h"

namespace voroprobe
{
namespace
{

Box3 box_of(const EditableMesh& mesh, std::uint32_t face)
{
    Box3 box;
    for (const std::uint32_t v : mesh.face(face))
        box.include(mesh.point(v));
    return box;
}

//! Of all faces, one by one.
std::vector<std::uint32_t> faces_in(const EditableMesh& mesh, const Box3& box)
{
    std::vector<std::uint32_t> result;
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f)
    {
        const Box3 of_face = box_of(mesh, f);
        bool overlaps = mesh.is_alive(f);
        for (std::size_t axis = 0; axis < 3; ++axis)
            overlaps = overlaps && of_face.max[axis] >= box.min[axis] && of_face.min[axis] <= box.max[axis];
        if (overlaps)
            result.push_back(f);
    }
    return result;
}

class FaceGridSize : public testing::TestWithParam<double>
{
};

TEST_P(FaceGridSize, finds_what_a_look_at_every_face_finds)
{
    EditableMesh mesh(sample::icosphere(3, 10.0));
    FaceGrid grid(mesh, GetParam());
    Random random(5);
    for (int i = 0; i < 50; ++i)
    {
        Box3 box;
        for (int corner = 0; corner < 2; ++corner)
            box.include({random.uniform(-11, 11), random.uniform(-11, 11), random.uniform(-11, 11)});
        ASSERT_EQ(grid.faces_near(box), faces_in(mesh, box));
        const std::uint32_t moved = mesh.face(static_cast<std::uint32_t>(mesh.face_count()) - 1)[0];
        const std::vector<std::uint32_t> star = mesh.faces_of(moved);
        std::vector<TriangleMesh::Face> same;
        for (const std::uint32_t f : star)
            same.push_back(mesh.face(f));
        mesh.move(moved, 1.05 * mesh.point(moved));
        mesh.replace(star, same);
        grid.update();
    }
}

INSTANTIATE_TEST_SUITE_P(CellSizes, FaceGridSize, testing::Values(0.02, 1.0, 100.0));

} // namespace
} // namespace voroprobe
