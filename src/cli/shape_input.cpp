#include "cli/shape_input.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/number_text.h"
#include "cli/option_values.h"
#include "io/mesh_reader.h"
#include "io/point_cloud_reader.h"
#include "oracles/implicit_expression.h"
#include "oracles/point_cloud_oracle.h"
#include "oracles/triangle_mesh_oracle.h"
#include "support/error.h"
#include "support/text.h"

namespace voroprobe
{
namespace
{

constexpr double kGrainsAcross = 100.0;

constexpr std::string_view kDomains =
    "box:x0,y0,z0,x1,y1,z1 with each first number below the second, or ball:cx,cy,cz,r with r > 0";

bool is_mesh_path(const std::filesystem::path& path)
{
    static constexpr std::array<std::string_view, 6> kExtensions{".stl", ".ply", ".obj",
                                                                 ".off", ".vtp", ".3mf"};
    const std::string extension = lower_case(path.extension().string());
    return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

bool is_cloud_path(const std::filesystem::path& path)
{
    return lower_case(path.extension().string()) == ".xyz";
}

//! The numbers of a list separated by commas. \throw UsageError where one is none.
std::vector<double> parse_list(std::string_view text, const std::string& whole)
{
    static const NumberRule kRule{kAnyFinite.allows, kDomains};
    std::vector<double> numbers;
    while (true)
    {
        const std::size_t comma = text.find(',');
        try
        {
            numbers.push_back(parse_number("--domain", text.substr(0, comma), kRule));
        }
        catch (const UsageError&)
        {
            refuse_value("--domain", whole, kDomains);
        }
        if (comma == std::string_view::npos)
            return numbers;
        text.remove_prefix(comma + 1);
    }
}

//! Millimetres as they are; `grain` takes the place of a voxel.
GridPlacement placement_of_shape(double grain)
{
    const double per_grain = 1.0 / grain;
    return {.world_from_grid = {},
            .source_index_from_grid = {{{Vec3{per_grain, 0, 0}, {0, per_grain, 0}, {0, 0, per_grain}}}, {}}};
}

SurfaceInput shape(InputKind kind, std::string format, std::string description, double grain)
{
    SurfaceInput input{};
    input.kind = kind;
    input.placement = placement_of_shape(grain);
    input.format = std::move(format);
    input.description = std::move(description);
    return input;
}

SurfaceInput load_formula(const SurfaceRequest& request)
{
    const FormulaRequest& formula = *request.formula;
    const ImplicitDomain domain = parse_domain(formula.domain);
    SurfaceInput input = shape(InputKind::kFormula, "formula", "formula over " + formula.domain,
                               grain_size(domain.bounding_box()));
    input.isovalue = {request.isovalue.value_or(0.0), request.isovalue ? "given" : "usual for a formula"};
    input.inside = request.inside.value_or(InsideIs::kBelow);
    input.domain = domain;
    input.oracle = make_expression_oracle(
        {.formula = formula.text, .isovalue = input.isovalue.value, .inside = input.inside}, domain);
    return input;
}

SurfaceInput load_triangle_mesh(const SurfaceRequest& request)
{
    const TriangleMesh mesh = read_mesh(request.path);
    SurfaceInput input = shape(InputKind::kTriangleMesh, "triangle mesh",
                               count_text(mesh.vertices.size()) + " vertices, " +
                                   count_text(mesh.faces.size()) + " faces (triangle mesh)",
                               grain_size(bounding_box(mesh)));
    input.oracle = make_triangle_mesh_oracle(mesh, request.path.string());
    return input;
}

SurfaceInput load_point_cloud(const SurfaceRequest& request)
{
    const std::vector<OrientedPoint> cloud = read_point_cloud(request.path);
    Box3 box;
    for (const OrientedPoint& point : cloud)
        box.include(point.position);
    SurfaceInput input = shape(InputKind::kPointCloud, "point cloud",
                               count_text(cloud.size()) +
                                   " points with normals (point cloud), fitted by Poisson reconstruction",
                               grain_size(box));
    input.oracle = make_point_cloud_oracle(cloud, request.path.string());
    return input;
}

} // namespace

double grain_size(const Box3& box)
{
    return box.diagonal() / kGrainsAcross;
}

ImplicitDomain parse_domain(const std::string& text)
{
    const std::size_t colon = text.find(':');
    const std::string kind = text.substr(0, colon);
    if (colon == std::string::npos || (kind != "box" && kind != "ball"))
        refuse_value("--domain", text, kDomains);
    const std::vector<double> n = parse_list(std::string_view(text).substr(colon + 1), text);
    if (kind == "ball" && n.size() == 4 && n[3] > 0.0)
        return {{n[0], n[1], n[2]}, n[3]};
    if (kind == "box" && n.size() == 6 && n[0] < n[3] && n[1] < n[4] && n[2] < n[5])
        return ImplicitDomain(Box3{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}});
    refuse_value("--domain", text, kDomains);
}

bool is_shape(const SurfaceRequest& request)
{
    return request.formula || is_mesh_path(request.path) || is_cloud_path(request.path);
}

void check_shape_request(const SurfaceRequest& request)
{
    const ReadOptions& read = request.read;
    if (read.spacing || read.frame || read.series || read.grid)
        throw UsageError("--spacing, --frame, --series and --grid go with volumes only; there is none here");
    if (request.formula)
    {
        if (!request.path.empty())
            throw UsageError("INPUT is '" + request.path.string() + "'; allowed: none beside --implicit");
        static_cast<void>(parse_domain(request.formula->domain));
        return;
    }
    if (request.isovalue || request.inside)
        throw UsageError("--isovalue and --inside do not go with '" + request.path.string() +
                         "': it is a surface already");
}

SurfaceInput load_shape(const SurfaceRequest& request)
{
    if (request.formula)
        return load_formula(request);
    return is_mesh_path(request.path) ? load_triangle_mesh(request) : load_point_cloud(request);
}

} // namespace voroprobe
