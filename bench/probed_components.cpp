// Whether probing alone finds what it promises: meshes a volume without its inventory, and holds the mesh
// against that. Prints one row of the table in docs/probing.md. Exit status 1 where a surface around a ball
// as large as the reach was not found.
#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <numeric>
#include <string>

#include <CLI/CLI.hpp>
#include <vtkDoubleArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "io/volume_reader.h"
#include "mesh/topology.h"
#include "mesher/seeded_mesher.h"
#include "oracles/trilinear_oracle.h"
#include "volume/height_field.h"
#include "volume/inventory.h"

namespace voroprobe::bench
{
namespace
{

struct Options
{
    std::filesystem::path volume;
    double isovalue = 0.0;
    double reach_in_voxels = 0.5;
};

//! An oracle with its inventory hidden: all that a formula could tell.
class WithoutInventory final : public SurfaceOracle
{
public:
    explicit WithoutInventory(const SurfaceOracle& oracle) : oracle_(oracle) {}

    [[nodiscard]] Box3 domain() const override { return oracle_.domain(); }
    [[nodiscard]] Region region(const Point3& p) const override
    {
        return is_inside(oracle_.region(p)) ? 1 : kOuterRegion;
    }
    void find_crossings(const Segment3& segment, std::vector<Crossing>& crossings) const override
    {
        oracle_.find_crossings(segment, crossings);
    }
    [[nodiscard]] bool may_cross(const Box3& box) const override { return oracle_.may_cross(box); }

private:
    const SurfaceOracle& oracle_;
};

//! Pieces of the marching cubes surface of the volume in a frame of samples below all others.
std::size_t count_marching_cubes_pieces(const Volume& volume, double isovalue)
{
    vtkNew<vtkImageData> grid;
    const auto& size = volume.geometry.size;
    grid->SetDimensions(static_cast<int>(size[0]) + 2, static_cast<int>(size[1]) + 2,
                        static_cast<int>(size[2]) + 2);
    vtkNew<vtkDoubleArray> values;
    values->SetNumberOfTuples(grid->GetNumberOfPoints());
    values->Fill(-1e30);
    vtkIdType at = 0;
    for (std::size_t k = 0; k < size[2] + 2; ++k)
        for (std::size_t j = 0; j < size[1] + 2; ++j)
            for (std::size_t i = 0; i < size[0] + 2; ++i, ++at)
            {
                const bool framed = i > 0 && j > 0 && k > 0 && i <= size[0] && j <= size[1] && k <= size[2];
                if (framed)
                    values->SetValue(at, volume.at(i - 1, j - 1, k - 1));
            }
    grid->GetPointData()->SetScalars(values);
    vtkNew<vtkFlyingEdges3D> marching_cubes;
    marching_cubes->SetInputData(grid);
    marching_cubes->SetValue(0, isovalue);
    marching_cubes->ComputeNormalsOff();
    marching_cubes->Update();

    TriangleMesh mesh;
    vtkPolyData* polygons = marching_cubes->GetOutput();
    mesh.vertices.resize(static_cast<std::size_t>(polygons->GetNumberOfPoints()));
    for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i)
    {
        vtkIdType count = 0;
        const vtkIdType* corner = nullptr;
        polygons->GetCellPoints(i, count, corner);
        mesh.faces.push_back({static_cast<std::uint32_t>(corner[0]), static_cast<std::uint32_t>(corner[1]),
                              static_cast<std::uint32_t>(corner[2])});
    }
    return count_components(mesh);
}

//! Directions spread evenly: a spiral from pole to pole. Source: Swinbank & Purser, Fibonacci grids, 2006.
std::vector<Vec3> directions(std::size_t count)
{
    std::vector<Vec3> list;
    for (std::size_t n = 0; n < count; ++n)
    {
        const double z = 1.0 - (2.0 * static_cast<double>(n) + 1.0) / static_cast<double>(count);
        const double longitude = 2.0 * std::numbers::pi * std::numbers::phi * static_cast<double>(n);
        const double radius = std::sqrt(1.0 - z * z);
        list.push_back({radius * std::cos(longitude), radius * std::sin(longitude), z});
    }
    return list;
}

//! Whether the region next within a surface seems to hold a ball: around some point of a lattice in it no ray
//! as long as the radius crosses anything. Errs on the side of yes.
bool holds_ball(const SurfaceOracle& oracle, SurfaceId surface, double radius)
{
    constexpr std::size_t kBoxPoints = 1024;
    constexpr std::size_t kRays = 200;
    constexpr double kStepsPerRadius = 6.0;
    const SurfaceSides sides = oracle.sides(surface);
    const Region enclosed = oracle.surface_around(sides.inside) == surface ? sides.inside : sides.outside;
    Box3 box;
    const std::vector<std::vector<Point3>> points = oracle.points_on({&surface, 1}, kBoxPoints);
    for (const Point3& p : points.front())
        box.include(p);
    const std::vector<Vec3> rays = directions(kRays);
    std::vector<Crossing> crossings;
    const auto is_free = [&](const Point3& center)
    {
        return std::none_of(rays.begin(), rays.end(),
                            [&](const Vec3& ray)
                            {
                                oracle.find_crossings({center, center + radius * ray}, crossings);
                                return !crossings.empty();
                            });
    };
    const double step = radius / kStepsPerRadius;
    for (double z = box.min.z; z <= box.max.z; z += step)
        for (double y = box.min.y; y <= box.max.y; y += step)
            for (double x = box.min.x; x <= box.max.x; x += step)
                if (oracle.region({x, y, z}) == enclosed && is_free({x, y, z}))
                    return true;
    return false;
}

//! Which surfaces of the inventory some vertex of the mesh lies on.
std::vector<bool> surfaces_found(const TriangleMesh& mesh, const SurfaceOracle& oracle)
{
    std::vector<bool> found(oracle.surface_count(), false);
    for (const Point3& vertex : mesh.vertices)
    {
        const SurfaceId surface = oracle.surface_at(vertex);
        if (surface != kNoSurface)
            found[static_cast<std::size_t>(surface)] = true;
    }
    return found;
}

int run(const Options& options)
{
    const auto volume = std::make_shared<const Volume>(read_volume(options.volume).volume);
    const LevelledVolume levelled = level_volume(volume, options.isovalue, InsideIs::kAbove);
    const auto inventory = std::make_shared<const Inventory>(*make_height_field(levelled));
    const auto oracle = make_trilinear_oracle(levelled, inventory);

    const double voxel = volume->geometry.min_spacing();
    const double reach = options.reach_in_voxels * voxel;
    const MeshingResult result = mesh_surface(WithoutInventory(*oracle), {.max_facet_radius = 2.0 * voxel,
                                                                          .max_facet_distance = 0.3 * voxel,
                                                                          .floor_radius = 0.25 * voxel,
                                                                          .reach_lower_bound = reach,
                                                                          .seeding = Seeding::kProbe});
    const std::vector<bool> found = surfaces_found(result.mesh, *oracle);
    std::size_t missed_small = 0;
    std::size_t missed = 0;
    for (std::size_t surface = 0; surface < found.size(); ++surface)
    {
        if (!found[surface])
            ++(holds_ball(*oracle, static_cast<SurfaceId>(surface), reach) ? missed : missed_small);
    }
    const MeshingStatistics& work = result.statistics;
    std::cout << "| `" << options.volume.filename().string() << "` | " << options.isovalue << " | " << reach
              << " | " << count_marching_cubes_pieces(*volume, options.isovalue) << " | " << found.size()
              << " | " << std::count(found.begin(), found.end(), true) << " | " << missed_small << " | "
              << missed << " | " << count_components(result.mesh) << " | "
              << work.cells_probed + work.cells_probed_at_once << " | " << work.queries_probing << " | "
              << work.queries_refinement << " |\n";
    return missed == 0 && is_closed_manifold(result.mesh) ? 0 : 1;
}

} // namespace
} // namespace voroprobe::bench

int main(int argc, char** argv)
{
    voroprobe::bench::Options options;
    CLI::App app("What probing finds in a volume whose inventory it does not know");
    app.add_option("VOLUME", options.volume)->required();
    app.add_option("--isovalue", options.isovalue)->required();
    app.add_option("--reach", options.reach_in_voxels, "in shortest voxel sides")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try
    {
        return voroprobe::bench::run(options);
    }
    catch (const std::exception& error)
    {
        std::cerr << "bench_probed_components: " << error.what() << '\n';
        return 2;
    }
}
