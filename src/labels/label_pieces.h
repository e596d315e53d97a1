#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "labels/cavity_labels.h"
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

    //! Parts that have no piece, parts whose piece is that of a larger one, and parts of several pieces.
    struct Faults
    {
        std::vector<std::uint32_t> missing;
        std::vector<std::uint32_t> merged;
        std::vector<std::uint32_t> in_pieces;
    };
    [[nodiscard]] Faults faults(std::span<const std::uint32_t> parts);

    //! How many cavities of each label of the label map it encloses, by its place in LabelSurvey::labels(),
    //! plus one: bits of everything else, joined through facets. `apart`: whose labels the cells have. Cost:
    //! labels with cavities times pieces.
    [[nodiscard]] std::vector<std::size_t> count_cavities(const CavityLabels& apart);

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

    //! Pieces by consecutive numbers, and which of them share facets.
    struct PieceGraph
    {
        std::vector<Piece> pieces;
        std::set<std::pair<std::uint32_t, std::uint32_t>> contacts;
        std::uint32_t outer = 0;
    };
    [[nodiscard]] PieceGraph piece_graph();

    LabelDelaunay& delaunay_;
    const LabelSurvey& survey_;
    Vec3 spacing_;
};

} // namespace voroprobe
