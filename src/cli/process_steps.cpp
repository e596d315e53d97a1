#include "cli/process_steps.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "certificate/certificate.h"
#include "certificate/mesh_samples.h"
#include "certificate/object_overlaps.h"
#include "certificate/self_intersections.h"
#include "certificate/surface_selection.h"
#include "cli/info_text.h"
#include "cli/number_text.h"
#include "cli/surface_dropping.h"
#include "mesher/seeded_mesher.h"
#include "oracles/hollow_solid.h"
#include "postprocess/decimation.h"
#include "postprocess/relaxation.h"
#include "postprocess/repair.h"
#include "postprocess/smoothing.h"
#include "support/error.h"
#include "support/stopwatch.h"

namespace voroprobe
{

namespace
{

//! A step may move the surface by a typical edge after it, unless told otherwise.
constexpr double kEdgesMoved = 1.0;

//! Relaxation keeps faces so much nearer, as it knows the surface.
constexpr double kRelaxationShare = 0.25;

//! What relaxation is told of that distance: it asks at fewer points than are measured afterwards.
constexpr double kShareAsked = 0.75;

//! Angles that are equal but for rounding.
constexpr double kAngleRoundingDeg = 1e-6;

//! What a step lost; empty where nothing.
std::string broken_topology(const MeshTopology& before, const MeshTopology& after)
{
    if (before.closed() && !after.closed())
        return "leave " + plural_text(after.boundary_edges, "edge", "edges") + " on one face only";
    if (before.manifold() && !after.manifold())
        return "leave " +
               plural_text(after.non_manifold_edges + after.non_manifold_vertices, "place", "places") +
               " that are not manifold";
    if (before.oriented() && !after.oriented())
        return "leave " + plural_text(after.misoriented_edges, "edge", "edges") +
               " whose faces wind against each other";
    if (after.components != before.components)
        return "make " + count_text(after.components) + " pieces of " + count_text(before.components);
    if (after.euler_characteristic != before.euler_characteristic)
        return "change the Euler characteristic from " + std::to_string(before.euler_characteristic) +
               " to " + std::to_string(after.euler_characteristic);
    return {};
}

//! \throw Error kIncomplete where the step broke what every step on the shape promises.
void check_step(const StepReport& step)
{
    std::string broken = broken_topology(step.before.topology, step.after.topology);
    if (broken.empty() && step.after.self_intersections > step.before.self_intersections)
        broken = "let " +
                 plural_text(step.after.self_intersections - step.before.self_intersections, "more pair",
                             "more pairs") +
                 " of faces cross";
    if (broken.empty() && step.after.flat_faces > step.before.flat_faces)
        broken = "leave " +
                 plural_text(step.after.flat_faces - step.before.flat_faces, "more face", "more faces") +
                 " without area";
    if (broken.empty() && step.max_distance && step.deviation && step.deviation->max > *step.max_distance)
        broken = "move the surface by " + number_text(step.deviation->max) + " mm near (" +
                 triple_text(step.deviation->max_at, ", ") +
                 "); allowed: " + number_text(*step.max_distance) + " mm (--max-distance)";
    if (broken.empty() && step.name == "relax" &&
        step.after.angles.min_deg < step.before.angles.min_deg - kAngleRoundingDeg)
        broken = "lower the smallest angle from " + number_text(step.before.angles.min_deg) + " to " +
                 number_text(step.after.angles.min_deg) + " degrees";
    if (!broken.empty())
        throw Error(ExitStatus::kIncomplete, "step '" + step.name + "'" +
                                                 (step.part.empty() ? "" : " on object '" + step.part + "'") +
                                                 " would " + broken + "; nothing was written");
}

//! `pairs`: what self_intersections() found of one object.
StepFacts facts_of(const TriangleMesh& mesh, std::vector<FacePair> pairs)
{
    const std::size_t flat_faces = take_flat_faces(pairs);
    return {.vertices = mesh.vertices.size(),
            .faces = mesh.faces.size(),
            .topology = analyze_topology(mesh),
            .self_intersections = pairs.size(),
            .flat_faces = flat_faces,
            .angles = measure_angles(mesh),
            .area_mm2 = area(mesh),
            .volume_mm3 = enclosed_volume(mesh),
            .box = bounding_box(mesh)};
}

StepFacts facts_of(const TriangleMesh& mesh)
{
    return facts_of(mesh, self_intersections(mesh));
}

//! Runs steps on one mesh and keeps their reports.
class Steps
{
public:
    Steps(TriangleMesh mesh, std::string part, std::vector<StepReport>& reports)
        : mesh_(std::move(mesh)), part_(std::move(part)), reports_(reports), facts_(facts_of(mesh_))
    {
    }

    [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }
    [[nodiscard]] TriangleMesh take() { return std::move(mesh_); }

    //! `step(mesh, done)` returns the mesh after it and says what it did.
    template <typename Step>
    void run(const std::string& name, Step step)
    {
        const Stopwatch clock;
        StepReport report = begin(name);
        mesh_ = step(mesh_, report.done);
        end(std::move(report), clock);
    }

    //! The same, guarded.
    template <typename Step>
    void run_on_shape(const std::string& name, const std::optional<double>& max_distance, Step step)
    {
        const Stopwatch clock;
        StepReport report = begin(name);
        TriangleMesh after = step(mesh_, report.done);
        report.after = facts_of(after);
        report.deviation = deviation(mesh_, after);
        report.max_distance = max_distance.value_or(kEdgesMoved * typical_edge_length(after));
        check_step(report);
        mesh_ = std::move(after);
        end(std::move(report), clock);
    }

private:
    [[nodiscard]] StepReport begin(const std::string& name) const
    {
        return {.name = name, .part = part_, .done = "", .before = facts_, .after = {}};
    }

    void end(StepReport report, const Stopwatch& clock)
    {
        facts_ = facts_of(mesh_);
        report.after = facts_;
        report.seconds = clock.seconds();
        reports_.push_back(std::move(report));
    }

    TriangleMesh mesh_;
    std::string part_;
    std::vector<StepReport>& reports_;
    StepFacts facts_;
};

TriangleMesh repaired(const TriangleMesh& mesh, const std::optional<double>& max_hole_rim, std::string& done)
{
    RepairResult result = repair(mesh, {.max_hole_rim = max_hole_rim});
    done = plural_text(result.faces_dropped, "useless face", "useless faces") + " dropped, " +
           plural_text(result.vertices_split, "vertex", "vertices") +
           " added where faces were not one fan, " + plural_text(result.faces_turned, "face", "faces") +
           " turned over, " + plural_text(result.holes_closed, "hole", "holes") + " closed, " +
           count_text(result.holes_left) + " left";
    return std::move(result.mesh);
}

DecimationOptions decimation_options(const FinishArguments& arguments, const TriangleMesh& mesh)
{
    DecimationOptions options{.faces = arguments.decimate.count,
                              .max_distance = arguments.max_error,
                              .min_angle_deg = arguments.decimate_angle_deg};
    if (arguments.decimate.share)
        options.faces = static_cast<std::size_t>(
            std::llround(*arguments.decimate.share * static_cast<double>(mesh.faces.size())));
    return options;
}

TriangleMesh decimated(const TriangleMesh& mesh, const DecimationOptions& options, std::string& done)
{
    DecimationResult result = decimate(mesh, options);
    done = plural_text(result.vertices_removed, "vertex", "vertices") + " removed, " +
           count_text(result.vertices_locked) + " kept because faces would have crossed";
    if (options.faces && result.mesh.faces.size() > *options.faces)
        done += "; " + count_text(*options.faces) +
                " faces were asked for, and the bounds allowed no fewer than these";
    return std::move(result.mesh);
}

//! A mesh as the surface that its relaxation keeps to.
BoundingSurface itself(const TriangleMesh& mesh, double max_distance)
{
    const auto distance = std::make_shared<const MeshDistance>(mesh);
    return {projection_onto(distance), face_distance_to(distance), max_distance};
}

std::string short_faces_text(const ShortFaces& faces)
{
    std::string text = plural_text(faces.all(), "face", "faces") + " left below 33 deg";
    if (faces.all() > 0)
        text += ": " + count_text(faces.beyond_bound) + " beside faces beyond the distance bound, " +
                count_text(faces.at_creases) + " where the surface turns within a face, " +
                count_text(faces.elsewhere) + " elsewhere";
    return text;
}

TriangleMesh relaxed(const TriangleMesh& mesh, const FinishArguments& arguments,
                     const BoundingSurface* surface, std::string& done)
{
    const double max_distance = arguments.max_distance.value_or(kEdgesMoved * typical_edge_length(mesh));
    const RelaxationOptions options{.max_shift = kShareAsked * max_distance};
    RelaxationResult result =
        relax(mesh, surface != nullptr ? *surface : itself(mesh, kRelaxationShare * max_distance), options);
    done = plural_text(result.vertices_moved, "vertex", "vertices") + " moved, " +
           plural_text(result.edges_flipped, "edge", "edges") + " flipped, " +
           count_text(result.edges_collapsed) + " collapsed, " + count_text(result.edges_split) + " split; " +
           short_faces_text(result.short_faces);
    return std::move(result.mesh);
}

std::string change_text(double before, double after)
{
    if (before == 0.0)
        return "was none";
    std::string text = after >= before ? "+" : "";
    return text.append(percent_text((after - before) / std::abs(before)));
}

std::string facts_text(const StepReport& step)
{
    std::string text =
        count_text(step.after.faces) + " faces, " +
        plural_text(step.after.topology.components, "piece", "pieces") + ", " +
        (step.after.topology.closed() ? "closed" : "open") + ", " + crossings_text(step.after) +
        ", smallest angle " + number_text(step.after.angles.min_deg) + " deg (mean " +
        number_text(step.after.angles.mean_min_deg) + "), volume " + number_text(step.after.volume_mm3) +
        " mm3 (" + change_text(step.before.volume_mm3, step.after.volume_mm3) + ")";
    if (step.deviation)
        text += ", moved at most " + number_text(step.deviation->max) + " mm, mean " +
                number_text(step.deviation->mean);
    return text;
}

//! Of the mesh of a solid that is known by a level set of voxels of this size: as for scans.
MeshingOptions hollow_meshing_options(double voxel, double typical_edge)
{
    constexpr double kRadiusOfEdge = 0.577; // of an equilateral triangle
    return {.max_facet_radius = std::max(2.0 * voxel, kRadiusOfEdge * typical_edge),
            .max_facet_distance = 0.3 * voxel,
            .floor_radius = 0.25 * voxel,
            .reach_lower_bound = voxel};
}

//! Surfaces of a hollowed solid enclose as much.
constexpr std::size_t kLeastVoxels = 8;

//! Specks below the grain of the level set: they come of where walls meet, and are no part of the mesh.
std::vector<DroppedSurface> specks_among(const std::vector<ScanSurface>& surfaces)
{
    return surfaces_to_drop(surfaces, 1.0, {.min_enclosed_volume = kLeastVoxels});
}

TriangleMesh hollowed(const TriangleMesh& mesh, const HollowArguments& arguments, std::string& done)
{
    constexpr double kVoxelsPerWall = 4.0;
    const double voxel = arguments.voxel.value_or(*arguments.wall / kVoxelsPerWall);
    const HollowSolid solid = hollow_out(
        mesh, {.wall = *arguments.wall, .drain_diameter = arguments.drain.value_or(0.0), .voxel = voxel});
    MeshingResult result =
        mesh_surface(*solid.oracle, hollow_meshing_options(voxel, typical_edge_length(mesh)));
    const std::vector<ScanSurface>& surfaces = solid.inventory->surfaces();
    const std::vector<DroppedSurface> specks = specks_among(surfaces);
    drop_surfaces(specks, surfaces.size(), result);
    const Certificate certificate =
        certify(result.mesh, *solid.oracle, surfaces, {.reach = 2.0 * voxel, .dropped = specks},
                std::span<const SurfaceId>(result.surface_of_face));
    if (const auto broken = broken_promise(certificate))
        throw Error(ExitStatus::kIncomplete, "step 'hollow' would leave a mesh with " + *broken +
                                                 "; nothing was written (try a smaller --voxel)");
    done = plural_text(solid.hollows, "hollow", "hollows") + " inside a wall of " +
           number_text(*arguments.wall) + " mm, " + plural_text(solid.drains.size(), "drain", "drains") +
           "; meshed anew from voxels of " + number_text(voxel) + " mm";
    if (!specks.empty())
        done += "; " + plural_text(specks.size(), "speck", "specks") + " of less than " +
                count_text(kLeastVoxels) + " voxels left out";
    for (const Point3& drain : solid.drains)
        done += (drain == solid.drains.front() ? "; drained from (" : ", (") + triple_text(drain, ", ") + ")";
    return std::move(result.mesh);
}

Box3 box_of(const std::vector<MeshPart>& parts, const AffineTransform& to_from_parts)
{
    Box3 box;
    for (const MeshPart& part : parts)
        for (const Point3& p : part.mesh.vertices)
            box.include(to_from_parts * p);
    return box;
}

void select(std::vector<MeshPart>& parts, const ProcessArguments& arguments, std::vector<StepReport>& reports)
{
    std::vector<MeshPart> selected;
    for (MeshPart& part : parts)
    {
        Steps steps(std::move(part.mesh), parts.size() > 1 ? part.name : "", reports);
        SelectedBodies bodies;
        steps.run("bodies",
                  [&](const TriangleMesh& mesh, std::string& done)
                  {
                      bodies = select_bodies(mesh, arguments.bodies, arguments.sort);
                      done = plural_text(bodies.bodies.size(), "body", "bodies") + " kept, " +
                             count_text(bodies.bodies_dropped) + " dropped (" +
                             number_text(bodies.volume_dropped) + " mm3), " +
                             plural_text(bodies.cavities_dropped, "cavity", "cavities") + " filled";
                      std::vector<MeshPart> kept;
                      for (const TriangleMesh& body : bodies.bodies)
                          kept.push_back({.name = "", .mesh = body});
                      return merged(kept);
                  });
        if (!arguments.split)
            selected.push_back({.name = part.name, .color = part.color, .mesh = steps.take()});
        else
            for (std::size_t i = 0; i < bodies.bodies.size(); ++i)
                selected.push_back(
                    {.name = (part.name.empty() ? "body" : part.name) + ' ' + std::to_string(i + 1),
                     .color = part.color,
                     .mesh = std::move(bodies.bodies[i])});
    }
    std::erase_if(selected, [](const MeshPart& part) { return part.mesh.faces.empty(); });
    if (selected.empty())
        throw EmptySurfaceError("all bodies are left out by --min-volume; nothing was written");
    parts = std::move(selected);
}

AffineTransform placement_of(const PlacementArguments& arguments, const std::vector<MeshPart>& parts)
{
    const double k = arguments.scale;
    AffineTransform placed{{{Vec3{k, 0, 0}, Vec3{0, k, 0}, Vec3{0, 0, k}}}, {}};
    for (const AffineTransform& move : arguments.moves)
        placed = move * placed;
    if (!arguments.center && !arguments.on_bed)
        return placed;
    const Box3 box = box_of(parts, placed);
    const Point3 middle = box.center();
    const double z = arguments.on_bed ? box.min.z : middle.z;
    return AffineTransform{{}, {-middle.x, -middle.y, -z}} * placed;
}

} // namespace

StepFacts facts_of(std::span<const MeshPart> objects)
{
    const TriangleMesh mesh = merged(objects);
    std::vector<std::size_t> faces_in_objects;
    for (const MeshPart& object : objects)
        faces_in_objects.push_back(object.mesh.faces.size());
    std::vector<FacePair> pairs = self_intersections(mesh);
    take_object_overlaps(pairs, faces_in_objects);
    return facts_of(mesh, std::move(pairs));
}

std::string crossings_text(const StepFacts& facts)
{
    std::string text = plural_text(facts.self_intersections, "crossing", "crossings");
    if (facts.flat_faces > 0)
        text += ", " + plural_text(facts.flat_faces, "face", "faces") + " without area";
    return text;
}

std::vector<MeshPart> mend(std::vector<MeshPart> parts, const ProcessArguments& arguments,
                           std::vector<StepReport>& reports)
{
    const double k = arguments.mm_per_unit;
    for (MeshPart& part : parts)
    {
        Steps steps(std::move(part.mesh), parts.size() > 1 ? part.name : "", reports);
        if (k != 1.0)
            steps.run("units",
                      [k](TriangleMesh mesh, std::string& done)
                      {
                          done = "1 unit = " + number_text(k) + " mm";
                          transform(mesh, {{{Vec3{k, 0, 0}, Vec3{0, k, 0}, Vec3{0, 0, k}}}, {}});
                          return mesh;
                      });
        if (arguments.repair)
            steps.run("repair", [&](const TriangleMesh& mesh, std::string& done)
                      { return repaired(mesh, arguments.max_hole_rim, done); });
        part.mesh = steps.take();
    }
    if (!arguments.bodies.keeps_all() || arguments.sort || arguments.split)
        select(parts, arguments, reports);
    return parts;
}

TriangleMesh finish(TriangleMesh mesh, const FinishArguments& arguments, const std::string& part,
                    const BoundingSurface* surface, std::vector<StepReport>& reports)
{
    if (!arguments.changes_shape())
        return mesh;
    if (!is_closed_manifold(mesh))
        throw Error(ExitStatus::kIncomplete,
                    "the mesh" + (part.empty() ? "" : " of object '" + part + "'") +
                        " is not closed, manifold and oriented, so that its shape cannot be "
                        "changed with a promise (see --repair); nothing was written");
    Steps steps(std::move(mesh), part, reports);
    if (arguments.smooth > 0)
        steps.run_on_shape("smooth", arguments.max_distance,
                           [&](const TriangleMesh& before, std::string& done)
                           {
                               SmoothingResult result = smooth(before, arguments.smooth);
                               done = plural_text(arguments.smooth, "round", "rounds") + ", " +
                                      plural_text(result.vertices_held, "vertex", "vertices") +
                                      " held back where faces would have crossed";
                               return std::move(result.mesh);
                           });
    if (arguments.decimates())
        steps.run_on_shape("decimate", arguments.max_distance,
                           [&](const TriangleMesh& before, std::string& done)
                           { return decimated(before, decimation_options(arguments, before), done); });
    if (arguments.relax)
        steps.run_on_shape("relax", arguments.max_distance,
                           [&](const TriangleMesh& before, std::string& done)
                           { return relaxed(before, arguments, surface, done); });
    return steps.take();
}

TriangleMesh hollow(TriangleMesh mesh, const HollowArguments& arguments, const std::string& part,
                    std::vector<StepReport>& reports)
{
    if (!arguments.wall)
        return mesh;
    if (!is_closed_manifold(mesh))
        throw Error(ExitStatus::kIncomplete,
                    "the mesh is not closed, manifold and oriented, so that it has no inside to "
                    "hollow out (see --repair); nothing was written");
    Steps steps(std::move(mesh), part, reports);
    steps.run("hollow", [&](const TriangleMesh& before, std::string& done)
              { return hollowed(before, arguments, done); });
    return steps.take();
}

void place(std::vector<MeshPart>& parts, const PlacementArguments& arguments)
{
    if (arguments.keeps_all())
        return;
    const AffineTransform placed = placement_of(arguments, parts);
    for (MeshPart& part : parts)
        transform(part.mesh, placed);
}

std::string step_lines(const std::vector<StepReport>& reports)
{
    std::string text;
    for (const StepReport& step : reports)
        text += info_line(step.name, (step.part.empty() ? "" : step.part + ": ") + step.done) +
                info_line("", facts_text(step));
    return text;
}

} // namespace voroprobe
