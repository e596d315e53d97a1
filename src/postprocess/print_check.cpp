#include "postprocess/print_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "certificate/mesh_pieces.h"
#include "certificate/mesh_rays.h"
#include "certificate/mesh_samples.h"
#include "mesh/measures.h"
#include "postprocess/bodies.h"
#include "postprocess/face_shape.h"
#include "support/random.h"

namespace voroprobe
{

namespace
{

//! Two faces are the sides of one wall, or of one gap, where they look apart within 60 degrees.
constexpr double kCosFacing = -0.5;

//! Rays begin a hair beyond their face, as a share of the diagonal of the box.
constexpr double kHair = 1e-7;

//! What touches the bed needs no support, mm: less than a layer.
constexpr double kOnBed = 0.05;

//! Largest extents that millimetres hardly mean.
constexpr double kLooksLikeMetres = 1.0;
constexpr double kLooksLikeInches = 10.0;
constexpr double kLooksLikeMicrometres = 5000.0;

constexpr std::uint64_t kSeed = 0;

std::string text(double value)
{
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.4g", value);
    return buffer.data();
}

std::string text(const Vec3& v, const char* separator)
{
    return text(v.x) + separator + text(v.y) + separator + text(v.z);
}

double largest(const Vec3& extent)
{
    return std::max({extent.x, extent.y, extent.z});
}

void judge_size(PrintCheck& check)
{
    const Vec3 extent = check.box.extent();
    const double size = largest(extent);
    const std::string as_it_is = "the box is " + text(extent, " x ") + " mm: ";
    if (size < kLooksLikeMetres)
        check.warnings.push_back(as_it_is + "as small as a grain; if these are metres, --unit m makes them " +
                                 text(1e3 * extent, " x ") + " mm");
    else if (size < kLooksLikeInches)
        check.warnings.push_back(as_it_is + "small; if these are inches, --unit inch makes them " +
                                 text(25.4 * extent, " x ") + " mm");
    else if (size > kLooksLikeMicrometres)
        check.warnings.push_back(as_it_is +
                                 "larger than any printer; if these are micrometres, --unit um makes them " +
                                 text(1e-3 * extent, " x ") + " mm");
}

void judge_bed(PrintCheck& check, const PrintOptions& options)
{
    if (!options.bed)
        return;
    const Vec3 extent = check.box.extent();
    const Vec3 bed = *options.bed;
    const bool high = extent.z <= bed.z;
    const bool lies = extent.x <= bed.x && extent.y <= bed.y;
    const bool turned = extent.x <= bed.y && extent.y <= bed.x;
    check.fits = high && (lies || turned);
    check.fits_turned = check.fits && !lies;
    if (!check.fits)
        check.failures.push_back("a box of " + text(extent, " x ") + " mm, larger than the build volume of " +
                                 text(bed, " x ") + " mm (--bed); --scale " +
                                 text(std::min({bed.x / extent.x, bed.y / extent.y, bed.z / extent.z})) +
                                 " would fit");
}

void count_bodies(const TriangleMesh& mesh, PrintCheck& check)
{
    const MeshPieces pieces = split_into_pieces(mesh);
    const std::vector<Body> bodies = find_bodies(mesh, pieces);
    check.bodies += bodies.size();
    for (const Body& body : bodies)
    {
        const Box3& box = pieces.pieces[body.shell].box;
        if (check.smallest_body.empty() || box.diagonal() < check.smallest_body.diagonal())
            check.smallest_body = box;
        for (const std::uint32_t cavity : body.cavities)
            check.cavities.push_back({-pieces.pieces[cavity].enclosed_volume, pieces.pieces[cavity].box});
    }
}

void judge_cavities(PrintCheck& check)
{
    std::stable_sort(check.cavities.begin(), check.cavities.end(),
                     [](const TrappedCavity& a, const TrappedCavity& b) { return a.volume > b.volume; });
    if (!check.cavities.empty())
        check.warnings.push_back(
            std::to_string(check.cavities.size()) +
            (check.cavities.size() == 1 ? " cavity has" : " cavities have") +
            " no way out: powder or resin stays in (process --drop-cavities fills them)");
}

void keep_smaller(std::optional<Narrowest>& smallest, double length, const Point3& at)
{
    if (!smallest || length < smallest->length)
        smallest = Narrowest{length, at};
}

//! `walls`: ascending.
std::optional<WallThickness> thickness_of(const std::vector<double>& walls)
{
    if (walls.empty())
        return std::nullopt;
    const auto at = [&walls](double share)
    { return walls[static_cast<std::size_t>(share * static_cast<double>(walls.size() - 1))]; };
    return WallThickness{.percent_1 = at(0.01), .percent_5 = at(0.05), .median = at(0.5)};
}

//! From every sample one ray in, one out.
void measure_walls(const TriangleMesh& mesh, const PrintOptions& options, PrintCheck& check)
{
    const MeshRays rays(mesh);
    const double hair = kHair * check.box.diagonal();
    const auto look = [&](const MeshSample& sample) -> std::optional<double>
    {
        if (sample.normal == Vec3{})
            return std::nullopt;
        const auto facing = [&](const Vec3& way) { return rays.first_hit(sample.point, way, hair); };
        const auto wall = facing(-sample.normal);
        const bool is_wall = wall && dot(wall->normal, sample.normal) < kCosFacing;
        if (is_wall)
            keep_smaller(check.thinnest_wall, wall->distance, sample.point);
        if (const auto gap = facing(sample.normal); gap && dot(gap->normal, sample.normal) < kCosFacing)
            keep_smaller(check.narrowest_gap, gap->distance, sample.point);
        return is_wall ? std::optional(wall->distance) : std::nullopt;
    };
    for (const TriangleMesh::Face& face : mesh.faces) // a thin part may be a few faces only
        if (mesh.faces.size() <= options.samples)
            look({(mesh.corner(face, 0) + mesh.corner(face, 1) + mesh.corner(face, 2)) / 3.0,
                  unit_normal(mesh.corner(face, 0), mesh.corner(face, 1), mesh.corner(face, 2))});
    Random random(kSeed);
    const std::vector<MeshSample> samples = area_samples(mesh, options.samples, random);
    std::vector<double> walls;
    for (const MeshSample& sample : samples)
        if (const auto wall = look(sample))
            walls.push_back(*wall);
    std::sort(walls.begin(), walls.end());
    check.wall_thickness = thickness_of(walls);
    if (options.min_wall && !samples.empty())
        check.thin_area_share =
            static_cast<double>(std::lower_bound(walls.begin(), walls.end(), *options.min_wall) -
                                walls.begin()) /
            static_cast<double>(samples.size());
}

void judge_walls(const PrintOptions& options, PrintCheck& check)
{
    if (options.min_wall && check.thinnest_wall && check.thinnest_wall->length < *options.min_wall)
        check.failures.push_back("a wall of " + text(check.thinnest_wall->length) + " mm near (" +
                                 text(check.thinnest_wall->at, ", ") + "), thinner than " +
                                 text(*options.min_wall) + " mm (--min-wall) like " +
                                 text(100.0 * check.thin_area_share) + " % of the surface");
}

void measure_overhangs(const TriangleMesh& mesh, const PrintOptions& options, PrintCheck& check)
{
    const double steepest = -std::sin(options.overhang_deg * std::numbers::pi / 180.0);
    for (const TriangleMesh::Face& face : mesh.faces)
    {
        const Vec3 twice =
            cross(mesh.corner(face, 1) - mesh.corner(face, 0), mesh.corner(face, 2) - mesh.corner(face, 0));
        const double highest =
            std::max({mesh.corner(face, 0).z, mesh.corner(face, 1).z, mesh.corner(face, 2).z});
        if (twice.z < steepest * norm(twice) && highest > check.box.min.z + kOnBed)
            check.overhang_area += 0.5 * norm(twice);
    }
    const double all = area(mesh);
    check.overhang_share = all > 0.0 ? check.overhang_area / all : 0.0;
}

} // namespace

PrintCheck check_printable(const std::vector<MeshPart>& parts, const PrintOptions& options)
{
    constexpr double kCubicMillimetresPerCubicCentimetre = 1000.0;
    PrintCheck check;
    const TriangleMesh mesh = merged(parts);
    check.box = bounding_box(mesh);
    check.volume = enclosed_volume(mesh);
    if (options.density_g_cm3)
        check.weight_g = check.volume / kCubicMillimetresPerCubicCentimetre * *options.density_g_cm3;
    judge_size(check);
    for (const MeshPart& part : parts)
        count_bodies(part.mesh, check);
    judge_cavities(check);
    measure_walls(mesh, options, check);
    judge_walls(options, check);
    measure_overhangs(mesh, options, check);
    judge_bed(check, options);
    return check;
}

} // namespace voroprobe
