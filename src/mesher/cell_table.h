#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesher/delaunay.h"
#include "support/workers.h"

namespace voroprobe
{

//! The Delaunay cells by number, as a rule in the order of memory, with what the regions are about side by
//! side: sweeps over all cells then touch a tenth of the memory that they take.
//! DelaunayCellData::scratch holds the numbers as long as the table is in use.
class CellTable
{
public:
    using Number = std::uint32_t;

    //! Cost: O(Delaunay cells). The triangulation must outlive the object.
    CellTable(const Triangulation& triangulation, const Workers& workers);

    [[nodiscard]] Number size() const { return static_cast<Number>(cells_.size()); }
    [[nodiscard]] DelaunayCell cell(Number c) const { return cells_[c]; }
    [[nodiscard]] const std::array<Number, 4>& neighbors(Number c) const { return neighbors_[c]; }
    //! VertexData::index of each; of the infinite vertex anything.
    [[nodiscard]] const std::array<std::uint32_t, 4>& corners(Number c) const { return corners_[c]; }
    [[nodiscard]] bool is_infinite(Number c) const { return is_infinite_[c]; }
    [[nodiscard]] Region region(Number c) const { return regions_[c]; }
    static Number number(DelaunayCell delaunay_cell) { return delaunay_cell->info().scratch; }

    //! A cell and the region it had before.
    struct Change
    {
        Number cell;
        Region former;
    };

    //! The cell's own too. Noted in changes().
    void set_region(Number c, Region region);

    //! In their order, as far as the cells are still there; a cell may be in it more than once.
    [[nodiscard]] const std::vector<Change>& changes() const { return changes_; }

    //! Undoes all but the first `count` changes, the last one first.
    void undo_changes_after(std::size_t count);

    //! Gives the changed cells themselves the regions that they had at first, for refinement to go on; the
    //! table keeps what they were given, until update().
    void give_back_regions();

    //! Takes in what insertions have done. New cells take the numbers of those that are gone, or further
    //! ones, and are returned; the other ones that were changed have their regions from the table again.
    //! Nullopt where there are fewer cells than before, which is rare: then the table is of no more use.
    //! \pre All cells have the regions that they had at first. Cost: O(vertices), and the new cells.
    std::optional<std::vector<Number>> update();

private:
    [[nodiscard]] bool is_current(Number c) const;
    std::vector<DelaunayCell> take_new_cells();
    std::vector<Number> forget_gone_cells(const std::vector<DelaunayCell>& made);
    void make_room_for(std::size_t count);
    void put(Number c, DelaunayCell delaunay_cell);

    const Triangulation* triangulation_;
    std::size_t vertices_seen_ = 0; //!< VertexData::index of later ones runs from here
    std::vector<DelaunayCell> cells_;
    std::vector<std::array<Number, 4>> neighbors_;
    std::vector<std::array<std::uint32_t, 4>> corners_;
    std::vector<bool> is_infinite_;
    std::vector<Region> regions_;
    std::vector<Change> changes_;
};

} // namespace voroprobe
