// OpenVDB's volumeToMesh: dual contouring of a grid.
#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>
#include <openvdb/tools/VolumeToMesh.h>

#include "compare/contestant.h"
#include "compare/peer_field.h"

namespace voroprobe
{

namespace
{

//! Without it OpenVDB gives quads alone; with it triangles too, merged where the surface is flat.
constexpr double kNoAdaptivity = 0.0;

class OpenVdb final : public Contestant
{
public:
    explicit OpenVdb(const MeshingTask& task) : field_(padded(make_peer_field(task)))
    {
        openvdb::initialize();
        const auto& n = field_.size;
        const openvdb::CoordBBox box(0, 0, 0, static_cast<int>(n[0]) - 1, static_cast<int>(n[1]) - 1,
                                     static_cast<int>(n[2]) - 1);
        for (float& sample : field_.samples) // OpenVDB's inside is below
            sample = static_cast<float>(field_.isovalue - sample);
        const openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ> dense(box, field_.samples.data());
        grid_ = openvdb::FloatGrid::create(field_.samples.front()); // a sample of the padding: outside
        openvdb::tools::copyFromDense(dense, *grid_, 0.0F);
    }

    void mesh(StageClock& clock) override
    {
        clock.begin("volumeToMesh");
        openvdb::tools::volumeToMesh(*grid_, points_, triangles_, quads_, 0.0, kNoAdaptivity);
    }

    [[nodiscard]] TriangleMesh result() const override
    {
        TriangleMesh mesh;
        mesh.vertices.reserve(points_.size());
        for (const openvdb::Vec3s& p : points_)
            mesh.vertices.push_back(field_.origin + Vec3{field_.spacing.x * p.x(), field_.spacing.y * p.y(),
                                                         field_.spacing.z * p.z()});
        for (const openvdb::Vec3I& triangle : triangles_)
            mesh.faces.push_back({triangle[0], triangle[1], triangle[2]});
        for (const openvdb::Vec4I& quad : quads_)
            add_quad(quad, mesh);
        close_on_border(mesh, field_.border);
        wind_outward(mesh);
        return mesh;
    }

private:
    static void add_quad(const openvdb::Vec4I& q, TriangleMesh& mesh)
    {
        const auto length = [&](int a, int b)
        { return squared_distance(mesh.vertices[q[a]], mesh.vertices[q[b]]); };
        if (length(0, 2) <= length(1, 3))
        {
            mesh.faces.push_back({q[0], q[1], q[2]});
            mesh.faces.push_back({q[0], q[2], q[3]});
        }
        else
        {
            mesh.faces.push_back({q[0], q[1], q[3]});
            mesh.faces.push_back({q[1], q[2], q[3]});
        }
    }

    PeerField field_;
    openvdb::FloatGrid::Ptr grid_;
    std::vector<openvdb::Vec3s> points_;
    std::vector<openvdb::Vec3I> triangles_;
    std::vector<openvdb::Vec4I> quads_;
};

} // namespace

std::unique_ptr<Contestant> make_openvdb(const MeshingTask& task)
{
    return std::make_unique<OpenVdb>(task);
}

} // namespace voroprobe
