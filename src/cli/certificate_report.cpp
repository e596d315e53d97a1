#include "cli/certificate_report.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "cli/info_text.h"
#include "cli/json_values.h"
#include "cli/number_text.h"

namespace voroprobe
{

namespace
{

using Json = nlohmann::ordered_json;

//! Entries of a list that a report shows; the JSON has them all.
constexpr std::size_t kMostShown = 5;

Box3 transformed(const Box3& box, const AffineTransform& shown_from_oracle)
{
    Box3 shown;
    for (int corner = 0; corner < 8; ++corner)
        shown.include(shown_from_oracle * Point3{(corner & 1) != 0 ? box.max.x : box.min.x,
                                                 (corner & 2) != 0 ? box.max.y : box.min.y,
                                                 (corner & 4) != 0 ? box.max.z : box.min.z});
    return shown;
}

// ---- For people ----

std::string place_text(const Box3& box, const AffineTransform& shown_from_oracle)
{
    return "around " + triple_text(shown_from_oracle * box.center(), ", ") + " mm";
}

std::string places_text(const std::vector<Point3>& places, const AffineTransform& shown_from_oracle)
{
    return places.empty() ? ""
                          : "; " + count_text(places.size()) + " necks of it on the wrong side, one at " +
                                triple_text(shown_from_oracle * places.front(), ", ") + " mm";
}

std::string counts_text(const Certificate& certificate)
{
    return count_text(certificate.surfaces_expected) + " in the scan, " +
           count_text(certificate.surfaces_meshed) + " meshed, " + count_text(certificate.missing.size()) +
           " missing, " + count_text(certificate.split.size()) + " in several pieces, " +
           count_text(certificate.foreign.size()) + " pieces on none" +
           (certificate.dropped.empty() ? "" : ", " + count_text(certificate.dropped.size()) + " dropped") +
           (certificate.in_border.empty()
                ? ""
                : ", " + count_text(certificate.in_border.size()) + " in the border only");
}

//! The first few entries, and how many more there are.
template <typename Entry, typename Text>
std::string list_lines(const std::vector<Entry>& entries, Text text)
{
    std::string lines;
    const std::size_t shown = std::min(entries.size(), kMostShown);
    for (std::size_t i = 0; i < shown; ++i)
        lines += info_line("", text(entries[i]));
    if (entries.size() > shown)
        lines += info_line("", "and " + count_text(entries.size() - shown) + " more");
    return lines;
}

std::string genus_text(const Certificate& certificate)
{
    return certificate.genus_mismatches.empty()
               ? "as in the scan, on every surface"
               : "not as in the scan on " + count_text(certificate.genus_mismatches.size()) +
                     (certificate.genus_mismatches.size() == 1 ? " surface" : " surfaces");
}

std::string distance_text(const DirectedDistance& distance)
{
    return "at most " + number_text(distance.max) + " mm, mean " + number_text(distance.mean) + " mm, rms " +
           number_text(distance.root_mean_square) + " mm, 95 % within " +
           number_text(distance.percentile_95) + " mm (" + count_text(distance.samples) + " samples)";
}

std::string exceptions_line(const CriteriaExceptions& exceptions)
{
    std::string text;
    const auto add = [&](const std::optional<std::size_t>& count, const std::string& name)
    {
        if (count)
            text += (text.empty() ? "" : ", ") + name + ' ' + count_text(*count);
    };
    add(exceptions.angle, "angle");
    add(exceptions.size, "size");
    add(exceptions.distance, "distance");
    return text.empty() ? "" : info_line("exceptions", "faces beyond the bounds: " + text);
}

// ---- For programs ----

Json json_of(const Box3& box, const AffineTransform& shown_from_oracle)
{
    return json_of(transformed(box, shown_from_oracle));
}

template <typename Entry, typename ToJson>
Json list_json(const std::vector<Entry>& entries, ToJson to_json)
{
    Json list = Json::array();
    for (const Entry& entry : entries)
        list.push_back(to_json(entry));
    return list;
}

Json json_of(const DirectedDistance& distance, const AffineTransform& shown_from_oracle)
{
    return {{"max_mm", distance.max},
            {"max_at", json_of(shown_from_oracle * distance.max_at)},
            {"mean_mm", distance.mean},
            {"rms_mm", distance.root_mean_square},
            {"percentile_95_mm", distance.percentile_95},
            {"samples", distance.samples}};
}

Json missing_json(const std::vector<MissingSurface>& surfaces, const AffineTransform& shown_from_oracle)
{
    return list_json(surfaces,
                     [&](const MissingSurface& surface)
                     {
                         return Json{{"id", surface.id},
                                     {"voxels", surface.voxels},
                                     {"box_mm", json_of(surface.box, shown_from_oracle)},
                                     {"reason", surface.reason}};
                     });
}

Json mismatches_json(const std::vector<GenusMismatch>& mismatches, const AffineTransform& shown_from_oracle)
{
    return list_json(mismatches,
                     [&](const GenusMismatch& mismatch)
                     {
                         return Json{
                             {"id", mismatch.id},
                             {"expected_euler_characteristic", mismatch.expected_euler_characteristic},
                             {"mesh_euler_characteristic", mismatch.mesh_euler_characteristic},
                             {"box_mm", json_of(mismatch.box, shown_from_oracle)},
                             {"places_mm", list_json(mismatch.places, [&](const Point3& place)
                                                     { return json_of(shown_from_oracle * place); })}};
                     });
}

} // namespace

std::string certificate_lines(const Certificate& certificate, const AffineTransform& shown_from_oracle)
{
    const auto missing_text = [&](const MissingSurface& surface)
    {
        return "surface " + std::to_string(surface.id) + " (" + count_text(surface.voxels) + " voxels, " +
               place_text(surface.box, shown_from_oracle) + "): " + surface.reason;
    };
    const auto split_text = [&](const SplitSurface& surface)
    {
        return "surface " + std::to_string(surface.id) + " (" + place_text(surface.box, shown_from_oracle) +
               "): " + count_text(surface.pieces) + " pieces";
    };
    const auto lost_text = [&](const LostPart& part)
    {
        return "surface " + std::to_string(part.surface) + ": the mesh does not come to a " +
               (part.is_hair() ? "hair" : "part") + " of it, as at " +
               triple_text(shown_from_oracle * part.place, ", ") + " mm";
    };
    const auto mismatch_text = [&](const GenusMismatch& mismatch)
    {
        return "surface " + std::to_string(mismatch.id) + " (" + place_text(mismatch.box, shown_from_oracle) +
               "): Euler characteristic " + std::to_string(mismatch.mesh_euler_characteristic) +
               ", in the scan " + std::to_string(mismatch.expected_euler_characteristic) +
               places_text(mismatch.places, shown_from_oracle);
    };
    return info_line("surfaces", counts_text(certificate)) + list_lines(certificate.missing, missing_text) +
           list_lines(certificate.in_border, missing_text) + list_lines(certificate.split, split_text) +
           list_lines(certificate.lost_parts, lost_text) + info_line("handles", genus_text(certificate)) +
           list_lines(certificate.genus_mismatches, mismatch_text) +
           info_line("distance", "from the mesh " + distance_text(certificate.distance.from_mesh)) +
           info_line("", "from the scan " + distance_text(certificate.distance.from_surface)) +
           exceptions_line(certificate.criteria_exceptions);
}

Json certificate_json(const Certificate& certificate, const AffineTransform& shown_from_oracle)
{
    const CriteriaExceptions& exceptions = certificate.criteria_exceptions;
    return {{"surfaces_expected", certificate.surfaces_expected},
            {"surfaces_meshed", certificate.surfaces_meshed},
            {"complete", certificate.complete()},
            {"missing", missing_json(certificate.missing, shown_from_oracle)},
            {"dropped", missing_json(certificate.dropped, shown_from_oracle)},
            {"in_border", missing_json(certificate.in_border, shown_from_oracle)},
            {"split", list_json(certificate.split,
                                [&](const SplitSurface& surface)
                                {
                                    return Json{{"id", surface.id},
                                                {"pieces", surface.pieces},
                                                {"box_mm", json_of(surface.box, shown_from_oracle)}};
                                })},
            {"foreign", list_json(certificate.foreign,
                                  [&](const ForeignPiece& piece)
                                  {
                                      return Json{{"piece", piece.piece},
                                                  {"faces", piece.faces},
                                                  {"box_mm", json_of(piece.box, shown_from_oracle)}};
                                  })},
            {"lost_parts", list_json(certificate.lost_parts,
                                     [&](const LostPart& part)
                                     {
                                         return Json{{"id", part.surface},
                                                     {"points", part.points},
                                                     {"hair", part.is_hair()},
                                                     {"place_mm", json_of(shown_from_oracle * part.place)}};
                                     })},
            {"genus_mismatches", mismatches_json(certificate.genus_mismatches, shown_from_oracle)},
            {"closed", certificate.closed},
            {"manifold", certificate.manifold()},
            {"oriented", certificate.oriented()},
            {"self_intersections", value_or_null(certificate.self_intersections)},
            {"distance_max_mm", certificate.distance.max()},
            {"distance_mean_mm", certificate.distance.mean()},
            {"distance_from_mesh", json_of(certificate.distance.from_mesh, shown_from_oracle)},
            {"distance_from_scan", json_of(certificate.distance.from_surface, shown_from_oracle)},
            {"criteria_exceptions",
             {{"angle", value_or_null(exceptions.angle)},
              {"size", value_or_null(exceptions.size)},
              {"distance", value_or_null(exceptions.distance)}}}};
}

} // namespace voroprobe
