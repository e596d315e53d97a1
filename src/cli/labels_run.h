#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/file_lattice.h"
#include "cli/mesh_arguments.h"
#include "cli/mesh_run.h"
#include "cli/output_frame.h"
#include "io/label_table.h"
#include "io/nrrd_segments.h"
#include "labels/group_meshing.h"
#include "labels/label_meshing.h"
#include "labels/label_survey.h"

namespace voroprobe
{

//! One of the labels asked for: what is known before it is meshed, and what became of it.
struct LabelOutcome
{
    std::size_t layer = 0;
    LabelValue value;
    std::string name; //!< "label_7" where nobody named it
    std::optional<Color> color = std::nullopt;
    std::size_t voxels = 0;
    std::size_t parts_expected = 0;
    std::filesystem::path path;
    bool done = false;

    LabelMesh mesh = {}; //!< without the mesh itself once that is written
    std::size_t vertices = 0;
    std::size_t faces = 0;
};

//! A label map as it was read.
struct LabelMap
{
    std::vector<LabelSurvey> layers; //!< one but for segments that overlap; their numbers are their own
    std::vector<Segment> segments;   //!< what the file tells of them
    Vec3 spacing;                    //!< grid frame, mm
    GridPlacement placement;
    FileLattice lattice;
    std::string format;
    std::string stored_type;
    bool looks_like_scan = false;
    std::vector<std::string> warnings;

    [[nodiscard]] std::size_t label_count() const;
    [[nodiscard]] std::size_t part_count() const;
};

//! Everything the report and the summary tell of one run of `voroprobe mesh --labels`.
struct LabelsRun
{
    MeshArguments arguments;
    LabelMap map;
    LabelMeshingOptions options;
    std::size_t threads;              //!< that were used
    std::vector<LabelOutcome> labels; //!< by layer and ascending value
    RunTimings timings;

    [[nodiscard]] bool complete() const;
};

//! \throw Error (kIncomplete) that names the labels with parts that are missing or in pieces, or meshes that
//! are not as promised.
void check_promises(const LabelsRun& run);

} // namespace voroprobe
