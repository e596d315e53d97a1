#include "oracles/vdb_oracle.h"

#include <openvdb/tools/Count.h>
#include <openvdb/tools/SignedFloodFill.h>

#include "oracles/sparse_lattice.h"
#include "oracles/vdb_file.h"
#include "support/error.h"
#include "support/number_text.h"

namespace voroprobe
{
namespace
{

//! Largest cosine between two axes of a grid that still count as orthogonal; they are then made exactly so.
constexpr double kSkewTolerance = 1e-3;

//! Boxes of up to so many voxels are passed over for an inventory: a minute of work.
constexpr double kMostVoxelsListed = 4e9;

//! Largest index, either sign, so that extents and their sums stay within 32 bits.
constexpr int kMaxIndex = 1 << 29;

//! Calls `visit` with every value of a tree, active or not, as a modifiable float: tiles, then voxels.
template <class Visit>
void for_each_value(openvdb::FloatTree& tree, Visit visit)
{
    auto tile = tree.beginValueAll();
    tile.setMaxDepth(openvdb::FloatTree::ValueAllIter::LEAF_DEPTH - 1);
    for (; tile; ++tile)
    {
        float value = *tile;
        visit(value);
        tile.setValue(value);
    }
    for (auto leaf = tree.beginLeaf(); leaf; ++leaf)
        for (openvdb::Index i = 0; i < openvdb::FloatTree::LeafNodeType::SIZE; ++i)
        {
            float value = leaf->getValue(i);
            visit(value);
            leaf->setValueOnly(i, value);
        }
}

//! Puts the axes of the grid into an orthonormal right-handed frame. Returns scan units per index along each,
//! negative along the first where the grid is left-handed. \throw InputError for transforms that do not allow
//! it.
Vec3 orient(const openvdb::FloatGrid& grid, const std::string& where, AffineTransform& world_from_grid)
{
    if (!grid.transform().isLinear())
        throw InputError(where + ": frustum or other nonlinear transform, expected a linear one");

    // OpenVDB multiplies row vectors from the left: the rows are the images of the axes.
    const openvdb::Mat4R m = grid.transform().baseMap()->getAffineMap()->getMat4();
    std::array<Vec3, 3> axes;
    Vec3 step;
    for (int a = 0; a < 3; ++a)
    {
        const Vec3 image{m(a, 0), m(a, 1), m(a, 2)};
        const auto axis = static_cast<std::size_t>(a);
        step[axis] = norm(image);
        axes[axis] = image / step[axis];
        if (!(step[axis] > 0.0) || !is_finite(axes[axis]))
            throw InputError(where + ": voxel size " + std::to_string(step[axis]) + " along axis " +
                             std::to_string(a) + ", expected a positive number");
    }
    const double skew = std::max(
        {std::abs(dot(axes[0], axes[1])), std::abs(dot(axes[1], axes[2])), std::abs(dot(axes[2], axes[0]))});
    if (skew > kSkewTolerance)
        throw InputError(where + ": sheared transform (cosine between axes " + std::to_string(skew) +
                         "), expected orthogonal axes");

    const bool left_handed = dot(axes[0], cross(axes[1], axes[2])) < 0.0;
    const Vec3 z = axes[2];
    const Vec3 y = normalized(axes[1] - dot(axes[1], z) * z);
    world_from_grid = {{{cross(y, z), y, z}}, {m(3, 0), m(3, 1), m(3, 2)}};
    return {left_handed ? -step.x : step.x, step.y, step.z};
}

//! The active voxels and one more on every side. \throw InputError where there are none, or absurdly far
//! ones.
openvdb::CoordBBox domain_of(const openvdb::FloatGrid& grid, const std::string& where)
{
    openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
    if (box.empty())
        throw InputError(where + ": no active voxel");
    const openvdb::CoordBBox allowed(openvdb::Coord(-kMaxIndex), openvdb::Coord(kMaxIndex));
    if (!allowed.isInside(box))
        throw InputError(where + ": voxels with an index beyond " + std::to_string(kMaxIndex));
    box.expand(1);
    return box;
}

std::string name_of(openvdb::GridClass grid_class)
{
    return grid_class == openvdb::GRID_LEVEL_SET    ? "level set"
           : grid_class == openvdb::GRID_FOG_VOLUME ? "fog volume"
                                                    : "unknown";
}

//! The inside of a level set is known by the sign of its inactive values. Programs that never look there
//! leave them positive.
void mark_inside_of_level_set(openvdb::FloatGrid& grid)
{
    bool marked = false;
    for (auto value = grid.cbeginValueOff(); value && !marked; ++value)
        marked = *value < 0.0F;
    if (!marked && grid.background() > 0.0F)
        openvdb::tools::signedFloodFill(grid.tree());
}

//! Replaces values that are not finite. Returns how to read the grid as a field.
Level prepare_values(openvdb::FloatGrid& grid, const std::string& where, VdbSurface& surface)
{
    if (!std::isfinite(grid.background()))
        throw InputError(where + ": background " + std::to_string(grid.background()) +
                         ", expected a finite number");
    LevelSurvey survey(surface.isovalue, surface.inside);
    survey.include(grid.background());
    for_each_value(grid.tree(), [&](const float& value) { survey.include(value); });
    if (survey.not_finite() > 0)
    {
        const auto outside = static_cast<float>(survey.outside());
        for_each_value(grid.tree(), [&](float& value) { value = std::isfinite(value) ? value : outside; });
        surface.warnings.push_back(where + ": " + std::to_string(survey.not_finite()) +
                                   " values are not finite and taken for outside");
    }
    return survey.level();
}

//! Everything but the oracle.
void describe(const openvdb::FloatGrid& grid, VdbSurface& surface)
{
    surface.grid_name = grid.getName();
    surface.grid_class = name_of(grid.getGridClass());
    surface.stored_type = grid.saveFloatAsHalf() ? "float16" : "float32";
    const openvdb::Coord size = grid.evalActiveVoxelDim();
    surface.active_size = {static_cast<std::size_t>(size.x()), static_cast<std::size_t>(size.y()),
                           static_cast<std::size_t>(size.z())};
    surface.min = std::numeric_limits<double>::infinity();
    surface.max = -std::numeric_limits<double>::infinity();
    for (auto value = grid.cbeginValueOn(); value; ++value)
        if (std::isfinite(*value))
        {
            surface.min = std::min(surface.min, static_cast<double>(*value));
            surface.max = std::max(surface.max, static_cast<double>(*value));
        }
}

} // namespace

VdbSurface read_vdb_surface(const std::filesystem::path& path, const VdbOptions& options)
{
    const openvdb::FloatGrid::Ptr grid = read_float_grid(path, options.grid);
    const std::string where = path.string() + ", grid \"" + grid->getName() + "\"";
    const openvdb::CoordBBox domain = domain_of(*grid, where);
    const bool level_set = grid->getGridClass() == openvdb::GRID_LEVEL_SET;
    if (level_set)
        mark_inside_of_level_set(*grid);

    VdbSurface surface{};
    describe(*grid, surface);
    if (!(surface.min <= surface.max))
        throw InputError(where + ": no finite value");
    surface.isovalue = options.isovalue.value_or(level_set ? 0.0 : 0.5 * surface.max);
    surface.inside = options.inside.value_or(level_set ? InsideIs::kBelow : InsideIs::kAbove);
    if (!std::isfinite(surface.isovalue))
        throw UsageError("isovalue " + std::to_string(surface.isovalue) + ", expected a finite number");

    const Vec3 step = orient(*grid, where, surface.world_from_grid);
    surface.voxel_size = std::min({std::abs(step.x), step.y, step.z});
    surface.source_index_from_grid.linear = {
        {Vec3{1.0 / step.x, 0, 0}, Vec3{0, 1.0 / step.y, 0}, Vec3{0, 0, 1.0 / step.z}}};
    const Level level = prepare_values(*grid, where, surface);
    surface.heights = make_sparse_height_field(grid, level, domain, step);
    const double voxels = static_cast<double>(domain.volume());
    if (options.regions == VdbRegions::kListed && voxels > kMostVoxelsListed)
        surface.warnings.push_back("the box of the grid holds " + number_text(voxels) +
                                   " voxels, its surfaces are listed up to " +
                                   number_text(kMostVoxelsListed) + ": none is certain to be found");
    else if (options.regions == VdbRegions::kListed)
        surface.inventory = std::make_shared<const Inventory>(*surface.heights, options.threads);
    surface.oracle = std::make_unique<LatticeOracle<SparseLattice>>(
        SparseLattice(grid, level, domain, step), LatticeRegions{surface.inventory, surface.heights});
    return surface;
}

} // namespace voroprobe
