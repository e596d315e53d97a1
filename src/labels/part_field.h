#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "labels/part_groups.h"
#include "volume/volume.h"

namespace voroprobe
{

//! How samples that touch at edges or corners of voxels are joined, where smoothing does not: both keep all
//! parts and cavities.
enum class NeckRule
{
    kRaiseOutside, //!< samples outside come nearer to 0: slim necks, but gaps and cavities beside them may
                   //!< get small
    kLiftInside    //!< samples inside get farther from 0: gaps stay open, small parts may get too large
};

//! A field whose zero set encloses the parts of a mask, each by itself, whatever smoothing made of them.
//!
//! - Every sample stays on its side: heights of the wrong sign, or too near to 0 to be meshed, are put right.
//!   So the surface passes between the samples inside and those outside, and no part, however thin, is lost.
//! - Parts and cavities are those of the mask: samples inside are joined through faces, edges and corners of
//!   voxels (26 neighbours), samples outside through faces (6). Where the trilinear interpolant joins samples
//!   otherwise, the neck rule joins them. Then each part has one outer surface.
//! - Every part has a height of its own added, so that it can be given a volume.
class PartField
{
public:
    //! `smoothed`: heights of the samples of the mask, between -0.5 and 0.5. `spacing`: scan units. Cost: one
    //! pass over the samples. \throw InputError where there are 2^32 of them or more.
    PartField(PartMask mask, const Vec3& spacing, std::span<const float> smoothed);

    [[nodiscard]] std::size_t part_count() const { return mask_.part_count; }
    [[nodiscard]] const PartMask& mask() const { return mask_; }

    //! At first kRaiseOutside. Keeps the shifts.
    void set_neck_rule(NeckRule rule);

    //! Parts of the mask without any sample that smoothing left inside.
    [[nodiscard]] std::size_t parts_restored() const { return parts_restored_; }

    //! Shifts the heights of each part so that its volume becomes `wanted`, cubic scan units, as nearly as
    //! its samples allow. Cost: some passes over the grid cells that the surface passes through.
    void fit_volumes(std::span<const double> wanted);

    //! The volume within the outer surface of each part but for its cavities, cubic scan units; to about a
    //! thousandth of what lies in the grid cells on the surface.
    [[nodiscard]] const std::vector<double>& volumes() const { return volumes_; }

    //! The heights, float32, to be meshed at 0; the frame is that of the mask: its first sample is the
    //! origin.
    [[nodiscard]] Volume volume() const;

private:
    struct MixedCell
    {
        std::uint32_t first_corner; //!< its sample
        std::uint32_t part;         //!< that of its corners inside
        bool simple;                //!< the signs alone settle which corners are joined
    };
    struct BandSample
    {
        std::uint32_t sample;
        float smoothed;
    };

    void find_mixed_cells();
    void find_band(std::span<const float> smoothed);
    void count_restored(std::span<const float> smoothed);
    void apply_shifts();
    void shift_outside_samples();
    void thicken_thin_samples();
    void join_as_voxels();
    void measure();
    [[nodiscard]] std::size_t corner(const MixedCell& cell, std::size_t c) const
    {
        return cell.first_corner + corner_offset_[c];
    }

    PartMask mask_;
    Vec3 spacing_;
    std::array<std::size_t, 8> corner_offset_{};
    std::vector<MixedCell> mixed_cells_;
    std::vector<BandSample> band_;         //!< corners of mixed cells
    std::vector<std::size_t> whole_cells_; //!< by part: grid cells with all corners inside
    std::vector<double> shifts_;           //!< by part
    std::vector<float> heights_;
    std::vector<double> volumes_; //!< by part
    NeckRule neck_rule_ = NeckRule::kRaiseOutside;
    std::size_t parts_restored_ = 0;
};

} // namespace voroprobe
