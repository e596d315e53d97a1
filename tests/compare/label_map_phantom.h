#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <numeric>

#include "compare/label_contestant.h"
#include "volume/volume.h"

namespace voroprobe
{

//! A label map of one sample per mm, all labels of it asked for.
inline LabelTask label_task(const std::array<std::size_t, 3>& size,
                            const std::function<std::uint8_t(int, int, int)>& label_at)
{
    std::vector<std::uint8_t> samples;
    for (std::size_t k = 0; k < size[2]; ++k)
        for (std::size_t j = 0; j < size[1]; ++j)
            for (std::size_t i = 0; i < size[0]; ++i)
                samples.push_back(label_at(static_cast<int>(i), static_cast<int>(j), static_cast<int>(k)));
    const Volume volume =
        make_volume({.size = size, .spacing = {1, 1, 1}, .direction = {}, .origin = {}}, std::move(samples));
    LabelTask task{.survey = std::make_shared<const LabelSurvey>(volume),
                   .labels = {},
                   .spacing = volume.geometry.spacing,
                   .world_from_grid = volume.geometry.world_from_grid,
                   .voxel = 1.0,
                   .options = {.criteria = {.max_facet_radius = 2.0,
                                            .max_facet_distance = 0.3,
                                            .min_facet_angle_deg = 30.0,
                                            .floor_radius = 0.25,
                                            .reach_lower_bound = 1.0},
                               .smoothing = {.method = SmoothingMethod::kGaussian, .sigma = 1.0}}};
    task.labels.resize(task.survey->labels().size());
    std::iota(task.labels.begin(), task.labels.end(), 0U);
    return task;
}

//! Two blocks of 6 x 6 x 6 voxels side by side, labels 1 and 2, and 3 x 3 x 3 more of label 2 apart.
inline LabelTask three_blocks()
{
    return label_task({26, 12, 12},
                      [](int i, int j, int k) -> std::uint8_t
                      {
                          const bool within = j >= 3 && j < 9 && k >= 3 && k < 9;
                          if (within && i >= 3 && i < 15)
                              return i < 9 ? 1 : 2;
                          return within && i >= 20 && i < 23 && j < 6 && k < 6 ? 2 : 0;
                      });
}

} // namespace voroprobe
