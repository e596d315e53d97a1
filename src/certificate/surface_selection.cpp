#include "certificate/surface_selection.h"

#include <algorithm>
#include <string>

#include "support/number_text.h"

namespace voroprobe
{
namespace
{

//! The ids of the objects' surfaces, those that enclose most first.
std::vector<SurfaceId> objects_by_size(std::span<const ScanSurface> surfaces)
{
    std::vector<SurfaceId> objects;
    for (std::size_t id = 0; id < surfaces.size(); ++id)
    {
        if (!surfaces[id].cavity)
            objects.push_back(static_cast<SurfaceId>(id));
    }
    std::stable_sort(objects.begin(), objects.end(),
                     [&](SurfaceId a, SurfaceId b)
                     {
                         return surfaces[static_cast<std::size_t>(a)].enclosed_samples >
                                surfaces[static_cast<std::size_t>(b)].enclosed_samples;
                     });
    return objects;
}

std::vector<bool> among_largest(std::span<const ScanSurface> surfaces, std::size_t wanted)
{
    std::vector<bool> among(surfaces.size(), false);
    const std::vector<SurfaceId> objects = objects_by_size(surfaces);
    for (std::size_t i = 0; i < std::min(wanted, objects.size()); ++i)
        among[static_cast<std::size_t>(objects[i])] = true;
    return among;
}

} // namespace

std::vector<DroppedSurface> surfaces_to_drop(std::span<const ScanSurface> surfaces, double voxel_volume,
                                             const SurfaceSelection& selection)
{
    const std::vector<bool> largest =
        among_largest(surfaces, selection.keep_largest.value_or(surfaces.size()));
    std::vector<bool> is_dropped(surfaces.size(), false);
    std::vector<DroppedSurface> dropped;
    for (std::size_t id = 0; id < surfaces.size(); ++id) // parents come first
    {
        const ScanSurface& surface = surfaces[id];
        const double volume = static_cast<double>(surface.enclosed_samples) * voxel_volume;
        std::string reason;
        if (surface.parent != kNoSurface && is_dropped[static_cast<std::size_t>(surface.parent)])
            reason = "lies within surface " + std::to_string(surface.parent) + ", which is dropped";
        else if (surface.cavity && selection.drop_cavities)
            reason = "is a cavity";
        else if (selection.min_enclosed_volume && volume < *selection.min_enclosed_volume)
            reason = "encloses " + number_text(volume) + " mm3";
        else if (!surface.cavity && !largest[id])
            reason = "is not among the largest " + std::to_string(*selection.keep_largest);
        if (reason.empty())
            continue;
        is_dropped[id] = true;
        dropped.push_back({static_cast<SurfaceId>(id), reason});
    }
    return dropped;
}

} // namespace voroprobe
