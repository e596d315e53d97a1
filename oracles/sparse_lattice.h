#pragma once

#include <memory>
#include <optional>

#include <openvdb/openvdb.h>
#include <openvdb/tree/ValueAccessor.h>

#include "oracles/lattice_oracle.h"
#include "volume/height_field.h"
#include "volume/level.h"

namespace voroprobe
{

//! The values of a float grid as a field over a box of its index space. A second tree of the same layout
//! holds one bit per grid cell, named by its lowest corner: mixed or not; where it has no leaf there is no
//! surface, and the walk jumps the node. Memory beside the grid: 100 bytes per 8x8x8 grid cells near the
//! surface.
class SparseLattice
{
public:
    //! Reads values by accessors that cache the way to the last one; one per call, registered nowhere.
    class Reader
    {
    public:
        explicit Reader(const SparseLattice& lattice)
            : level_(lattice.level_), origin_(lattice.box_.min()), values_(lattice.grid_->tree()),
              mixed_(*lattice.mixed_)
        {
        }

        [[nodiscard]] CellCorners corners(const GridCell& cell);
        [[nodiscard]] bool is_first_corner_inside(const GridCell& cell);
        [[nodiscard]] bool is_mixed(const GridCell& cell);
        [[nodiscard]] std::optional<GridCellBox> clear_box(const GridCell& cell);
        [[nodiscard]] bool any_mixed(const GridCellBox& box);

    private:
        [[nodiscard]] openvdb::Coord coord(const GridCell& cell) const
        {
            return origin_.offsetBy(cell[0], cell[1], cell[2]);
        }

        Level level_;
        openvdb::Coord origin_;
        openvdb::tree::ValueAccessor<const openvdb::FloatTree, false> values_;
        openvdb::tree::ValueAccessor<const openvdb::MaskTree, false> mixed_;
    };

    //! `box`: the voxels taken for samples, at least 2 along each axis. `step`: scan units per index,
    //! negative where the oracle's axis runs against the grid's. \pre All values are finite and none equals
    //! the level's isovalue. Cost: one pass over the leaves, and over the surfaces of inner tiles.
    SparseLattice(openvdb::FloatGrid::ConstPtr grid, const Level& level, const openvdb::CoordBBox& box,
                  const Vec3& step);

    [[nodiscard]] LatticeFrame frame() const;
    [[nodiscard]] Reader reader() const { return Reader(*this); }

private:
    openvdb::FloatGrid::ConstPtr grid_;
    Level level_;
    openvdb::CoordBBox box_;
    Vec3 step_;
    std::unique_ptr<const openvdb::MaskTree> mixed_;
};

//! The values of a float grid over a box as heights, slices across z; arguments as for SparseLattice. A slice
//! is made dense while it is read. Cost of a slice: linear in the box, one look-up per 8x8 samples.
std::unique_ptr<HeightField> make_sparse_height_field(openvdb::FloatGrid::ConstPtr grid, const Level& level,
                                                      const openvdb::CoordBBox& box, const Vec3& step);

} // namespace voroprobe
