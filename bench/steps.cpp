#include "bench/steps.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "certificate/certificate.h"
#include "mesher/seeded_mesher.h"

namespace voroprobe::bench
{

namespace
{

MeshingResult our_mesh(const MeshingTask& task, const ReferenceSurface& reference)
{
    return mesh_surface(*reference.oracle, {.max_facet_radius = task.max_facet_radius,
                                            .max_facet_distance = task.max_facet_distance,
                                            .min_facet_angle_deg = task.min_facet_angle_deg,
                                            .floor_radius = task.floor_radius,
                                            .reach_lower_bound = task.reach});
}

class InventoryStep final : public Contestant
{
public:
    explicit InventoryStep(const MeshingTask& task) : task_(task) {}

    void mesh(StageClock& clock) override
    {
        clock.begin("inventory");
        const LevelledVolume levelled = level_volume(task_.volume, task_.isovalue, task_.inside);
        inventory_ = std::make_unique<const Inventory>(*make_height_field(levelled), task_.threads);
    }

    [[nodiscard]] TriangleMesh result() const override { return {}; }

private:
    MeshingTask task_;
    std::unique_ptr<const Inventory> inventory_;
};

class CertificateStep final : public Contestant
{
public:
    CertificateStep(const MeshingTask& task, const ReferenceSurface& reference)
        : task_(task), reference_(reference), ours_(our_mesh(task, reference))
    {
    }

    void mesh(StageClock& clock) override
    {
        clock.begin("certificate");
        certificate_ = certify(ours_.mesh, *reference_.oracle, reference_.inventory->surfaces(),
                               {.reach = reference_.voxel,
                                .floor_radius = task_.floor_radius,
                                .criteria = {.min_angle_deg = task_.min_facet_angle_deg,
                                             .max_radius = task_.max_facet_radius,
                                             .max_center_distance = task_.max_facet_distance},
                                .test_self_intersections = false},
                               ours_.surface_of_face);
    }

    [[nodiscard]] TriangleMesh result() const override { return ours_.mesh; }

private:
    MeshingTask task_;
    const ReferenceSurface& reference_;
    MeshingResult ours_;
    Certificate certificate_;
};

class BulkInsertion final : public Contestant
{
public:
    BulkInsertion(const MeshingTask& task, const ReferenceSurface& reference)
        : mesh_(our_mesh(task, reference).mesh)
    {
        for (const Point3& p : mesh_.vertices)
            points_.emplace_back(p.x, p.y, p.z);
    }

    void mesh(StageClock& clock) override
    {
        clock.begin("insertion");
        triangulation_.insert(points_.begin(), points_.end()); // sorts them along a space-filling curve
    }

    [[nodiscard]] TriangleMesh result() const override { return mesh_; }

private:
    using Triangulation = CGAL::Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel>;

    TriangleMesh mesh_;
    std::vector<Triangulation::Point> points_;
    Triangulation triangulation_;
};

} // namespace

std::unique_ptr<Contestant> make_inventory(const MeshingTask& task)
{
    return std::make_unique<InventoryStep>(task);
}

std::unique_ptr<Contestant> make_certificate(const MeshingTask& task, const ReferenceSurface& reference)
{
    return std::make_unique<CertificateStep>(task, reference);
}

std::unique_ptr<Contestant> make_bulk_insertion(const MeshingTask& task, const ReferenceSurface& reference)
{
    return std::make_unique<BulkInsertion>(task, reference);
}

} // namespace voroprobe::bench
