#include "oracles/sparse_lattice.h"

#include <algorithm>
#include <vector>

namespace voroprobe
{
namespace
{

using openvdb::Coord;
using ConstAccessor = openvdb::tree::ValueAccessor<const openvdb::FloatTree, false>;

//! Voxels along the side of a leaf.
constexpr int kLeafSide = static_cast<int>(openvdb::FloatTree::LeafNodeType::DIM);
static_assert(kLeafSide == static_cast<int>(openvdb::MaskTree::LeafNodeType::DIM));

//! Blocks of grid cells, by the lowest, aligned as leaves, that could hold a mixed one: those with a corner
//! in a leaf, and those around tiles on the other side than the background. All other grid cells lie in the
//! background or deep in one tile.
std::vector<Coord> blocks_near_surface(const openvdb::FloatTree& tree, const Level& level)
{
    std::vector<Coord> blocks;
    for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf)
        for (int i = 0; i < 8; ++i)
            blocks.push_back(leaf->origin().offsetBy(i & 1 ? -kLeafSide : 0, i & 2 ? -kLeafSide : 0,
                                                     i & 4 ? -kLeafSide : 0));

    const bool background_inside = level(tree.background()) >= 0.0;
    auto tile = tree.cbeginValueAll();
    tile.setMaxDepth(openvdb::FloatTree::ValueAllCIter::LEAF_DEPTH - 1);
    for (; tile; ++tile)
    {
        if ((level(*tile) >= 0.0) == background_inside)
            continue;
        openvdb::CoordBBox box;
        tile.getBoundingBox(box);
        const Coord low = box.min().offsetBy(-kLeafSide);
        const Coord high = box.max().offsetBy(1 - kLeafSide);
        for (int x = low.x(); x <= high.x(); x += kLeafSide)
            for (int y = low.y(); y <= high.y(); y += kLeafSide)
            {
                const bool on_side = x == low.x() || x == high.x() || y == low.y() || y == high.y();
                for (int z = low.z(); z <= high.z(); z += on_side ? kLeafSide : high.z() - low.z())
                    blocks.emplace_back(x, y, z);
            }
    }
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    return blocks;
}

//! The sides of the 9x9x9 corners of a block's grid cells, z fastest as in a leaf.
class BlockSides
{
public:
    BlockSides(ConstAccessor& values, const Level& level, const Coord& block)
    {
        for (int i = 0; i < 8; ++i)
        {
            const Coord first(i & 4 ? kLeafSide : 0, i & 2 ? kLeafSide : 0, i & 1 ? kLeafSide : 0);
            take_from_node(values, level, block, first);
        }
    }

    [[nodiscard]] bool uniform() const
    {
        return inside_count_ == 0 || inside_count_ == kSide * kSide * kSide;
    }

    [[nodiscard]] bool is_mixed(int x, int y, int z) const
    {
        const int at = index(x, y, z);
        int inside = 0;
        for (const int dx : {0, kSide * kSide})
            for (const int dy : {0, kSide})
                inside += inside_[at + dx + dy] + inside_[at + dx + dy + 1];
        return inside != 0 && inside != 8;
    }

private:
    static constexpr int kSide = kLeafSide + 1;
    static constexpr std::size_t kCount = std::size_t{kSide} * kSide * kSide;

    static int index(int x, int y, int z) { return (x * kSide + y) * kSide + z; }

    //! The corners from `first` on that lie in one node.
    void take_from_node(ConstAccessor& values, const Level& level, const Coord& block, const Coord& first)
    {
        const Coord node = block + first;
        const auto* leaf = values.probeConstLeaf(node);
        const bool tile_inside = leaf == nullptr && level(values.getValue(node)) >= 0.0;
        const Coord count(first.x() ? 1 : kLeafSide, first.y() ? 1 : kLeafSide, first.z() ? 1 : kLeafSide);
        for (int x = 0; x < count.x(); ++x)
            for (int y = 0; y < count.y(); ++y)
                for (int z = 0; z < count.z(); ++z)
                {
                    const auto offset = static_cast<openvdb::Index>((x * kLeafSide + y) * kLeafSide + z);
                    const bool inside = leaf != nullptr ? level(leaf->getValue(offset)) >= 0.0 : tile_inside;
                    inside_[index(first.x() + x, first.y() + y, first.z() + z)] = inside;
                    inside_count_ += inside;
                }
    }

    std::array<std::uint8_t, kCount> inside_{};
    int inside_count_ = 0;
};

std::unique_ptr<const openvdb::MaskTree> mixed_cells(const openvdb::FloatTree& tree, const Level& level)
{
    auto mixed = std::make_unique<openvdb::MaskTree>();
    ConstAccessor values(tree);
    for (const Coord& block : blocks_near_surface(tree, level))
    {
        const BlockSides sides(values, level, block);
        if (sides.uniform())
            continue;
        auto* leaf = mixed->touchLeaf(block);
        for (int x = 0; x < kLeafSide; ++x)
            for (int y = 0; y < kLeafSide; ++y)
                for (int z = 0; z < kLeafSide; ++z)
                    if (sides.is_mixed(x, y, z))
                        leaf->setValueOn(static_cast<openvdb::Index>((x * kLeafSide + y) * kLeafSide + z));
    }
    return mixed;
}

//! Side of the node without leaves that holds a voxel, by the depth of its value: -1 background, 0 tile of
//! the root, ...
int node_side(int depth)
{
    using Root = openvdb::MaskTree::RootNodeType;
    using Upper = Root::ChildNodeType;
    using Lower = Upper::ChildNodeType;
    return static_cast<int>(depth <= 0 ? Upper::DIM : depth == 1 ? Lower::DIM : Lower::ChildNodeType::DIM);
}

//! Where the samples of `box` lie.
LatticeFrame frame_of(const openvdb::CoordBBox& box, const Vec3& step)
{
    const Coord& first = box.min();
    const Coord count = box.dim();
    return {{count.x(), count.y(), count.z()},
            step,
            {step.x * first.x(), step.y * first.y(), step.z * first.z()}};
}

class SparseHeightField final : public HeightField
{
public:
    SparseHeightField(openvdb::FloatGrid::ConstPtr grid, const Level& level, const openvdb::CoordBBox& box,
                      const Vec3& step)
        : grid_(std::move(grid)), level_(level), box_(box), step_(step)
    {
    }

    [[nodiscard]] LatticeFrame frame() const override { return frame_of(box_, step_); }

    void read_slice(std::size_t k, std::span<double> heights) const override
    {
        ConstAccessor values(grid_->tree());
        const int z = box_.min().z() + static_cast<int>(k);
        const Coord first = box_.min() & ~(kLeafSide - 1);
        for (int y = first.y(); y <= box_.max().y(); y += kLeafSide)
            for (int x = first.x(); x <= box_.max().x(); x += kLeafSide)
                read_block(values, {x, y, z}, heights);
    }

private:
    //! The part of a slice in the node that holds `corner`, its lowest of this slice.
    void read_block(ConstAccessor& values, const Coord& corner, std::span<double> heights) const
    {
        const auto* leaf = values.probeConstLeaf(corner);
        const double of_tile = leaf == nullptr ? level_(values.getValue(corner)) : 0.0;
        const Coord low = Coord::maxComponent(corner, box_.min());
        const Coord high = Coord::minComponent(corner.offsetBy(kLeafSide - 1), box_.max());
        const auto columns = static_cast<std::size_t>(box_.dim().x());
        for (int y = low.y(); y <= high.y(); ++y)
        {
            double* row = heights.data() + static_cast<std::size_t>(y - box_.min().y()) * columns;
            for (int x = low.x(); x <= high.x(); ++x)
                row[x - box_.min().x()] =
                    leaf == nullptr ? of_tile : level_(leaf->getValue(Coord(x, y, corner.z())));
        }
    }

    openvdb::FloatGrid::ConstPtr grid_;
    Level level_;
    openvdb::CoordBBox box_;
    Vec3 step_;
};

} // namespace

SparseLattice::SparseLattice(openvdb::FloatGrid::ConstPtr grid, const Level& level,
                             const openvdb::CoordBBox& box, const Vec3& step)
    : grid_(std::move(grid)), level_(level), box_(box), step_(step), mixed_(mixed_cells(grid_->tree(), level))
{
}

LatticeFrame SparseLattice::frame() const
{
    return frame_of(box_, step_);
}

CellCorners SparseLattice::Reader::corners(const GridCell& cell)
{
    const Coord first = coord(cell);
    CellCorners corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = level_(values_.getValue(first.offsetBy(i & 1U ? 1 : 0, i & 2U ? 1 : 0, i & 4U ? 1 : 0)));
    return corners;
}

bool SparseLattice::Reader::is_first_corner_inside(const GridCell& cell)
{
    return level_(values_.getValue(coord(cell))) >= 0.0;
}

bool SparseLattice::Reader::is_mixed(const GridCell& cell)
{
    return mixed_.isValueOn(coord(cell));
}

std::optional<GridCellBox> SparseLattice::Reader::clear_box(const GridCell& cell)
{
    const Coord here = coord(cell);
    if (mixed_.probeConstLeaf(here) != nullptr)
        return std::nullopt;
    const int side = node_side(mixed_.getValueDepth(here));
    const Coord low = (here & ~(side - 1)) - origin_;
    return GridCellBox{{low.x(), low.y(), low.z()},
                       {low.x() + side - 1, low.y() + side - 1, low.z() + side - 1}};
}

bool SparseLattice::Reader::any_mixed(const GridCellBox& box)
{
    const openvdb::CoordBBox wanted(coord(box.min), coord(box.max));
    const auto any_in_leaf = [&](const openvdb::MaskTree::LeafNodeType& leaf)
    {
        for (auto on = leaf.cbeginValueOn(); on; ++on)
            if (wanted.isInside(on.getCoord()))
                return true;
        return false;
    };

    // By look-ups where the box is small, by the list of leaves where it is large.
    const Coord low = wanted.min() & ~(kLeafSide - 1);
    const Coord extent = wanted.max() - low;
    const auto blocks_along = [](int voxels) { return static_cast<std::uint64_t>(voxels) / kLeafSide + 1; };
    // At most 2^27 along each axis; the product of three may pass 64 bits, hence the order of the tests.
    const std::uint64_t leaf_count = mixed_.tree().leafCount();
    const std::uint64_t blocks_xy = blocks_along(extent.x()) * blocks_along(extent.y());
    const bool large = blocks_xy > leaf_count || blocks_xy * blocks_along(extent.z()) > leaf_count;
    if (large)
    {
        for (auto leaf = mixed_.tree().cbeginLeaf(); leaf; ++leaf)
            if (wanted.hasOverlap(leaf->getNodeBoundingBox()) && any_in_leaf(*leaf))
                return true;
        return false;
    }
    for (int x = low.x(); x <= wanted.max().x(); x += kLeafSide)
        for (int y = low.y(); y <= wanted.max().y(); y += kLeafSide)
            for (int z = low.z(); z <= wanted.max().z(); z += kLeafSide)
                if (const auto* leaf = mixed_.probeConstLeaf(Coord(x, y, z));
                    leaf != nullptr && any_in_leaf(*leaf))
                    return true;
    return false;
}

std::unique_ptr<HeightField> make_sparse_height_field(openvdb::FloatGrid::ConstPtr grid, const Level& level,
                                                      const openvdb::CoordBBox& box, const Vec3& step)
{
    return std::make_unique<SparseHeightField>(std::move(grid), level, box, step);
}

} // namespace voroprobe
