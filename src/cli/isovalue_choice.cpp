#include "cli/isovalue_choice.h"

#include <cmath>
#include <variant>

#include "cli/label_map.h"
#include "cli/number_text.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

bool is_inside(double sample, double isovalue, InsideIs inside)
{
    return std::isfinite(sample) && (inside == InsideIs::kAbove ? sample >= isovalue : sample <= isovalue);
}

void require_a_number(std::size_t sample_count, const VolumeStatistics& statistics)
{
    if (statistics.nan_count + statistics.infinite_count == sample_count)
        throw EmptySurfaceError("no surface: all " + count_text(sample_count) +
                                " samples are NaN or infinite");
}

[[noreturn]] void throw_no_surface(double isovalue, const VolumeStatistics& statistics)
{
    const auto automatic = automatic_isovalue(statistics);
    const std::string advice =
        automatic ? "try --isovalue " + number_text(automatic->value) + " (" + automatic->source + ")"
                  : "no isovalue gives one";
    throw EmptySurfaceError("no surface at isovalue " + number_text(isovalue) + ": the samples range from " +
                            number_text(statistics.min) + " to " + number_text(statistics.max) + "; " +
                            advice);
}

} // namespace

std::optional<IsovalueChoice> automatic_isovalue(const VolumeStatistics& statistics)
{
    if (statistics.distinct_values == 2)
        return IsovalueChoice{0.5 * statistics.min + 0.5 * statistics.max, "halfway between the two values"};
    const auto thresholds = otsu_thresholds(statistics, 2);
    if (thresholds.empty() || !(statistics.min < statistics.max))
        return std::nullopt;
    return IsovalueChoice{thresholds.front(), "Otsu"};
}

bool separates(double isovalue, InsideIs inside, double min, double max)
{
    return inside == InsideIs::kAbove ? min < isovalue && isovalue <= max : min <= isovalue && isovalue < max;
}

IsovalueChoice choose_isovalue(const std::optional<double>& asked, InsideIs inside, const Volume& volume,
                               const VolumeStatistics& statistics)
{
    require_a_number(volume.geometry.sample_count(), statistics);
    if (asked)
    {
        if (!separates(*asked, inside, statistics.min, statistics.max))
            throw_no_surface(*asked, statistics);
        return {*asked, "given"};
    }
    if (looks_like_label_map(volume, statistics))
        throw UsageError(
            "this looks like a label map (" + std::to_string(statistics.distinct_values) +
            " whole numbers, neighbours mostly equal): give --labels all for a mesh of each label, or "
            "--isovalue, 0.5 for everything that is not 0");
    const auto automatic = automatic_isovalue(statistics);
    if (!automatic)
        throw EmptySurfaceError("no surface: all samples equal " + number_text(statistics.min));
    return *automatic;
}

double share_inside(const Volume& volume, double isovalue, InsideIs inside)
{
    const auto share = [&](const auto& samples)
    {
        std::size_t count = 0;
        for (const auto sample : samples)
            count += is_inside(static_cast<double>(sample), isovalue, inside) ? 1 : 0;
        return samples.empty() ? 0.0 : static_cast<double>(count) / static_cast<double>(samples.size());
    };
    return std::visit(share, volume.samples);
}

double border_share_inside(const Volume& volume, double isovalue, InsideIs inside)
{
    const auto& size = volume.geometry.size;
    std::size_t total = 0;
    std::size_t count = 0;
    for (std::size_t k = 0; k < size[2]; ++k)
        for (std::size_t j = 0; j < size[1]; ++j)
        {
            const bool whole_row = k == 0 || k + 1 == size[2] || j == 0 || j + 1 == size[1];
            const std::size_t step = whole_row || size[0] == 1 ? 1 : size[0] - 1;
            for (std::size_t i = 0; i < size[0]; i += step)
            {
                ++total;
                count += is_inside(volume.at(i, j, k), isovalue, inside) ? 1 : 0;
            }
        }
    return total == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(total);
}

} // namespace voroprobe
