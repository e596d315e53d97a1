#include "compare/label_contestant.h"

#include <map>
#include <utility>

#include "compare/contestant_list.h"
#include "compare/label_frame.h"
#include "compare/mask_cubes.h"
#include "labels/label_meshing.h"
#include "mesh/topology.h"

namespace voroprobe
{

namespace
{

class VoroprobeLabels final : public LabelContestant
{
public:
    explicit VoroprobeLabels(const LabelTask& task) : task_(task) {}

    void mesh(StageClock& clock) override
    {
        clock.begin("smoothing and refinement");
        constexpr std::size_t kOneThread = 1;
        mesh_labels(*task_.survey, task_.labels, task_.spacing, task_.options, kOneThread, nullptr,
                    [this](LabelMesh label) { mesh_of_label_[label.label] = std::move(label.mesh); });
    }

    [[nodiscard]] std::vector<TriangleMesh> take_result() override
    {
        std::vector<TriangleMesh> meshes;
        for (const std::uint32_t label : task_.labels)
            meshes.push_back(weld(mesh_of_label_[label]));
        return meshes;
    }

private:
    LabelTask task_;
    std::map<std::uint32_t, TriangleMesh> mesh_of_label_;
};

//! VTK, label by label.
class UsualWay final : public LabelContestant
{
public:
    UsualWay(const LabelTask& task, CubesFinish finish) : task_(task), finish_(finish) {}

    void mesh(StageClock& clock) override
    {
        clock.begin("all steps");
        for (const std::uint32_t label : task_.labels)
        {
            const PartMask mask = mask_of_label(task_, label);
            meshes_.push_back(cubes_of_mask(mask, task_.spacing, finish_));
            transform(meshes_.back(), grid_from_mask(task_, mask));
        }
    }

    [[nodiscard]] std::vector<TriangleMesh> take_result() override { return std::move(meshes_); }

private:
    LabelTask task_;
    CubesFinish finish_;
    std::vector<TriangleMesh> meshes_;
};

std::function<std::unique_ptr<LabelContestant>(const LabelTask&)> usual_way(CubesFinish finish)
{
    return [finish](const LabelTask& task) { return std::make_unique<UsualWay>(task, finish); };
}

} // namespace

std::vector<LabelContestantEntry> all_label_contestants()
{
    return {
        {kOurs, "Voroprobe",
         "What voroprobe mesh --labels makes: each label smoothed without losing a part, refined, and given "
         "the "
         "volume "
         "of its voxels.",
         [](const LabelTask& task) { return std::make_unique<VoroprobeLabels>(task); }},
        {kReference, "Marching cubes",
         "VTK's discrete marching cubes on the mask of each label: the staircase of the voxels.",
         usual_way(CubesFinish::kRough)},
        {"smoothed", "Marching cubes, smoothed",
         "The same, then VTK's windowed-sinc smoothing (20 rounds, pass band 0.1).",
         usual_way(CubesFinish::kSmoothed)},
        {"decimated", "Marching cubes, smoothed, decimated",
         "The same, then VTK's quadric decimation to a quarter: what nii2mesh and 3D Slicer make of a label.",
         usual_way(CubesFinish::kDecimated)},
    };
}

} // namespace voroprobe
