#include "cli/check_run.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "cli/certificate_report.h"
#include "cli/info_text.h"
#include "cli/json_values.h"
#include "cli/number_text.h"
#include "cli/print_report.h"
#include "support/memory.h"

namespace voroprobe
{

namespace
{

using Json = nlohmann::ordered_json;

//! Pairs of faces that cross, named in the JSON.
constexpr std::size_t kMostPairsNamed = 10;

//! Overlaps of objects, named in the report: the largest.
constexpr std::size_t kMostOverlapsNamed = 5;

//! Boxes are shown in the frame of the mesh; in lps where that is counted in voxels, so that they are in mm.
AffineTransform shown_from_grid(const CheckRun& run)
{
    const OutputFrame frame =
        run.arguments.frame == OutputFrame::kIndex ? OutputFrame::kLps : run.arguments.frame;
    return output_from_grid(frame, run.scan->input.placement);
}

// ---- For people ----

std::string topology_text(const MeshTopology& topology)
{
    return std::string(topology.closed() ? "closed" : "not closed") + ", " +
           (topology.manifold() ? "manifold" : "not manifold") + ", " +
           (topology.oriented() ? "oriented" : "not oriented") + ", Euler characteristic " +
           std::to_string(topology.euler_characteristic);
}

//! "70: 60 of genus 0, 10 of genus up to 40"; genus is told of closed pieces with no crowded edge.
std::string pieces_text(const std::vector<MeshPiece>& pieces)
{
    std::size_t spheres = 0;
    std::size_t with_handles = 0;
    std::size_t others = 0;
    long most_handles = 0;
    for (const MeshPiece& piece : pieces)
    {
        const bool told = piece.closed() && piece.crowded_edges == 0 && piece.euler_characteristic <= 2;
        others += told ? 0 : 1;
        spheres += told && piece.genus() == 0 ? 1 : 0;
        with_handles += told && piece.genus() > 0 ? 1 : 0;
        most_handles = told ? std::max(most_handles, piece.genus()) : most_handles;
    }
    return count_text(pieces.size()) + ": " + count_text(spheres) + " of genus 0" +
           (with_handles == 0
                ? ""
                : ", " + count_text(with_handles) + " of genus up to " + std::to_string(most_handles)) +
           (others == 0 ? "" : ", " + count_text(others) + " open or not manifold");
}

std::string crossings_text(const MeshCheck& check)
{
    const std::size_t crossing = check.self_intersections.size();
    return (crossing == 0 ? "no two faces cross or overlap"
                          : plural_text(crossing, "pair of faces crosses or overlaps",
                                        "pairs of faces cross or overlap")) +
           "; " + plural_text(check.flat_faces, "face") + " without area, " +
           count_text(check.duplicate_faces) + " doubled; " + count_text(check.topology.unused_vertices) +
           " vertices on no face";
}

std::string object_name(const CheckRun& run, std::size_t object)
{
    const std::string& name = run.objects[object];
    return name.empty() ? "object " + std::to_string(object + 1) : "'" + name + "'";
}

//! "3; 1 pair of them overlaps: 'a' and 'b' at 12 pairs of faces".
std::string objects_text(const CheckRun& run)
{
    std::vector<ObjectOverlap> largest = run.check.object_overlaps;
    const auto has_more = [](const ObjectOverlap& a, const ObjectOverlap& b)
    { return a.face_pairs > b.face_pairs; };
    std::stable_sort(largest.begin(), largest.end(), has_more);
    std::string text = count_text(run.objects.size()) + "; ";
    if (largest.empty())
        return text + "none touches or overlaps another";
    text += count_text(largest.size()) +
            (largest.size() == 1 ? " pair of them touches or overlaps:" : " pairs of them touch or overlap:");
    const std::size_t named = std::min(largest.size(), kMostOverlapsNamed);
    for (std::size_t i = 0; i < named; ++i)
        text += (i == 0 ? " " : ", ") + object_name(run, largest[i].first) + " and " +
                object_name(run, largest[i].second) + " at " + count_text(largest[i].face_pairs) +
                (largest[i].face_pairs == 1 ? " pair of faces" : " pairs of faces");
    return text + (named < largest.size() ? ", and others" : "");
}

std::string angles_text(const CheckRun& run)
{
    const MeshCheck& check = run.check;
    std::string text = "smallest " + number_text(check.angles.min_deg) +
                       " deg, mean of the faces' smallest " + number_text(check.angles.mean_min_deg) +
                       " deg, largest " + number_text(check.angles.max_deg) + " deg; faces below";
    for (std::size_t i = 0; i < kShownAnglesDeg.size(); ++i)
        text += (i == 0 ? " " : ", ") + number_text(kShownAnglesDeg[i]) +
                " deg: " + count_text(check.faces_below_shown_angle[i]);
    if (check.faces_below_angle_bound)
        text += ", " + number_text(*run.arguments.criteria.min_angle_deg) +
                " deg: " + count_text(*check.faces_below_angle_bound);
    return text;
}

std::string box_text(const Box3& box)
{
    const double rounding = 1e-12 * box.diagonal(); // coordinates below are zero but for their noise
    const auto shown = [&](double x) { return number_text(std::abs(x) < rounding ? 0.0 : x); };
    const auto range = [&](std::size_t axis) { return shown(box.min[axis]) + " .. " + shown(box.max[axis]); };
    return "x " + range(0) + ", y " + range(1) + ", z " + range(2);
}

std::string mesh_lines(const CheckRun& run)
{
    const MeshCheck& check = run.check;
    return info_line("mesh", run.arguments.mesh.string()) +
           info_line("", count_text(check.vertices) + " vertices, " + count_text(check.faces) + " faces") +
           info_line("topology", topology_text(check.topology)) +
           info_line("pieces", pieces_text(check.pieces)) +
           (run.objects.size() > 1 ? info_line("objects", objects_text(run)) : "") +
           info_line("faces", crossings_text(check)) + info_line("angles", angles_text(run)) +
           info_line("area", number_text(check.area) + ", volume " + number_text(check.enclosed_volume)) +
           info_line("box", box_text(check.box));
}

std::string scan_lines(const CheckRun& run)
{
    const SurfaceInput& input = run.scan->input;
    return info_line("scan", run.arguments.against->string()) +
           info_line("", size_text(input.lattice.size) + " voxels of " + triple_text(input.lattice.spacing) +
                             " mm, " + input.stored_type + " (" + input.format + ")") +
           info_line("isovalue", number_text(input.isovalue.value) + " (" + input.isovalue.source +
                                     "), inside " + (input.inside == InsideIs::kAbove ? "above" : "below")) +
           certificate_lines(run.scan->certificate, shown_from_grid(run));
}

// ---- For programs ----

Json pieces_json(const std::vector<MeshPiece>& pieces)
{
    Json list = Json::array();
    for (const MeshPiece& piece : pieces)
        list.push_back({{"faces", piece.faces},
                        {"euler_characteristic", piece.euler_characteristic},
                        {"closed", piece.closed()},
                        {"area", piece.area},
                        {"volume", piece.enclosed_volume},
                        {"box", json_of(piece.box)}});
    return list;
}

Json pairs_json(const std::vector<FacePair>& pairs)
{
    Json list = Json::array();
    for (std::size_t i = 0; i < std::min(pairs.size(), kMostPairsNamed); ++i)
        list.push_back(Json::array({pairs[i].first, pairs[i].second}));
    return list;
}

Json overlaps_json(const CheckRun& run)
{
    Json list = Json::array();
    for (const ObjectOverlap& overlap : run.check.object_overlaps)
        list.push_back({{"objects", Json::array({overlap.first + 1, overlap.second + 1})},
                        {"names", Json::array({run.objects[overlap.first], run.objects[overlap.second]})},
                        {"face_pairs", overlap.face_pairs}});
    return list;
}

Json mesh_json(const CheckRun& run)
{
    const MeshCheck& check = run.check;
    const MeshTopology& topology = check.topology;
    return {{"path", run.arguments.mesh.string()},
            {"vertices", check.vertices},
            {"faces", check.faces},
            {"components", topology.components},
            {"closed", topology.closed()},
            {"manifold", topology.manifold()},
            {"oriented", topology.oriented()},
            {"euler_characteristic", topology.euler_characteristic},
            {"self_intersections", check.self_intersections.size()},
            {"boundary_edges", topology.boundary_edges},
            {"non_manifold_edges", topology.non_manifold_edges},
            {"non_manifold_vertices", topology.non_manifold_vertices},
            {"misoriented_edges", topology.misoriented_edges},
            {"flat_faces", check.flat_faces},
            {"duplicate_faces", check.duplicate_faces},
            {"unused_vertices", topology.unused_vertices},
            {"area", check.area},
            {"volume", check.enclosed_volume},
            {"min_angle_deg", check.angles.min_deg},
            {"mean_min_angle_deg", check.angles.mean_min_deg},
            {"max_angle_deg", check.angles.max_deg},
            {"faces_below_10_deg", check.faces_below_shown_angle[0]},
            {"faces_below_20_deg", check.faces_below_shown_angle[1]},
            {"faces_below_30_deg", check.faces_below_shown_angle[2]},
            {"faces_below_angle_bound", value_or_null(check.faces_below_angle_bound)},
            {"box", json_of(check.box)},
            {"first_self_intersections", pairs_json(check.self_intersections)},
            {"objects", run.objects.size()},
            {"object_overlaps", overlaps_json(run)},
            {"pieces", pieces_json(check.pieces)}};
}

Json scan_json(const CheckRun& run)
{
    const SurfaceInput& input = run.scan->input;
    return {{"path", run.arguments.against->string()},
            {"format", input.format},
            {"size", input.lattice.size},
            {"spacing", json_of(input.lattice.spacing)},
            {"type", input.stored_type},
            {"isovalue", input.isovalue.value},
            {"isovalue_source", input.isovalue.source},
            {"inside", input.inside == InsideIs::kAbove ? "above" : "below"},
            {"border", run.arguments.border == BorderFaces::kClosed ? "closed" : "open"},
            {"frame_of_reference", frame_name(run.arguments.frame)},
            {"warnings", input.warnings}};
}

//! Where nothing fits, the frame is the first suspect.
bool lies_nowhere_near(const Certificate& certificate, const MeshCheck& check)
{
    return certificate.surfaces_meshed == 0 && certificate.foreign.size() == check.pieces.size();
}

std::optional<std::string> wrong_with_mesh(const CheckRun& run)
{
    if (!run.scan)
        return defects(run.check);
    auto reason = broken_promise(run.scan->certificate);
    if (const std::size_t flat = run.check.flat_faces; flat > 0) // of which the certificate knows nothing
        reason = (reason ? *reason + ", " : "") + plural_text(flat, "face") + " without area";
    if (reason && lies_nowhere_near(run.scan->certificate, run.check))
        *reason +=
            "; no vertex lies near the surface: is it a mesh of this scan at this isovalue, in the frame " +
            std::string(frame_name(run.arguments.frame)) + " (--frame-of-reference)?";
    return reason;
}

} // namespace

std::optional<std::string> what_is_wrong(const CheckRun& run)
{
    auto reason = wrong_with_mesh(run);
    if (run.print)
        for (const std::string& failure : run.print->failures)
            reason = (reason ? *reason + ", " : "") + failure;
    return reason;
}

std::string check_report(const CheckRun& run)
{
    return mesh_lines(run) + (run.print ? print_lines(*run.print, run.arguments.print) : "") +
           (run.scan ? scan_lines(run) : "") +
           info_line("time", "read " + seconds_text(run.seconds_reading) + ", check " +
                                 seconds_text(run.seconds_checking) + "; peak memory " +
                                 bytes_text(peak_memory_bytes()));
}

std::string check_json(const CheckRun& run)
{
    const auto wrong = what_is_wrong(run);
    Json result{{"version", VOROPROBE_VERSION},
                {"status", wrong ? "incomplete" : "done"},
                {"reason", value_or_null(wrong)},
                {"mesh", mesh_json(run)}};
    if (run.print)
        result["printable"] = print_json(*run.print, run.arguments.print);
    if (run.scan)
    {
        result["scan"] = scan_json(run);
        result["certificate"] = certificate_json(run.scan->certificate, shown_from_grid(run));
    }
    result["timings_s"] = {{"read", run.seconds_reading}, {"check", run.seconds_checking}};
    result["peak_memory_bytes"] = peak_memory_bytes();
    return json_text(result) + '\n';
}

} // namespace voroprobe
