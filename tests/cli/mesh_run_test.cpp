#include "cli/mesh_run.h"

#include <gtest/gtest.h>

#include "support/error.h"

namespace voroprobe
{
namespace
{

TriangleMesh tetrahedron()
{
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

TriangleMesh without_last_face(TriangleMesh mesh)
{
    mesh.faces.pop_back();
    return mesh;
}

TriangleMesh inside_out(TriangleMesh mesh)
{
    for (auto& face : mesh.faces)
        std::swap(face[0], face[1]);
    return mesh;
}

MeshRun run_with(const TriangleMesh& mesh, RunStatus status = RunStatus::kDone)
{
    MeshRun run{.arguments = {},
                .input = {},
                .options = {},
                .statistics = {},
                .facts = {},
                .output_box = {},
                .timings = {}};
    run.facts = measure_mesh(mesh, 30.0);
    run.status = status;
    return run;
}

ExitStatus status_thrown_by(const MeshRun& run)
{
    try
    {
        check_promises(run);
    }
    catch (const Error& error)
    {
        return error.status();
    }
    return ExitStatus::kDone;
}

TEST(BrokenPromise, a_closed_mesh_keeps_them_all)
{
    EXPECT_EQ(broken_promise(measure_mesh(tetrahedron(), 30.0), BorderFaces::kClosed), std::nullopt);
}

TEST(BrokenPromise, a_hole_is_one_unless_the_border_was_to_stay_open)
{
    const MeshFacts open = measure_mesh(without_last_face(tetrahedron()), 30.0);
    EXPECT_EQ(broken_promise(open, BorderFaces::kClosed), "3 edges on one face only");
    EXPECT_EQ(broken_promise(open, BorderFaces::kOpen), std::nullopt);
}

TEST(BrokenPromise, faces_that_wind_inward_are_one)
{
    EXPECT_EQ(broken_promise(measure_mesh(inside_out(tetrahedron()), 30.0), BorderFaces::kClosed),
              "faces that wind inward");
}

TEST(BrokenPromise, two_vertices_at_one_place_are_one)
{
    TriangleMesh twins = tetrahedron();
    for (const auto& face : tetrahedron().faces)
        twins.faces.push_back({face[0] + 4, face[1] + 4, face[2] + 4});
    for (const Point3& p : tetrahedron().vertices)
        twins.vertices.push_back(p + Vec3{1, 0, 0}); // one corner meets a corner of the first
    EXPECT_EQ(broken_promise(measure_mesh(twins, 30.0), BorderFaces::kClosed),
              "1 vertices at the place of another");
}

TEST(BrokenPromise, ends_in_exit_status_incomplete)
{
    EXPECT_EQ(status_thrown_by(run_with(tetrahedron())), ExitStatus::kDone);
    EXPECT_EQ(status_thrown_by(run_with(without_last_face(tetrahedron()))), ExitStatus::kIncomplete);
    EXPECT_EQ(status_thrown_by(run_with(tetrahedron(), RunStatus::kPartial)), ExitStatus::kBudget);
}

} // namespace
} // namespace voroprobe
