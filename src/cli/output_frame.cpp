#include "cli/output_frame.h"

namespace voroprobe
{

namespace
{

//! Left and posterior become right and anterior; a rotation by half a turn about the axis to the head.
constexpr AffineTransform kRasFromLps{{{Vec3{-1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}}, {0, 0, 0}};

} // namespace

std::string_view frame_name(OutputFrame frame)
{
    switch (frame)
    {
    case OutputFrame::kLps:
        return "lps";
    case OutputFrame::kRas:
        return "ras";
    case OutputFrame::kIndex:
        return "index";
    }
    return {};
}

std::string_view frame_unit(OutputFrame frame)
{
    return frame == OutputFrame::kIndex ? "voxel" : "mm";
}

AffineTransform output_from_grid(OutputFrame frame, const GridPlacement& placement)
{
    switch (frame)
    {
    case OutputFrame::kLps:
        return placement.world_from_grid;
    case OutputFrame::kRas:
        return kRasFromLps * placement.world_from_grid;
    case OutputFrame::kIndex:
        return placement.source_index_from_grid;
    }
    return {};
}

} // namespace voroprobe
