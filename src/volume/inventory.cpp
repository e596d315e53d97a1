// This file follows: M. van Kreveld, R. van Oostrum, C. Bajaj, V. Pascucci, D. Schikore, "Contour trees and
// small seed sets for isosurface traversal", 1997, and H. Carr, J. Snoeyink, U. Axen, "Computing contour
// trees in all dimensions", 2003: at one isovalue, regions are the nodes of a tree and surfaces its edges.

#include "volume/inventory.h"

#include "volume/surface_survey.h"

namespace voroprobe
{

Inventory::Inventory(const HeightField& field, std::size_t threads)
    : runs_(field, threads), around_inside_(1, kNoSurface), around_outside_(2, kNoSurface)
{
    build_tree();
    count_enclosed_samples();
    measure_surfaces(field, threads);
}

// What precedes the first sample (k, j, i) of a region in its row is the region around it: were it within the
// region, behind a surface the region surrounds, the row would have left the region for it before.
void Inventory::build_tree()
{
    const auto [columns, rows, slices] = runs_.sample_count();
    for (int k = 0; k < slices; ++k)
        for (int j = 0; j < rows; ++j)
        {
            Region before = kOuterRegion;
            for (const Run& run : runs_.row(j, k))
            {
                const std::size_t known =
                    is_inside(run.region) ? around_inside_.size() : around_outside_.size();
                if (static_cast<std::size_t>(std::abs(run.region)) == known)
                    add_surface(run.region, before);
                before = run.region;
            }
        }
}

void Inventory::add_surface(Region region, Region around)
{
    const auto id = static_cast<SurfaceId>(surfaces_.size());
    (is_inside(region) ? around_inside_ : around_outside_).push_back(id);
    ScanSurface surface{};
    surface.inside = is_inside(region) ? region : around;
    surface.outside = is_inside(region) ? around : region;
    surface.parent = surface_around(around);
    surface.cavity = !is_inside(region);
    surfaces_.push_back(surface);
}

void Inventory::count_enclosed_samples()
{
    const auto [columns, rows, slices] = runs_.sample_count();
    for (int k = 0; k < slices; ++k)
        for (int j = 0; j < rows; ++j)
        {
            int end = columns;
            const std::span<const Run> row = runs_.row(j, k);
            for (std::size_t i = row.size(); i-- > 0; end = row[i].first)
                if (const SurfaceId id = surface_around(row[i].region); id != kNoSurface)
                    surfaces_[static_cast<std::size_t>(id)].enclosed_samples +=
                        static_cast<std::size_t>(end - row[i].first);
        }
    for (std::size_t id = surfaces_.size(); id-- > 0;)
        if (const SurfaceId parent = surfaces_[id].parent; parent != kNoSurface)
            surfaces_[static_cast<std::size_t>(parent)].enclosed_samples += surfaces_[id].enclosed_samples;
}

void Inventory::measure_surfaces(const HeightField& field, std::size_t threads)
{
    const std::vector<SurfaceMeasure> measures = voroprobe::measure_surfaces(field, *this, threads);
    for (std::size_t id = 0; id < surfaces_.size(); ++id)
    {
        const SurfaceMeasure& measure = measures[id];
        surfaces_[id].box = measure.box;
        surfaces_[id].point = measure.has_crossing ? measure.first_crossing : measure.box.min;
        surfaces_[id].touches_border = measure.touches_border;
        surfaces_[id].euler_characteristic = static_cast<int>(measure.euler_quarters / 4);
    }
}

SurfaceId Inventory::surface_between(Region a, Region b) const
{
    if (is_inside(a) == is_inside(b))
        return kNoSurface;
    const Region inside = is_inside(a) ? a : b;
    const Region outside = is_inside(a) ? b : a;
    for (const SurfaceId id : {surface_around(inside), surface_around(outside)})
        if (id != kNoSurface && surfaces_[static_cast<std::size_t>(id)].inside == inside &&
            surfaces_[static_cast<std::size_t>(id)].outside == outside)
            return id;
    return kNoSurface;
}

std::size_t Inventory::memory_bytes() const
{
    return runs_.memory_bytes() + surfaces_.capacity() * sizeof(ScanSurface) +
           (around_inside_.capacity() + around_outside_.capacity()) * sizeof(SurfaceId);
}

} // namespace voroprobe
