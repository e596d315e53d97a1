#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "compare/stage_clock.h"
#include "geometry/affine_transform.h"
#include "labels/group_meshing.h"
#include "labels/label_survey.h"
#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! What every contestant of a label map is asked to do: a mesh of each of these labels.
struct LabelTask
{
    std::shared_ptr<const LabelSurvey> survey;
    std::vector<std::uint32_t> labels; //!< places in LabelSurvey::labels()
    Vec3 spacing;                      //!< grid frame, scan units
    AffineTransform world_from_grid;   //!< places are told in the world, LPS, mm
    double voxel;                      //!< side of the cube of a voxel's volume, mm: the unit of distances
    LabelMeshingOptions options;       //!< ours only
};

//! A mesher of label maps. Only mesh() is on the clock.
class LabelContestant
{
public:
    virtual ~LabelContestant() = default;

    virtual void mesh(StageClock& clock) = 0;

    //! A mesh for each label of the task, in its order, grid frame; empty where nothing is left of it. Equal
    //! points of a mesh are one vertex. May be called once.
    [[nodiscard]] virtual std::vector<TriangleMesh> take_result() = 0;
};

struct LabelContestantEntry
{
    std::string name; //!< those of ContestantEntry where it is the same mesher
    std::string title;
    std::string description;
    std::function<std::unique_ptr<LabelContestant>(const LabelTask&)> make;
};

//! Ours, and the usual way step by step: discrete marching cubes, smoothed, decimated.
std::vector<LabelContestantEntry> all_label_contestants();

} // namespace voroprobe
