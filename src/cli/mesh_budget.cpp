#include "cli/mesh_budget.h"

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

//! At least the area of all surfaces, scan units squared. Source: the isoperimetric inequality.
double least_area(const Inventory& inventory, double voxel_volume)
{
    double area = 0.0;
    for (const ScanSurface& surface : inventory.surfaces())
    {
        if (surface.enclosed_samples < kFewSamples)
            continue;
        const double volume = static_cast<double>(surface.enclosed_samples) * voxel_volume;
        area += std::cbrt(36.0 * std::numbers::pi * volume * volume);
    }
    return area;
}

} // namespace

std::size_t vertices_in_memory()
{
    const std::size_t memory = total_memory_bytes();
    return memory == 0 ? std::numeric_limits<std::size_t>::max() : memory / kBytesPerVertex;
}

void check_size(const MeshingOptions& options, const Inventory& inventory, double voxel_volume)
{
    const double largest_face = 0.75 * std::numbers::sqrt3; // in squared radii
    const double area_of_a_vertex = 2.0 * largest_face;     // a closed mesh has two faces for each
    const double area = least_area(inventory, voxel_volume);
    const double size = options.max_facet_radius;
    const double least_vertices = area / (area_of_a_vertex * size * size);
    const auto most_vertices = static_cast<double>(vertices_in_memory());
    if (least_vertices <= most_vertices)
        return;
    throw UsageError("--size is " + number_text(size) + "; it takes over " + number_text(least_vertices) +
                     " vertices, and this machine's memory holds about " + count_text(vertices_in_memory()) +
                     "; allowed here: at least " +
                     number_text(std::sqrt(area / (area_of_a_vertex * most_vertices))) + " mm");
}

} // namespace voroprobe
