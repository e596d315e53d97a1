#include "compare/label_frame.h"

#include "oracles/trilinear_oracle.h"
#include "volume/height_field.h"

namespace voroprobe
{

namespace
{

constexpr double kHalf = 0.5;

Vec3 scaled(const Vec3& spacing, const Vec3& index)
{
    return {spacing.x * index.x, spacing.y * index.y, spacing.z * index.z};
}

Vec3 vector_of(const SampleIndex& index)
{
    return {static_cast<double>(index[0]), static_cast<double>(index[1]), static_cast<double>(index[2])};
}

Volume volume_of(const PartMask& mask, const Vec3& spacing)
{
    std::vector<std::uint8_t> inside;
    inside.reserve(mask.part.size());
    for (const std::uint32_t part : mask.part)
        inside.push_back(part != 0 ? 1 : 0);
    return make_volume({.size = mask.size, .spacing = spacing, .direction = {}, .origin = {}},
                       std::move(inside));
}

} // namespace

PartMask mask_of_label(const LabelTask& task, std::uint32_t label)
{
    const SurveyedLabel& surveyed = task.survey->labels()[label];
    return cut_mask(*task.survey, {surveyed.parts, surveyed.box});
}

AffineTransform grid_from_mask(const LabelTask& task, const PartMask& mask)
{
    return {.linear = {}, .translation = scaled(task.spacing, vector_of(mask.first))};
}

ReferenceSurface halfway_surface(const LabelTask& task, const PartMask& mask)
{
    const LevelledVolume levelled =
        level_volume(std::make_shared<const Volume>(volume_of(mask, task.spacing)), kHalf);
    const auto inventory = std::make_shared<const Inventory>(*make_height_field(levelled), 1);
    return {.oracle = make_trilinear_oracle(levelled, inventory),
            .inventory = inventory,
            .world_from_grid = task.world_from_grid * grid_from_mask(task, mask),
            .voxel = task.voxel};
}

Box3 world_box(const LabelTask& task, const IndexBox& box)
{
    const Vec3 margin = kHalf * task.spacing;
    const Point3 low = scaled(task.spacing, vector_of(box.first)) - margin;
    const Point3 high = scaled(task.spacing, vector_of(box.last)) + margin;
    Box3 world;
    for (unsigned corner = 0; corner < 8; ++corner)
        world.include(task.world_from_grid * Point3{corner & 1U ? high.x : low.x,
                                                    corner & 2U ? high.y : low.y,
                                                    corner & 4U ? high.z : low.z});
    return world;
}

} // namespace voroprobe
