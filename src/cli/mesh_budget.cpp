#include "cli/mesh_budget.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cli/number_text.h"
#include "support/error.h"
#include "support/memory.h"

namespace voroprobe
{
namespace
{

// Peak memory of the whole program per vertex, measured on scans of some hundred thousand.
constexpr std::size_t kBytesPerVertex = 2600;

// Smaller parts may enclose much less than their samples' voxels.
constexpr std::size_t kFewSamples = 64;

//! At least the area around so many samples, scan units squared. Source: the isoperimetric inequality.
double least_area(std::size_t samples, double voxel_volume)
{
    const double volume = static_cast<double>(samples) * voxel_volume;
    return samples < kFewSamples ? 0.0 : std::cbrt(36.0 * std::numbers::pi * volume * volume);
}

void check_size(double size, double area, std::size_t most_vertices)
{
    const double largest_face = 0.75 * std::numbers::sqrt3; // in squared radii
    const double area_of_a_vertex = 2.0 * largest_face;     // a closed mesh has two faces for each
    const double least_vertices = area / (area_of_a_vertex * size * size);
    if (least_vertices <= static_cast<double>(most_vertices))
        return;
    throw UsageError("--size is " + number_text(size) + "; it takes over " + number_text(least_vertices) +
                     " vertices, and this machine's memory holds about " + count_text(most_vertices) +
                     "; allowed here: at least " +
                     number_text(std::sqrt(area / (area_of_a_vertex * static_cast<double>(most_vertices)))) +
                     " mm");
}

} // namespace

std::size_t vertices_in_memory()
{
    const std::size_t memory = total_memory_bytes();
    return memory == 0 ? std::numeric_limits<std::size_t>::max() : memory / kBytesPerVertex;
}

void check_size(const MeshingOptions& options, const Inventory& inventory, double voxel_volume)
{
    double area = 0.0;
    for (const ScanSurface& surface : inventory.surfaces())
        area += least_area(surface.enclosed_samples, voxel_volume);
    check_size(options.max_facet_radius, area, vertices_in_memory());
}

void check_size(const MeshingOptions& options, const LabelSurvey& survey,
                std::span<const std::uint32_t> labels, double voxel_volume, std::size_t threads)
{
    double largest = 0.0;
    for (const std::uint32_t label : labels)
    {
        double area = 0.0;
        for (const std::uint32_t part : survey.labels()[label].parts)
            area += least_area(survey.parts()[part].voxels, voxel_volume);
        largest = std::max(largest, area);
    }
    check_size(options.max_facet_radius, largest, std::max<std::size_t>(1, vertices_in_memory() / threads));
}

} // namespace voroprobe
