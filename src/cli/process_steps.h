#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/process_arguments.h"
#include "mesh/measures.h"
#include "mesh/mesh_part.h"
#include "mesh/topology.h"
#include "postprocess/bounding_surface.h"
#include "postprocess/deviation.h"

namespace voroprobe
{

//! What the guards compare, before and after a step.
struct StepFacts
{
    std::size_t vertices = 0;
    std::size_t faces = 0;
    MeshTopology topology;
    std::size_t self_intersections = 0; //!< pairs of faces of one object
    std::size_t flat_faces = 0;         //!< without area
    AngleMeasures angles;
    double area_mm2 = 0.0;
    double volume_mm3 = 0.0;
    Box3 box;
};

//! Of several objects all together. \pre there is one at least.
StepFacts facts_of(std::span<const MeshPart> objects);

//! "2 crossings, 1 face without area"; of the latter only where there are any.
std::string crossings_text(const StepFacts& facts);

//! One step, done.
struct StepReport
{
    std::string name; //!< "repair", "bodies", "smooth", "decimate", "relax", "place"
    std::string part; //!< of the object, where there are several
    std::string done; //!< what it did, for people
    StepFacts before;
    StepFacts after;
    std::optional<Deviation> deviation = std::nullopt; //!< of steps that change the shape
    std::optional<double> max_distance = std::nullopt; //!< that was allowed
    double seconds = 0.0;
};

//! The steps before the shape: units, repair, bodies. \throw Error as check_step().
std::vector<MeshPart> mend(std::vector<MeshPart> parts, const ProcessArguments& arguments,
                           std::vector<StepReport>& reports);

//! The steps on the shape and the place of one mesh. `surface`: what relaxation keeps to;
//! unset: the mesh as it comes to that step. \throw Error kIncomplete with the name of a step that would
//! break a promise.
TriangleMesh finish(TriangleMesh mesh, const FinishArguments& arguments, const std::string& part,
                    const BoundingSurface* surface, std::vector<StepReport>& reports);

//! Hollows one mesh out and meshes it anew. \throw Error kIncomplete where the new mesh is not all of the
//! solid's surface.
TriangleMesh hollow(TriangleMesh mesh, const HollowArguments& arguments, const std::string& part,
                    std::vector<StepReport>& reports);

//! --scale, --rotate, --translate, --center and --on-bed, of all parts together.
void place(std::vector<MeshPart>& parts, const PlacementArguments& arguments);

//! "smooth      10 rounds: volume -0.12 %, ..." for people, two lines a step.
std::string step_lines(const std::vector<StepReport>& reports);

} // namespace voroprobe
