#pragma once

#include <memory>

#include "compare/contestant.h"
#include "compare/reference_surface.h"
#include "oracles/trilinear_oracle.h"
#include "volume/phantoms.h"

namespace voroprobe
{

//! A phantom of one sample per mm, ready to be meshed and measured against.
struct ComparedPhantom
{
    ReferenceSurface reference;
    MeshingTask task;
};

inline ComparedPhantom compared_phantom(const LevelFunction& shape, const std::array<std::size_t, 3>& size)
{
    const auto volume = std::make_shared<const Volume>(sample_volume(shape, size, {1, 1, 1}));
    const LevelledVolume levelled = level_volume(volume, 0.0);
    const auto inventory = std::make_shared<const Inventory>(*make_height_field(levelled), 1);
    return {.reference = {.oracle = make_trilinear_oracle(levelled, inventory),
                          .inventory = inventory,
                          .world_from_grid = {},
                          .voxel = 1.0},
            .task = {.volume = volume,
                     .isovalue = 0.0,
                     .min_facet_angle_deg = 30.0,
                     .max_facet_radius = 2.0,
                     .max_facet_distance = 0.3,
                     .floor_radius = 0.25,
                     .reach = 1.0}};
}

//! The union of shapes: inside where any of them is.
inline LevelFunction union_of(std::vector<LevelFunction> shapes)
{
    return [shapes = std::move(shapes)](const Point3& p)
    {
        double level = shapes.front()(p);
        for (const LevelFunction& shape : shapes)
            level = std::max(level, shape(p));
        return level;
    };
}

} // namespace voroprobe
