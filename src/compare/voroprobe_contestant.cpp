#include "compare/contestant.h"
#include "mesher/seeded_mesher.h"
#include "oracles/trilinear_oracle.h"

namespace voroprobe
{

namespace
{

//! What `voroprobe mesh` does to a volume on one thread: the inventory is part of the time.
class Voroprobe final : public Contestant
{
public:
    explicit Voroprobe(const MeshingTask& task) : task_(task) {}

    void mesh(StageClock& clock) override
    {
        clock.begin("inventory");
        const LevelledVolume levelled = level_volume(task_.volume, task_.isovalue, task_.inside);
        const auto inventory = std::make_shared<const Inventory>(*make_height_field(levelled), 1);
        const auto oracle = make_trilinear_oracle(levelled, inventory);
        clock.begin("refinement");
        mesh_ = mesh_surface(*oracle, {.max_facet_radius = task_.max_facet_radius,
                                       .max_facet_distance = task_.max_facet_distance,
                                       .min_facet_angle_deg = task_.min_facet_angle_deg,
                                       .floor_radius = task_.floor_radius,
                                       .reach_lower_bound = task_.reach})
                    .mesh;
    }

    [[nodiscard]] TriangleMesh result() const override { return mesh_; }

private:
    MeshingTask task_;
    TriangleMesh mesh_;
};

} // namespace

std::unique_ptr<Contestant> make_voroprobe(const MeshingTask& task)
{
    return std::make_unique<Voroprobe>(task);
}

} // namespace voroprobe
