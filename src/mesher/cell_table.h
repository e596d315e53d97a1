#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesher/delaunay.h"

namespace voroprobe
{

//! The Delaunay cells by number, in the order of memory, with what the regions are about side by side:
//! sweeps over all cells then touch a tenth of the memory that they take. While one is in use no cell is made
//! or destroyed, and DelaunayCellData::scratch holds the numbers.
class CellTable
{
public:
    using Number = std::uint32_t;

    //! Cost: O(Delaunay cells). The triangulation must outlive the object.
    explicit CellTable(const Triangulation& triangulation);

    [[nodiscard]] Number size() const { return static_cast<Number>(cells_.size()); }
    [[nodiscard]] DelaunayCell cell(Number c) const { return cells_[c]; }
    [[nodiscard]] const std::array<Number, 4>& neighbors(Number c) const { return neighbors_[c]; }
    [[nodiscard]] bool is_infinite(Number c) const { return is_infinite_[c]; }
    [[nodiscard]] Region region(Number c) const { return regions_[c]; }

    //! The cell's own too.
    void set_region(Number c, Region region)
    {
        regions_[c] = region;
        cells_[c]->info().region = region;
    }

    //! Takes the regions from the cells again, after others have changed them.
    void refresh_regions();

private:
    std::vector<DelaunayCell> cells_;
    std::vector<std::array<Number, 4>> neighbors_;
    std::vector<bool> is_infinite_;
    std::vector<Region> regions_;
};

} // namespace voroprobe
