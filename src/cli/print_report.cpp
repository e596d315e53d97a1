#include "cli/print_report.h"

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

//! Cavities named one by one in the report; the JSON has all.
constexpr std::size_t kMostCavitiesShown = 5;

std::string length_text(const std::optional<Narrowest>& found)
{
    return found ? number_text(found->length) + " mm near (" + triple_text(found->at, ", ") + ')'
                 : "none met";
}

std::string cavity_lines(const std::vector<TrappedCavity>& cavities)
{
    std::string text;
    for (std::size_t i = 0; i < std::min(cavities.size(), kMostCavitiesShown); ++i)
        text += info_line("", "cavity of " + number_text(cavities[i].volume) + " mm3 around (" +
                                  triple_text(cavities[i].box.center(), ", ") + ')');
    if (cavities.size() > kMostCavitiesShown)
        text += info_line("", "and " + count_text(cavities.size() - kMostCavitiesShown) + " smaller ones");
    return text;
}

std::string fit_text(const PrintCheck& check, const PrintOptions& options)
{
    const std::string bed = triple_text(*options.bed) + " mm";
    return !check.fits         ? "does not fit " + bed
           : check.fits_turned ? "fits " + bed + " turned by 90 degrees about z"
                               : "fits " + bed;
}

Json json_of(const std::optional<Narrowest>& found)
{
    return found ? Json{{"mm", found->length}, {"at", json_of(found->at)}} : Json(nullptr);
}

Json json_of(const std::optional<WallThickness>& walls)
{
    return walls ? Json{{"percent_1_mm", walls->percent_1},
                        {"percent_5_mm", walls->percent_5},
                        {"median_mm", walls->median}}
                 : Json(nullptr);
}

} // namespace

std::string print_lines(const PrintCheck& check, const PrintOptions& options)
{
    std::string text =
        info_line("printing", triple_text(check.box.extent()) + " mm, z up" +
                                  (options.bed ? "; " + fit_text(check, options) : "")) +
        info_line("bodies", count_text(check.bodies) + "; the smallest is " +
                                triple_text(check.smallest_body.extent()) + " mm around (" +
                                triple_text(check.smallest_body.center(), ", ") + ")") +
        info_line("cavities", count_text(check.cavities.size()) + " without a way out") +
        cavity_lines(check.cavities) +
        info_line("walls", "thinnest " + length_text(check.thinnest_wall) +
                               " (rays along the inward normal, opposite faces within 60 deg)");
    if (const auto& walls = check.wall_thickness)
        text +=
            info_line("", "1 % of their surface is on walls thinner than " + number_text(walls->percent_1) +
                              " mm, 5 % thinner than " + number_text(walls->percent_5) +
                              " mm, half thinner than " + number_text(walls->median) + " mm");
    if (options.min_wall)
        text +=
            info_line("", percent_text(check.thin_area_share) + " of the surface is on walls thinner than " +
                              number_text(*options.min_wall) + " mm");
    text += info_line("gaps", "narrowest " + length_text(check.narrowest_gap)) +
            info_line("overhangs", number_text(check.overhang_area) + " mm2, " +
                                       percent_text(check.overhang_share) +
                                       " of the surface leans out by more than " +
                                       number_text(options.overhang_deg) + " deg") +
            info_line("material", number_text(check.volume) + " mm3" +
                                      (check.weight_g ? ", " + number_text(*check.weight_g) + " g" : ""));
    return text;
}

Json print_json(const PrintCheck& check, const PrintOptions& options)
{
    Json cavities = Json::array();
    for (const TrappedCavity& cavity : check.cavities)
        cavities.push_back({{"volume_mm3", cavity.volume}, {"box_mm", json_of(cavity.box)}});
    return {{"box_mm", json_of(check.box)},
            {"bodies", check.bodies},
            {"smallest_body_mm", json_of(check.smallest_body)},
            {"trapped_cavities", std::move(cavities)},
            {"thinnest_wall", json_of(check.thinnest_wall)},
            {"wall_thickness", json_of(check.wall_thickness)},
            {"wall_method", "rays along the inward normal to opposite faces within 60 degrees"},
            {"min_wall_mm", value_or_null(options.min_wall)},
            {"thin_area_share", options.min_wall ? Json(check.thin_area_share) : Json(nullptr)},
            {"narrowest_gap", json_of(check.narrowest_gap)},
            {"overhang_deg", options.overhang_deg},
            {"overhang_area_mm2", check.overhang_area},
            {"overhang_share", check.overhang_share},
            {"volume_mm3", check.volume},
            {"weight_g", value_or_null(check.weight_g)},
            {"fits_bed", options.bed ? Json(check.fits) : Json(nullptr)},
            {"warnings", check.warnings},
            {"failures", check.failures}};
}

} // namespace voroprobe
