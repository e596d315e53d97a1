// Shapes whose topology, area, volume and distance are known, as exact oracles and as sampled volumes.

#include "mesher/seeded_mesher.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "integral_geometry.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "oracles/implicit_oracle.h"
#include "oracles/sphere_union_oracle.h"
#include "oracles/trilinear_oracle.h"
#include "self_intersections.h"
#include "solid_topology.h"
#include "surface_distance.h"
#include "volume/phantoms.h"

namespace voroprobe
{
namespace
{

using std::numbers::pi;

constexpr double kRounding = 1e-9;      // of coordinates around 20
constexpr double kMeasureError = 0.01;  // relative, of area and volume
constexpr int kIntervals = 4;           // face samples per side
constexpr std::size_t kSamples = 20000; // of the true surface

//! Distance 0.04 keeps the volume of a sphere of radius 8 within 1 %: the ball center is at most 0.04 above
//! the face, the face itself half of that below the sphere on average, 3 * 0.02 / 8 = 0.75 %.
constexpr MeshingOptions kOptions{
    .max_facet_radius = 1.5, .max_facet_distance = 0.04, .floor_radius = 0.1, .reach_lower_bound = 0.5};

//! The two points of a face and the surface that are farthest apart need not be the circumcenter and the ball
//! center, which are all that the distance criterion bounds. Where the surface curves by at most k, a
//! triangle of circumradius R with its corners on it stays within k R^2 / 2 of it (the error of linear
//! interpolation, Waldron 1998), whatever the criterion; where it curves equally in all directions both
//! bounds are the same.
double distance_bound(const TriangleMesh& mesh, double largest_curvature,
                      const MeshingOptions& options = kOptions)
{
    double largest = 0.0;
    for (const TriangleMesh::Face& face : mesh.faces)
    {
        const double a = distance(mesh.corner(face, 1), mesh.corner(face, 2));
        const double b = distance(mesh.corner(face, 2), mesh.corner(face, 0));
        const double c = distance(mesh.corner(face, 0), mesh.corner(face, 1));
        const double double_area = norm(
            cross(mesh.corner(face, 1) - mesh.corner(face, 0), mesh.corner(face, 2) - mesh.corner(face, 0)));
        largest = std::max(largest, a * b * c / (2.0 * double_area));
    }
    return std::max(*options.max_facet_distance, largest_curvature * largest * largest / 2.0);
}

//! Asserts that the faces are small enough for the distance criterion's bound to hold of every point.
void expect_size_to_bound_distance(const TriangleMesh& mesh, double largest_curvature,
                                   const MeshingOptions& options)
{
    EXPECT_LE(distance_bound(mesh, largest_curvature, options), *options.max_facet_distance);
}

double longest_edge(const TriangleMesh& mesh)
{
    double longest = 0.0;
    for (const TriangleMesh::Face& face : mesh.faces)
        for (std::size_t i = 0; i < 3; ++i)
            longest = std::max(longest, distance(mesh.corner(face, i), mesh.corner(face, (i + 1) % 3)));
    return longest;
}

void expect_topology(const TriangleMesh& mesh, const SurfaceTopology& expected)
{
    const MeshTopology found = analyze_topology(mesh);
    EXPECT_TRUE(found.closed());
    EXPECT_TRUE(found.manifold());
    EXPECT_TRUE(found.oriented());
    EXPECT_EQ(found.unused_vertices, 0U);
    EXPECT_EQ(found.components, expected.components);
    EXPECT_EQ(found.euler_characteristic, expected.euler_characteristic);
    EXPECT_TRUE(find_self_intersections(mesh).empty());
}

void expect_shape(const TriangleMesh& mesh, const MeshingOptions& options = kOptions)
{
    EXPECT_EQ(count_faces_below_angle(mesh, options.min_facet_angle_deg), 0U);
    EXPECT_LE(longest_edge(mesh), 2.0 * options.max_facet_radius + kRounding);
}

void expect_measures(const TriangleMesh& mesh, double true_area, double true_volume)
{
    EXPECT_NEAR(area(mesh) / true_area, 1.0, kMeasureError);
    EXPECT_NEAR(enclosed_volume(mesh) / true_volume, 1.0, kMeasureError);
}

//! Against the same surface measured with lines.
void expect_measures(const TriangleMesh& mesh, const SurfaceOracle& oracle)
{
    constexpr std::size_t kDirections = 200;
    constexpr std::size_t kLines = 40; // squared per direction
    const SurfaceMeasures truth = measure_with_lines(oracle, kDirections, kLines);
    expect_measures(mesh, truth.area, truth.volume);
}

//! Two-sided, against the oracle's own surface.
void expect_distances(const TriangleMesh& mesh, const SurfaceOracle& oracle, double bound, std::uint64_t seed)
{
    Random random(seed);
    EXPECT_LE(largest_distance_from_faces(mesh, oracle, 1.0, kIntervals), bound);
    EXPECT_LE(largest_distance_from_points(sample_surface(oracle, kSamples, random), mesh), bound);
}

std::unique_ptr<SurfaceOracle> sampled(const LevelFunction& function, const std::array<std::size_t, 3>& size,
                                       const Vec3& spacing = {1, 1, 1})
{
    return make_trilinear_oracle(std::make_shared<Volume>(sample_volume(function, size, spacing)), 0.0);
}

//! What holds of the mesh of a sampled shape against the interpolant itself and against the shape. `bound`:
//! see distance_bound(); `interpolation_error`: between shape and interpolant.
void expect_distances(const TriangleMesh& mesh, const SurfaceOracle& oracle,
                      const LevelFunction& signed_distance, double bound, double interpolation_error)
{
    Random random(11);
    EXPECT_LE(largest_distance_from_faces(mesh, signed_distance, kIntervals), bound + interpolation_error);
    EXPECT_LE(largest_distance_from_faces(mesh, oracle, 1.0, kIntervals), bound + interpolation_error);
    EXPECT_LE(largest_distance_from_points(sample_surface(oracle, kSamples, random), mesh),
              bound + interpolation_error);
}

// --- exact oracles ----------------------------------------------------------------------------------

TEST(Phantom, a_sphere)
{
    const SphereUnionOracle oracle({{{1, 2, 3}, 8.0}});
    const TriangleMesh mesh = mesh_surface(oracle, kOptions).mesh;
    expect_topology(mesh, {.components = 1, .euler_characteristic = 2});
    expect_shape(mesh);
    expect_measures(mesh, 4.0 * pi * 64.0, 4.0 / 3.0 * pi * 512.0);

    // A sphere curves equally in all directions: the criterion itself bounds both distances.
    Random random(1);
    const double bound = *kOptions.max_facet_distance + kRounding;
    EXPECT_LE(largest_distance_from_faces(mesh, sphere_phantom({1, 2, 3}, 8.0), kIntervals), bound);
    EXPECT_LE(largest_distance_from_points(sample_surface(oracle, kSamples, random), mesh), bound);
}

TEST(Phantom, nested_shells)
{
    const SphereUnionOracle oracle({{{0, 0, 0}, 9.0}, {{0, 0, 0}, 7.0}, {{0, 0, 0}, 5.0}});
    const TriangleMesh mesh = mesh_surface(oracle, kOptions).mesh;
    expect_topology(mesh, {.components = 3, .euler_characteristic = 6});
    expect_shape(mesh);
    expect_measures(mesh, 4.0 * pi * (81.0 + 49.0 + 25.0), 4.0 / 3.0 * pi * (729.0 - 343.0 + 125.0));

    Random random(2);
    const double bound = *kOptions.max_facet_distance + kRounding;
    EXPECT_LE(
        largest_distance_from_faces(mesh, nested_shells_phantom({0, 0, 0}, {9.0, 7.0, 5.0}), kIntervals),
        bound);
    EXPECT_LE(largest_distance_from_points(sample_surface(oracle, kSamples, random), mesh), bound);
}

//! A saddle lies above and below its faces: the criterion bounds little there, so the size has to.
//! 0.42^2 / 6 < 0.03: see distance_bound().
constexpr MeshingOptions kTorusOptions{
    .max_facet_radius = 0.42, .max_facet_distance = 0.03, .floor_radius = 0.1, .reach_lower_bound = 0.5};

TEST(Phantom, a_torus)
{
    const LevelFunction torus = torus_phantom({0, 0, 0}, 8.0, 3.0);
    const ImplicitOracle oracle(torus, {{-12, -12, -4}, {12, 12, 4}}, 1.0, 1e-3);
    const TriangleMesh mesh = mesh_surface(oracle, kTorusOptions).mesh;
    expect_topology(mesh, {.components = 1, .euler_characteristic = 0});
    expect_shape(mesh, kTorusOptions);
    expect_measures(mesh, 4.0 * pi * pi * 24.0, 2.0 * pi * pi * 72.0);

    Random random(3);
    expect_size_to_bound_distance(mesh, 1.0 / 3.0, kTorusOptions);
    const double bound = *kTorusOptions.max_facet_distance + kRounding;
    EXPECT_LE(largest_distance_from_faces(mesh, torus, kIntervals), bound);
    EXPECT_LE(largest_distance_from_points(sample_surface(oracle, kSamples, random), mesh), bound);
}

//! The largest curvature of the zero set of a smooth function, at many points of it.
double largest_curvature_of(const LevelFunction& function, const SurfaceOracle& oracle)
{
    constexpr double kStep = 1e-3;
    Random random(8);
    return largest_curvature(function, sample_surface(oracle, kSamples, random), kStep);
}

//! The thinnest edges curve by at most about 4.2: 4.2 * 0.13^2 / 2 < 0.04.
constexpr MeshingOptions kDoubleTorusOptions{
    .max_facet_radius = 0.13, .max_facet_distance = 0.04, .floor_radius = 0.03, .reach_lower_bound = 0.3};

TEST(Phantom, a_double_torus)
{
    const LevelFunction double_torus = double_torus_phantom({0, 0, 0}, 10.0);
    const Box3 box{{-12, -8, -5}, {12, 8, 5}};
    const SurfaceTopology truth = count_on_lattice(double_torus, box, 81);
    EXPECT_EQ(truth, (SurfaceTopology{.components = 1, .euler_characteristic = -2}));

    const ImplicitOracle oracle(double_torus, box, 1.3, 1e-3);
    const TriangleMesh mesh = mesh_surface(oracle, kDoubleTorusOptions).mesh;
    expect_topology(mesh, truth);
    expect_shape(mesh, kDoubleTorusOptions);
    expect_measures(mesh, oracle);
    expect_size_to_bound_distance(mesh, largest_curvature_of(double_torus, oracle), kDoubleTorusOptions);
    expect_distances(mesh, oracle, *kDoubleTorusOptions.max_facet_distance, 4);
}

//! The signal of Marschner and Lobb, as steep as a distance along z, cut out by a ball whose rim is rounded:
//! smooth, so that everything the criteria ask for can be had. At 0 the signal is the graph of a function of
//! x and y, which the ball closes to a rippled half ball.
LevelFunction smooth_marschner_lobb(const Point3& center)
{
    constexpr double kSlope = 0.06; // of the signal along z, times its scale of 10
    constexpr double kBallRadius = 5.0;
    constexpr double kSharpness = 3.0; // per unit of length: about one over the radius of the rim
    return [center, signal = marschner_lobb_phantom(center, 10.0)](const Point3& p)
    {
        const double ripples = signal(p) / kSlope;
        const double ball = kBallRadius - distance(p, center);
        return std::min(ripples, ball) -
               std::log1p(std::exp(-kSharpness * std::abs(ripples - ball))) / kSharpness;
    };
}

//! The ripples curve by at most about 17.4, so the size bounds the distance: 17.4 * 0.095^2 / 2 < 0.08.
constexpr MeshingOptions kMarschnerLobbOptions{
    .max_facet_radius = 0.095, .max_facet_distance = 0.08, .floor_radius = 0.03, .reach_lower_bound = 0.3};

TEST(Phantom, the_marschner_lobb_signal)
{
    const LevelFunction signal = smooth_marschner_lobb({0, 0, 0});
    const Box3 box{{-6, -6, -6}, {6, 6, 6}};
    const SurfaceTopology truth = count_on_lattice(signal, box, 121);
    EXPECT_EQ(truth, (SurfaceTopology{.components = 1, .euler_characteristic = 2}));

    const ImplicitOracle oracle(signal, box, 10.0, 1e-3);
    const TriangleMesh mesh = mesh_surface(oracle, kMarschnerLobbOptions).mesh;
    expect_topology(mesh, truth);
    expect_shape(mesh, kMarschnerLobbOptions);
    expect_measures(mesh, oracle);
    expect_size_to_bound_distance(mesh, largest_curvature_of(signal, oracle), kMarschnerLobbOptions);
    expect_distances(mesh, oracle, *kMarschnerLobbOptions.max_facet_distance, 5);
}

//! Pieces that are single tetrahedra at a side of the box.
std::size_t count_crumbs(const TriangleMesh& mesh, const Box3& box, double near)
{
    const std::vector<std::uint32_t> piece_of_face = component_of_faces(mesh);
    std::vector<std::size_t> faces_near(count_components(mesh), 0);
    std::vector<std::size_t> faces(faces_near.size(), 0);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    {
        const Point3& corner = mesh.corner(mesh.faces[f], 0);
        ++faces[piece_of_face[f]];
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            if (corner[axis] - box.min[axis] < near || box.max[axis] - corner[axis] < near)
            {
                ++faces_near[piece_of_face[f]];
                break;
            }
        }
    }
    std::size_t crumbs = 0;
    for (std::size_t piece = 0; piece < faces.size(); ++piece)
        crumbs += faces[piece] == 4 && faces_near[piece] == 4 ? 1 : 0;
    return crumbs;
}

TEST(Phantom, the_marschner_lobb_signal_closed_by_its_box)
{
    // The rim is a crease, up to the border of the domain: refinement cuts it off at the floor, and may leave
    // crumbs no larger than that along it, which only an inventory could tell from components. Its reach is
    // 0: probing would meet the rim farther from the mesh than any reach promised, and begin crumbs there.
    const MeshingOptions options{.max_facet_radius = 0.6,
                                 .max_facet_distance = 0.05,
                                 .floor_radius = 0.2,
                                 .reach_lower_bound = 0.3,
                                 .seeding = Seeding::kIsolated};
    const Box3 box{{-6, -6, -6}, {6, 6, 6}};
    const ImplicitOracle oracle(marschner_lobb_phantom({0, 0, 0}, 10.0), box, 0.6, 1e-3);
    const TriangleMesh mesh = mesh_surface(oracle, options).mesh;
    const std::size_t crumbs = count_crumbs(mesh, box, 2.0 * options.floor_radius);
    expect_topology(mesh,
                    {.components = 1 + crumbs, .euler_characteristic = 2 * (1 + static_cast<long>(crumbs))});
    EXPECT_LE(crumbs, 4U);
    EXPECT_LE(longest_edge(mesh), 2.0 * options.max_facet_radius + kRounding);
}

// --- sampled volumes --------------------------------------------------------------------------------

//! The interpolant of a distance to a shape that curves by at most `curvature` departs from it by at most a
//! quarter of the sum of squared spacings times half of that.
double interpolation_error(double curvature, const Vec3& spacing)
{
    return curvature * squared_norm(spacing) / 8.0;
}

TEST(SampledPhantom, a_sphere)
{
    const LevelFunction sphere = sphere_phantom({10.3, 9.8, 10.1}, 8.0);
    const auto oracle = sampled(sphere, {41, 41, 41}, {0.5, 0.5, 0.5});
    const TriangleMesh mesh = mesh_surface(*oracle, kOptions).mesh;
    expect_topology(mesh, {.components = 1, .euler_characteristic = 2});
    expect_measures(mesh, 4.0 * pi * 64.0, 4.0 / 3.0 * pi * 512.0);
    expect_shape(mesh);
    expect_distances(mesh, *oracle, sphere, distance_bound(mesh, 1.0 / 8.0),
                     interpolation_error(1.0 / 8.0, {0.5, 0.5, 0.5}));
}

TEST(SampledPhantom, nested_shells)
{
    const LevelFunction shells = nested_shells_phantom({10.3, 9.8, 10.1}, {9.0, 6.0, 3.5});
    const auto oracle = sampled(shells, {41, 41, 21}, {0.5, 0.5, 1.0});
    const TriangleMesh mesh = mesh_surface(*oracle, kOptions).mesh;
    expect_topology(mesh, {.components = 3, .euler_characteristic = 6});
    expect_measures(mesh, 4.0 * pi * (81.0 + 36.0 + 12.25), 4.0 / 3.0 * pi * (729.0 - 216.0 + 42.875));
    expect_shape(mesh);
    expect_distances(mesh, *oracle, shells, distance_bound(mesh, 1.0 / 3.5),
                     interpolation_error(1.0 / 3.5, {0.5, 0.5, 1.0}));
}

TEST(SampledPhantom, a_torus)
{
    const LevelFunction torus = torus_phantom({12.1, 11.9, 5.2}, 8.0, 3.0);
    const auto oracle = sampled(torus, {97, 97, 41}, {0.25, 0.25, 0.25});
    const TriangleMesh mesh = mesh_surface(*oracle, kTorusOptions).mesh;
    expect_topology(mesh, {.components = 1, .euler_characteristic = 0});
    expect_measures(mesh, 4.0 * pi * pi * 24.0, 2.0 * pi * pi * 72.0);
    expect_shape(mesh, kTorusOptions);
    expect_distances(mesh, *oracle, torus, distance_bound(mesh, 1.0 / 3.0, kTorusOptions),
                     interpolation_error(1.0 / 3.0, {0.25, 0.25, 0.25}));
}

TEST(SampledPhantom, a_double_torus)
{
    const LevelFunction double_torus = double_torus_phantom({12, 8, 4}, 10.0);
    const auto oracle = sampled(double_torus, {193, 129, 65}, {0.125, 0.125, 0.125});
    const TriangleMesh mesh = mesh_surface(*oracle, kDoubleTorusOptions).mesh;
    expect_topology(mesh, {.components = 1, .euler_characteristic = -2});
    expect_shape(mesh, kDoubleTorusOptions);
    expect_measures(mesh, *oracle);
    expect_distances(mesh, *oracle, *kDoubleTorusOptions.max_facet_distance, 6);
}

TEST(SampledPhantom, the_marschner_lobb_signal)
{
    const auto oracle = sampled(smooth_marschner_lobb({6, 6, 6}), {193, 193, 193}, {0.0625, 0.0625, 0.0625});
    const TriangleMesh mesh = mesh_surface(*oracle, kMarschnerLobbOptions).mesh;
    expect_topology(mesh, {.components = 1, .euler_characteristic = 2});
    expect_shape(mesh, kMarschnerLobbOptions);
    expect_measures(mesh, *oracle);
    expect_distances(mesh, *oracle, *kMarschnerLobbOptions.max_facet_distance, 7);
}

} // namespace
} // namespace voroprobe
