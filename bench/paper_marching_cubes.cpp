#include "bench/paper_marching_cubes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <sstream>
#include <vector>

#include <vtkDoubleArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "bench/line_plot.h"
#include "bench/paper_figures_scenes.h"
#include "certificate/surface_distance.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "mesher/seeded_mesher.h"

namespace voroprobe::bench
{
namespace
{

//! A surface as a function to sample and as an oracle.
struct SampledSurface
{
    std::string name;
    std::function<double(const Point3&)> depth; //!< >= 0 inside
    Scene scene;
    Box3 box; //!< to sample it in
};

struct Candidate
{
    TriangleMesh mesh;
    double distance = 0.0; //!< the larger of both ways, of samples
};

struct ComparisonRow
{
    std::string surface;
    int cells = 0; //!< of the grid, along a side
    Candidate marching_cubes;
    Candidate ours;

    [[nodiscard]] double vertex_ratio() const
    {
        return static_cast<double>(marching_cubes.mesh.vertices.size()) /
               static_cast<double>(ours.mesh.vertices.size());
    }
};

double depth_in_implicit_surface(const Point3& p)
{
    const auto g = [](double t) { return t * t + std::sin(4.0 * t); };
    return -g(p.x) - g(p.y) - g(p.z);
}

std::vector<SampledSurface> surfaces()
{
    constexpr double kRing = 1.5;
    constexpr double kTube = 0.5;
    const Torus torus{{0, 0, 0}, 2, kRing, kTube};
    std::vector<SampledSurface> list;
    list.push_back({"torus, radii 1.5 and 0.5", [torus](const Point3& p) { return torus.depth(p); },
                    single_torus(kRing, kTube), Box3{{-2.1, -2.1, -2.1}, {2.1, 2.1, 2.1}}});
    list.push_back({"the surface of Figure 8", depth_in_implicit_surface, implicit_surface(),
                    Box3{{-2.1, -2.1, -2.1}, {2.1, 2.1, 2.1}}});
    return list;
}

TriangleMesh march(const SampledSurface& surface, int cells)
{
    vtkNew<vtkImageData> grid;
    const double step = surface.box.extent().x / cells;
    grid->SetDimensions(cells + 1, cells + 1, cells + 1);
    grid->SetOrigin(surface.box.min.x, surface.box.min.y, surface.box.min.z);
    grid->SetSpacing(step, step, step);
    vtkNew<vtkDoubleArray> values;
    values->SetNumberOfTuples(grid->GetNumberOfPoints());
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
        const double* p = grid->GetPoint(i);
        values->SetValue(i, surface.depth({p[0], p[1], p[2]}));
    }
    grid->GetPointData()->SetScalars(values);
    vtkNew<vtkFlyingEdges3D> marching_cubes;
    marching_cubes->SetInputData(grid);
    marching_cubes->SetValue(0, 0.0);
    marching_cubes->ComputeNormalsOff();
    marching_cubes->Update();

    TriangleMesh mesh;
    vtkPolyData* polygons = marching_cubes->GetOutput();
    for (vtkIdType i = 0; i < polygons->GetNumberOfPoints(); ++i)
    {
        const double* p = polygons->GetPoint(i);
        mesh.vertices.push_back({p[0], p[1], p[2]});
    }
    for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i)
    {
        vtkIdType count = 0;
        const vtkIdType* corner = nullptr;
        polygons->GetCellPoints(i, count, corner);
        mesh.faces.push_back({static_cast<std::uint32_t>(corner[0]), static_cast<std::uint32_t>(corner[1]),
                              static_cast<std::uint32_t>(corner[2])});
    }
    return mesh;
}

double two_sided_distance(const TriangleMesh& mesh, const SampledSurface& surface)
{
    return surface_distance(mesh, *surface.scene.oracle).max();
}

Candidate refine(const SampledSurface& surface, double largest_distance)
{
    constexpr double kFloorInDistances = 0.5;
    MeshingOptions options = surface.scene.options;
    options.max_facet_radius = 1.0; // the distance sets the size
    options.max_facet_distance = largest_distance;
    options.floor_radius = std::min(options.floor_radius, kFloorInDistances * largest_distance);
    options.seeding = Seeding::kProbe;
    Candidate candidate{mesh_surface(*surface.scene.oracle, options).mesh, 0.0};
    candidate.distance = two_sided_distance(candidate.mesh, surface);
    return candidate;
}

//! The fewest vertices that are as near to the surface as wanted, over criteria spaced evenly in logarithm:
//! the largest distance of all samples is no smooth function of the criterion.
Candidate refine_to(const SampledSurface& surface, double wanted_distance)
{
    constexpr int kSteps = 20;
    constexpr double kTightest = 0.125; // in wanted distances; the criterion is for circumcenters
    constexpr double kLoosest = 4.0;
    Candidate best;
    for (int i = 0; i <= kSteps; ++i)
    {
        const double factor = kTightest * std::pow(kLoosest / kTightest, static_cast<double>(i) / kSteps);
        Candidate candidate = refine(surface, factor * wanted_distance);
        if (candidate.distance <= wanted_distance &&
            (best.mesh.faces.empty() || candidate.mesh.vertices.size() < best.mesh.vertices.size()))
            best = std::move(candidate);
    }
    return best;
}

std::string table_of(const std::vector<ComparisonRow>& rows)
{
    std::ostringstream out;
    out << "Figure 1: vertices at equal distance between mesh and surface, both ways\n"
        << "surface                     grid  distance  marching cubes  smallest angle      ours  distance  "
           "smallest angle  ratio\n";
    for (const ComparisonRow& row : rows)
        out << std::left << std::setw(26) << row.surface << std::right << std::setw(4) << row.cells << "^3"
            << std::fixed << std::setprecision(5) << std::setw(10) << row.marching_cubes.distance
            << std::setw(16) << row.marching_cubes.mesh.vertices.size() << std::setprecision(2)
            << std::setw(16) << measure_angles(row.marching_cubes.mesh).min_deg << std::setw(10)
            << row.ours.mesh.vertices.size() << std::setprecision(5) << std::setw(10) << row.ours.distance
            << std::setprecision(2) << std::setw(16) << measure_angles(row.ours.mesh).min_deg << std::setw(7)
            << row.vertex_ratio() << '\n';
    return out.str();
}

nlohmann::json json_of(const Candidate& candidate)
{
    return {{"vertices", candidate.mesh.vertices.size()},
            {"distance", candidate.distance},
            {"min_angle_deg", measure_angles(candidate.mesh).min_deg},
            {"euler_characteristic", analyze_topology(candidate.mesh).euler_characteristic}};
}

nlohmann::json json_of(const std::vector<ComparisonRow>& rows)
{
    nlohmann::json list = nlohmann::json::array();
    for (const ComparisonRow& row : rows)
        list.push_back({{"surface", row.surface},
                        {"grid", row.cells},
                        {"marching_cubes", json_of(row.marching_cubes)},
                        {"ours", json_of(row.ours)},
                        {"vertex_ratio", row.vertex_ratio()}});
    return {{"figure", 1}, {"rows", list}};
}

std::string svg_of(const std::vector<ComparisonRow>& rows)
{
    std::vector<double> vertices;
    std::vector<double> distances;
    std::vector<PlotSeries> series;
    const auto add = [&](const std::string& name, const Candidate& candidate)
    {
        auto place = std::find_if(series.begin(), series.end(),
                                  [&](const PlotSeries& other) { return other.name == name; });
        if (place == series.end())
            place = series.insert(series.end(), PlotSeries{name, {}});
        place->points.emplace_back(static_cast<double>(candidate.mesh.vertices.size()), candidate.distance);
        vertices.push_back(place->points.back().first);
        distances.push_back(candidate.distance);
    };
    for (const ComparisonRow& row : rows)
    {
        add("marching cubes, " + row.surface, row.marching_cubes);
        add("ours, " + row.surface, row.ours);
    }
    return to_svg({.title = "distance to the surface, both ways",
                   .x = decades("vertices", vertices),
                   .y = decades("", distances),
                   .series = series});
}

} // namespace

Report compare_with_marching_cubes()
{
    std::vector<ComparisonRow> rows;
    for (const SampledSurface& surface : surfaces())
    {
        for (const int cells : {24, 48, 96})
        {
            ComparisonRow row{.surface = surface.name, .cells = cells, .marching_cubes = {}, .ours = {}};
            row.marching_cubes.mesh = march(surface, cells);
            row.marching_cubes.distance = two_sided_distance(row.marching_cubes.mesh, surface);
            row.ours = refine_to(surface, row.marching_cubes.distance);
            rows.push_back(std::move(row));
        }
    }
    const bool near_enough =
        std::all_of(rows.begin(), rows.end(),
                    [](const ComparisonRow& row)
                    { return !row.ours.mesh.faces.empty() && is_closed_manifold(row.ours.mesh); });
    return {table_of(rows), json_of(rows), svg_of(rows), near_enough};
}

} // namespace voroprobe::bench
