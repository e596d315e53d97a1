#include "compare/contestant.h"
#include "mesher/seeded_mesher.h"
#include "oracles/trilinear_oracle.h"

namespace voroprobe
{

namespace
{

//! What `voroprobe mesh` does to a volume: the inventory is part of the time. Or its refinement
//! alone.
class Voroprobe final : public Contestant
{
public:
    Voroprobe(const MeshingTask& task, bool whole) : task_(task), whole_(whole) {}

    void mesh(StageClock& clock) override
    {
        std::shared_ptr<const Inventory> inventory;
        if (whole_)
            clock.begin("inventory");
        const LevelledVolume levelled = level_volume(task_.volume, task_.isovalue, task_.inside);
        if (whole_)
            inventory = std::make_shared<const Inventory>(*make_height_field(levelled), task_.threads);
        const auto oracle = make_trilinear_oracle(levelled, inventory);
        clock.begin("refinement");
        mesh_ = mesh_surface(*oracle, {.max_facet_radius = task_.max_facet_radius,
                                       .max_facet_distance = task_.max_facet_distance,
                                       .min_facet_angle_deg = task_.min_facet_angle_deg,
                                       .floor_radius = task_.floor_radius,
                                       .reach_lower_bound = task_.reach,
                                       .seeding = whole_ ? Seeding::kInventory : Seeding::kIsolated,
                                       .threads = task_.threads})
                    .mesh;
    }

    [[nodiscard]] TriangleMesh result() const override { return mesh_; }

private:
    MeshingTask task_;
    bool whole_;
    TriangleMesh mesh_;
};

} // namespace

std::unique_ptr<Contestant> make_voroprobe(const MeshingTask& task)
{
    return std::make_unique<Voroprobe>(task, true);
}

std::unique_ptr<Contestant> make_voroprobe_refinement(const MeshingTask& task)
{
    return std::make_unique<Voroprobe>(task, false);
}

} // namespace voroprobe
