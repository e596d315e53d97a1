#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "labels/label_survey.h"
#include "mesher/meshing_options.h"
#include "volume/inventory.h"

namespace voroprobe
{

//! Vertices that meshing, certificate and output find room for in this machine's memory.
std::size_t vertices_in_memory();

//! Refuses a size that is out of reach before the work begins. A face covers no more of the surface than the
//! equilateral triangle in a circle of radius `max_facet_radius`, and a surface has at least the area of the
//! sphere around what it encloses. `voxel_volume`: cubed scan units. \throw UsageError which says what would
//! do.
void check_size(const MeshingOptions& options, const Inventory& inventory, double voxel_volume);

//! The same for labels, of which as many are in memory at once as there are threads. `labels`: places in
//! survey.labels().
void check_size(const MeshingOptions& options, const LabelSurvey& survey,
                std::span<const std::uint32_t> labels, double voxel_volume, std::size_t threads);

} // namespace voroprobe
