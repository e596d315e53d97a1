#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/box3.h"
#include "geometry/segment3.h"
#include "labels/label_survey.h"

namespace voroprobe
{

//! A label's place in LabelSurvey::labels(), plus one; 0 where there is none of the labels asked for.
using PartitionLabel = std::uint32_t;

//! All labels of a label map smoothed together: at every point one label, so that neighbours neither overlap
//! nor gape.
//!
//! Each label has at a point the sum of the weights of its voxels, which fall off as the cubic B-spline
//! (standard deviation 0.58 voxels); the label with the largest sum has the point. Voxels that would so be
//! overruled at their own center weigh more, up to kMostWeight: walls and specks of one voxel stay. Frame:
//! grid, scan units. Immutable: may be asked from several threads at once.
class LabelPartition
{
public:
    //! `labels`: places in survey.labels(); the others count as background. `spacing`: scan units. Memory: 5
    //! bytes a sample. Cost: a few passes over the samples, 64 neighbours for each near a border of labels.
    LabelPartition(const LabelSurvey& survey, std::span<const std::uint32_t> labels, const Vec3& spacing);

    //! Gives parts the volume of their voxels, within some percent, by a common factor of their weights.
    //! Voxels that are strengthened only until their centers are their own have a third of it.
    //! `parts`: places in survey.parts(); `survey`: that of the constructor. Cost: for each of their voxels
    //! and those next to them, and each of some rounds, 27 times 64 samples.
    void balance(const LabelSurvey& survey, std::vector<std::uint32_t> parts);

    //! The box of the samples, and a margin of two samples in which there is no label.
    [[nodiscard]] Box3 domain() const;

    //! 0 beyond the domain.
    [[nodiscard]] PartitionLabel label(const Point3& p) const;

    //! Where the label changes along a segment, and to what. Places closer together than a third of a voxel
    //! may be taken for none.
    struct Change
    {
        Point3 point;
        PartitionLabel after;
    };

    //! All changes from source to target, into `changes` (cleared first). Cost: proportional to the samples
    //! met, quick where all around is one label.
    void find_changes(const Segment3& segment, std::vector<Change>& changes) const;

    //! Voxels that their label does not have in spite of kMostWeight.
    [[nodiscard]] std::size_t voxels_overruled() const { return voxels_overruled_; }

    //! Of a voxel.
    [[nodiscard]] Point3 center(const SampleIndex& voxel) const
    {
        return {spacing_.x * voxel[0], spacing_.y * voxel[1], spacing_.z * voxel[2]};
    }

private:
    static constexpr double kMostWeight = 7.5;

    //! Labels around a point and their sums.
    struct Ballot;

    void fill_samples(const LabelSurvey& survey, std::span<const std::uint32_t> labels);
    void find_mixed_blocks();
    void strengthen_overruled();
    [[nodiscard]] double share_of_volume(const LabelSurvey& survey, std::uint32_t part) const;
    void scale_weights(const LabelSurvey& survey, std::uint32_t part, double factor);
    [[nodiscard]] std::size_t at(int i, int j, int k) const;
    [[nodiscard]] bool is_block_mixed(const SampleIndex& block) const;
    [[nodiscard]] Ballot ballot(const Point3& p_padded) const;
    [[nodiscard]] Point3 to_padded(const Point3& p) const;
    [[nodiscard]] double clear_length(const Point3& p_padded, const Vec3& step) const;
    [[nodiscard]] Point3 locate(Point3 before, Point3 after, PartitionLabel label_before) const;

    Vec3 spacing_;
    SampleIndex size_{};                 //!< padded: kPadding samples more on every side
    std::vector<PartitionLabel> labels_; //!< by padded sample
    std::vector<std::uint8_t> weights_;  //!< in 1/32
    SampleIndex block_count_{};
    std::vector<bool> block_mixed_; //!< blocks of samples with two labels in them or next to them
    std::size_t voxels_overruled_ = 0;
};

} // namespace voroprobe
