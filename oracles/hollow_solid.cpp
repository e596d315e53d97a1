#include "oracles/hollow_solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <openvdb/openvdb.h>
#include <openvdb/tools/Composite.h>
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/LevelSetFilter.h>
#include <openvdb/tools/LevelSetRebuild.h>
#include <openvdb/tools/LevelSetUtil.h>
#include <openvdb/tools/MeshToVolume.h>
#include <openvdb/tools/SignedFloodFill.h>

#include "mesh/measures.h"
#include "oracles/lattice_oracle.h"
#include "oracles/sparse_lattice.h"
#include "support/error.h"
#include "support/memory.h"
#include "support/number_text.h"
#include "volume/height_field.h"

namespace voroprobe
{

namespace
{

//! Voxels on either side of a surface that a level set keeps.
constexpr float kBand = 4.0F;

//! Hollows are opened by a ball of this radius, voxels.
constexpr double kOpening = 1.5;

//! A drain is drilled so far beyond the outside, voxels.
constexpr double kBelow = 4.0;

//! At the peak, by voxels kept: measured from 0.2 to 0.03 mm on a mesh of 60 mm, 13 to 20.
constexpr double kBytesPerVoxel = 20.0;

//! What OpenVDB asks of a mesh. Its frame is that of indices.
class IndexedMesh
{
public:
    IndexedMesh(const TriangleMesh& mesh, double voxel) : mesh_(mesh), voxel_(voxel) {}

    // NOLINTBEGIN(readability-identifier-naming): the names are OpenVDB's
    [[nodiscard]] std::size_t polygonCount() const { return mesh_.faces.size(); }
    [[nodiscard]] std::size_t pointCount() const { return mesh_.vertices.size(); }
    [[nodiscard]] static std::size_t vertexCount(std::size_t) { return 3; }
    void getIndexSpacePoint(std::size_t face, std::size_t corner, openvdb::Vec3d& point) const
    {
        const Point3 p = mesh_.corner(mesh_.faces[face], corner) / voxel_;
        point = openvdb::Vec3d(p.x, p.y, p.z);
    }
    // NOLINTEND(readability-identifier-naming)

private:
    const TriangleMesh& mesh_;
    double voxel_;
};

//! Signed distances, mm, negative inside; as far in as the wall is thick and a band more.
openvdb::FloatGrid::Ptr distances_of(const TriangleMesh& mesh, const HollowOptions& options)
{
    const auto inward = static_cast<float>(options.wall / options.voxel) + kBand;
    return openvdb::tools::meshToVolume<openvdb::FloatGrid>(
        IndexedMesh(mesh, options.voxel), *openvdb::math::Transform::createLinearTransform(options.voxel),
        kBand, inward);
}

//! Vertical, from below the mesh up to a point in a hollow; negative inside.
struct Drain
{
    Point3 top;
    double bottom_z;
    double radius;

    [[nodiscard]] double distance_to(const openvdb::Vec3d& p) const
    {
        const double across = std::hypot(p.x() - top.x, p.y() - top.y) - radius;
        return std::max({across, p.z() - top.z, bottom_z - p.z()});
    }
};

//! The lowest voxel of a hollow, mm; `hollow`: a level set, negative in it.
std::optional<Point3> lowest_point(const openvdb::FloatGrid& hollow)
{
    std::optional<openvdb::Coord> lowest;
    for (auto value = hollow.cbeginValueOn(); value; ++value)
        if (*value < 0.0F && (!lowest || value.getCoord().z() < lowest->z()))
            lowest = value.getCoord();
    if (!lowest)
        return std::nullopt;
    const openvdb::Vec3d p = hollow.indexToWorld(*lowest);
    return Point3{p.x(), p.y(), p.z()};
}

//! Where a way straight down leaves the body for the first time, mm.
double bottom_below(const Point3& from, const openvdb::FloatGrid& distances, const Box3& box, double voxel)
{
    const openvdb::tools::GridSampler<openvdb::FloatGrid, openvdb::tools::BoxSampler> sampler(distances);
    double z = from.z;
    while (z > box.min.z - voxel && sampler.wsSample({from.x, from.y, z}) <= 0.0F)
        z -= 0.5 * voxel;
    return z - kBelow * voxel;
}

//! What lies deeper than the wall, as a level set, opened by a ball: pockets and bridges that are narrower
//! would be no more than noise of the voxels.
openvdb::FloatGrid::Ptr depth_of(const openvdb::FloatGrid& distances, const HollowOptions& options)
{
    const auto radius = static_cast<float>(kOpening * options.voxel);
    openvdb::FloatGrid::Ptr depth =
        openvdb::tools::levelSetRebuild(distances, static_cast<float>(-options.wall), kBand, kBand);
    if (depth->empty())
        return depth;
    openvdb::tools::LevelSetFilter<openvdb::FloatGrid> filter(*depth);
    filter.offset(radius); // positive is inward
    filter.offset(-radius);
    return depth;
}

std::vector<openvdb::FloatGrid::Ptr> hollows_of(const openvdb::FloatGrid& depth)
{
    std::vector<openvdb::FloatGrid::Ptr> hollows;
    if (!depth.empty())
        openvdb::tools::segmentSDF(depth, hollows);
    std::erase_if(hollows, [](const openvdb::FloatGrid::Ptr& hollow) { return !lowest_point(*hollow); });
    return hollows;
}

openvdb::FloatGrid::Ptr level_set_of(const Drain& drain, const HollowOptions& options)
{
    const auto band = static_cast<float>(kBand * options.voxel);
    const openvdb::FloatGrid::Ptr grid = openvdb::createLevelSet<openvdb::FloatGrid>(options.voxel, kBand);
    const double margin = drain.radius + band;
    const openvdb::CoordBBox box(grid->transform().worldToIndexCellCentered(
                                     {drain.top.x - margin, drain.top.y - margin, drain.bottom_z - band}),
                                 grid->transform().worldToIndexCellCentered(
                                     {drain.top.x + margin, drain.top.y + margin, drain.top.z + band}));
    auto values = grid->getAccessor();
    for (auto voxel = box.begin(); voxel; ++voxel)
        if (const auto distance = static_cast<float>(drain.distance_to(grid->indexToWorld(*voxel)));
            distance < band)
            values.setValue(*voxel, std::max(distance, -band));
    openvdb::tools::signedFloodFill(grid->tree());
    return grid;
}

void check_options(const HollowOptions& options)
{
    if (!(options.wall > 0.0) || !std::isfinite(options.wall))
        throw UsageError("the wall is " + std::to_string(options.wall) + " mm; allowed: a number > 0");
    if (!(options.voxel > 0.0 && options.voxel <= 0.5 * options.wall))
        throw UsageError("the voxel is " + std::to_string(options.voxel) +
                         " mm; allowed: a number > 0, at most half the wall of " +
                         std::to_string(options.wall) + " mm");
    if (!(options.drain_diameter == 0.0 || options.drain_diameter >= 2.0 * options.voxel))
        throw UsageError("the drain is " + std::to_string(options.drain_diameter) +
                         " mm wide; allowed: 0, or at least two voxels of " + std::to_string(options.voxel) +
                         " mm");
}

//! Voxels that the level sets keep: a wall and a band on either side of the surface.
double voxels_to_keep(const TriangleMesh& mesh, const HollowOptions& options)
{
    const double thickness = options.wall + 2.0 * kBand * options.voxel;
    return area(mesh) * thickness / (options.voxel * options.voxel * options.voxel);
}

void check_sizes(const TriangleMesh& mesh, const HollowOptions& options)
{
    const Vec3 extent = bounding_box(mesh).extent();
    const double longest = std::max({extent.x, extent.y, extent.z});
    if (options.drain_diameter >= longest)
        throw UsageError("the drain is " + number_text(options.drain_diameter) +
                         " mm wide; allowed: less than the mesh, which is " + number_text(longest) +
                         " mm long");
    const auto memory = static_cast<double>(total_memory_bytes());
    const double needed = kBytesPerVoxel * voxels_to_keep(mesh, options);
    if (memory > 0.0 && needed > memory)
        throw UsageError("a wall of " + number_text(options.wall) + " mm in voxels of " +
                         number_text(options.voxel) + " mm takes about " + number_text(1e-9 * needed) +
                         " GB for this mesh, which is " + number_text(longest) +
                         " mm long; this machine has " + number_text(1e-9 * memory) +
                         " GB: allowed is a larger voxel, or wall");
}

//! Numbers that are the isovalue itself are inside; see Level.
void make_surface(openvdb::FloatGrid::Ptr grid, const HollowOptions& options, HollowSolid& solid)
{
    LevelSurvey survey(0.0, InsideIs::kBelow);
    survey.include(grid->background());
    for (auto value = grid->cbeginValueAll(); value; ++value)
        survey.include(*value);
    const Level level = survey.level();
    openvdb::CoordBBox box = grid->evalActiveVoxelBoundingBox();
    box.expand(1);
    const Vec3 step{options.voxel, options.voxel, options.voxel};
    const std::shared_ptr<const HeightField> heights = make_sparse_height_field(grid, level, box, step);
    solid.inventory = std::make_shared<const Inventory>(*heights, 0);
    solid.oracle = std::make_unique<LatticeOracle<SparseLattice>>(SparseLattice(grid, level, box, step),
                                                                  LatticeRegions{solid.inventory, heights});
}

} // namespace

HollowSolid hollow_out(const TriangleMesh& mesh, const HollowOptions& options)
{
    check_options(options);
    check_sizes(mesh, options);
    openvdb::initialize();
    const openvdb::FloatGrid::Ptr distances = distances_of(mesh, options);
    HollowSolid solid;
    std::vector<Drain> drains;
    const openvdb::FloatGrid::Ptr depth = depth_of(*distances, options);
    for (const openvdb::FloatGrid::Ptr& hollow : hollows_of(*depth))
    {
        ++solid.hollows;
        if (options.drain_diameter == 0.0)
            continue;
        const Point3 low = *lowest_point(*hollow);
        solid.drains.push_back(low);
        drains.push_back({low + Vec3{0, 0, options.drain_diameter},
                          bottom_below(low, *distances, bounding_box(mesh), options.voxel),
                          0.5 * options.drain_diameter});
    }
    if (solid.hollows == 0)
        throw UsageError("nothing of the mesh lies deeper than the wall of " + std::to_string(options.wall) +
                         " mm; allowed: a thinner wall");
    const openvdb::FloatGrid::Ptr body = openvdb::tools::levelSetRebuild(*distances, 0.0F, kBand, kBand);
    openvdb::tools::csgDifference(*body, *depth);
    for (const Drain& drain : drains)
        openvdb::tools::csgDifference(*body, *level_set_of(drain, options));
    make_surface(body, options, solid);
    return solid;
}

} // namespace voroprobe
