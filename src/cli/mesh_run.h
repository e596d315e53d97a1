#pragma once

#include <optional>
#include <string>

#include "certificate/certificate.h"
#include "cli/mesh_arguments.h"
#include "cli/mesh_facts.h"
#include "cli/process_steps.h"
#include "cli/surface_input.h"
#include "mesher/seeded_mesher.h"

namespace voroprobe
{

//! How a run that wrote a mesh ended.
enum class RunStatus
{
    kDone,
    kPartial,   //!< the budget of vertices was spent
    kIncomplete //!< the mesh is not what was promised
};

//! Wall clock, seconds.
struct RunTimings
{
    double read = 0.0; //!< input, statistics and oracle
    double refinement = 0.0;
    double certificate = 0.0;
    double write = 0.0; //!< checks and output
    double total = 0.0;
};

//! Everything the report and the summary tell of one run of `voroprobe mesh`.
struct MeshRun
{
    MeshArguments arguments;
    SurfaceInput input;
    MeshingOptions options;
    MeshingStatistics statistics;
    MeshFacts facts;
    std::optional<Certificate> certificate = std::nullopt; //!< where the surfaces of the input can be listed
    std::vector<StepReport> steps = {};                    //!< on the shape, after refinement
    Box3 output_box;                                       //!< in the frame of the output
    std::size_t vertices_on_border = 0;                    //!< where the domain of a formula cuts the object
    RunTimings timings;
    RunStatus status = RunStatus::kDone;
};

//! Where the boxes of the certificate are shown: in the frame of the output; in lps where that is counted in
//! voxels, so that they are in mm.
AffineTransform shown_from_grid(const MeshRun& run);

//! What is wrong with the topology of the mesh, in one line; nullopt where it is as promised.
std::optional<std::string> broken_promise(const MeshFacts& facts, BorderFaces border);

//! The budget that a partial result was held to: "--max-vertices 100".
std::string budget_text(const MeshRun& run);

//! Says whether the mesh that was written is what was asked for, all of it. \throw Error: kBudget where it is
//! partial, kIncomplete where a promise is broken.
void check_promises(const MeshRun& run);

} // namespace voroprobe
