#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "labels/index_box.h"
#include "support/union_find.h"
#include "volume/volume.h"

namespace voroprobe
{

//! The number that a label map gives a structure. 0 is the background and no label.
using LabelValue = std::int64_t;

//! A part of a label: its samples that are connected through faces, edges or corners of voxels (26
//! neighbours).
struct LabelPart
{
    std::uint32_t label; //!< its place in LabelSurvey::labels()
    std::size_t voxels = 0;
    IndexBox box;
    SampleIndex first_voxel; //!< in the order of memory
};

struct SurveyedLabel
{
    LabelValue value;
    std::size_t voxels = 0;
    IndexBox box;
    std::vector<std::uint32_t> parts; //!< places in LabelSurvey::parts(), ascending
};

//! A row of samples of one part, from `first` to before `end`.
struct LabelRun
{
    std::int32_t first;
    std::int32_t end;
    std::uint32_t part;
};

//! What a label map holds: its labels and their parts, and of every sample the part it belongs to.
//!
//! Two voxels of a label that share a face, an edge or a corner belong to one part; that is how parts of
//! segmentations are counted here, everywhere. Memory: 12 bytes per run of equal labels along x; the volume
//! is not needed any more.
class LabelSurvey
{
public:
    //! Cost: one pass over the samples, near-linear in the runs. \throw InputError where a sample is not a
    //! whole number, or too large for a neighbouring one to be told from it (2^53), with its place in the
    //! file; for 2^32 runs or more.
    explicit LabelSurvey(const Volume& volume);

    //! By ascending value.
    [[nodiscard]] const std::vector<SurveyedLabel>& labels() const { return labels_; }

    //! In the order of their first voxels.
    [[nodiscard]] const std::vector<LabelPart>& parts() const { return parts_; }

    [[nodiscard]] const std::array<int, 3>& size() const { return size_; }

    //! The runs of the row of samples (., j, k), ascending; none for rows beyond the border.
    [[nodiscard]] std::span<const LabelRun> row(int j, int k) const;

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    void join_touching(UnionFind& sets, const std::vector<LabelValue>& value_of_run) const;
    void list_parts(const std::vector<LabelValue>& value_of_run);
    void list_labels(const std::vector<LabelValue>& value_of_part);

    std::array<int, 3> size_{};
    std::vector<LabelRun> runs_;
    std::vector<std::size_t> row_begin_;
    std::vector<LabelPart> parts_;
    std::vector<SurveyedLabel> labels_;
};

} // namespace voroprobe
