#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "labels/label_delaunay.h"
#include "labels/label_survey.h"

namespace voroprobe
{

//! Which pieces the labels of a triangulation's cells make, beside the parts that their label map has.
class LabelPieces
{
public:
    //! Both must outlive it. `spacing`: of the samples, scan units.
    LabelPieces(LabelDelaunay& delaunay, const LabelSurvey& survey, const Vec3& spacing)
        : delaunay_(delaunay), survey_(survey), spacing_(spacing)
    {
    }

    //! Those of `parts` (places in LabelSurvey::parts()) that no Delaunay cell belongs to.
    [[nodiscard]] std::vector<std::uint32_t> parts_without_cell(std::span<const std::uint32_t> parts) const;

    //! Slivers make pieces of a label that none of its parts needs: all but the largest piece of each part,
    //! and bits of background. Their cells get the label around them that they share the largest facet with.
    //! \return how often a cell changed its label.
    std::size_t dissolve_crumbs();

    //! Parts that have no piece, and parts whose piece is that of a larger one.
    struct Faults
    {
        std::vector<std::uint32_t> missing;
        std::vector<std::uint32_t> merged;
    };
    [[nodiscard]] Faults faults(std::span<const std::uint32_t> parts);

private:
    //! Delaunay cells of one label that are joined through facets.
    struct Piece
    {
        double volume = 0.0;
        PartitionLabel label = 0;
        bool outer = false;                             //!< it reaches to infinity
        std::map<std::uint32_t, double> volume_of_part; //!< by place
    };
    using Pieces = std::map<std::uint32_t, Piece>; //!< by the number that their cells have

    [[nodiscard]] std::optional<std::uint32_t> part_of(const LabelledCellData& cell) const;
    [[nodiscard]] Pieces find_pieces();
    [[nodiscard]] static std::map<std::uint32_t, std::uint32_t> pieces_of_parts(const Pieces& pieces);
    [[nodiscard]] std::size_t dissolve_once();
    [[nodiscard]] static PartitionLabel label_around(LabelCell cell);

    LabelDelaunay& delaunay_;
    const LabelSurvey& survey_;
    Vec3 spacing_;
};

} // namespace voroprobe
