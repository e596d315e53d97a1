#include "compare/measurement.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../mesh/sample_meshes.h"
#include "compared_phantom.h"

namespace voroprobe
{

namespace
{

constexpr MeasuringOptions kOptions{.mesh_samples = 4000};
const Point3 kCenter{16, 16, 16};

//! What a trilinear interpolant of one sample per mm may be off the distance to a surface of this radius of
//! curvature: a linear interpolant is off by at most h^2/8 times the curvature along each of the three axes;
//! and as much for faces of the mesh that are chords.
double tolerance(double radius)
{
    return 3.0 / (8.0 * radius) + 0.01;
}

TriangleMesh moved(TriangleMesh mesh, const Vec3& by)
{
    for (Point3& p : mesh.vertices)
        p += by;
    return mesh;
}

void expect_offset(const TriangleMesh& mesh, const ReferenceSurface& reference, double offset, double radius)
{
    const TwoSidedDistance distance = measure_distance(mesh, reference, kOptions);
    EXPECT_NEAR(distance.mean, offset, tolerance(radius));
    EXPECT_NEAR(distance.root_mean_square, offset, tolerance(radius));
    EXPECT_NEAR(distance.max, offset, tolerance(radius));
    EXPECT_NEAR(distance.percentile_95, offset, tolerance(radius));
    EXPECT_LE(distance.mean, distance.root_mean_square);
    EXPECT_LE(distance.percentile_95, distance.max);
}

TEST(Measurement, the_distance_of_concentric_spheres_is_the_difference_of_their_radii)
{
    const ComparedPhantom phantom = compared_phantom(sphere_phantom(kCenter, 12.0), {33, 33, 33});
    for (const double offset : {0.3, 1.5})
        expect_offset(moved(sample::icosphere(5, 12.0 - offset), kCenter), phantom.reference, offset, 12.0);
}

TEST(Measurement, the_distance_of_tori_is_the_difference_of_their_minor_radii)
{
    const ComparedPhantom phantom = compared_phantom(torus_phantom(kCenter, 10.0, 5.0), {33, 33, 33});
    expect_offset(moved(sample::torus(300, 150, 10.0, 4.4), kCenter), phantom.reference, 0.6, 5.0);
}

TEST(Measurement, a_bump_shows_in_the_largest_distance_and_hardly_in_the_mean)
{
    const ComparedPhantom phantom = compared_phantom(sphere_phantom(kCenter, 12.0), {33, 33, 33});
    TriangleMesh mesh = moved(sample::icosphere(4, 12.0), kCenter);
    mesh.vertices.front() += 3.0 * normalized(mesh.vertices.front() - kCenter);
    const TwoSidedDistance distance =
        measure_distance(mesh, phantom.reference, {.mesh_samples = 10 * mesh.vertices.size()});
    EXPECT_NEAR(distance.max, 3.0, tolerance(12.0));
    EXPECT_LT(distance.mean, tolerance(12.0) + 0.01);
}

//! Spheres in a row, the mesh of each known, and some of them taken away.
TEST(Measurement, surfaces_whose_mesh_was_removed_are_listed_as_missing)
{
    const std::vector<double> radii{3.0, 1.5, 2.5, 1.2, 2.0};
    const std::set<std::size_t> removed{1, 3};
    std::vector<LevelFunction> shapes;
    TriangleMesh mesh;
    for (std::size_t i = 0; i < radii.size(); ++i)
    {
        const Point3 center{8.3 + 9.0 * static_cast<double>(i), 8.1, 8.2};
        shapes.push_back(sphere_phantom(center, radii[i]));
        if (!removed.contains(i))
            sample::append(mesh, sample::icosphere(3, radii[i]), center);
    }
    const ComparedPhantom phantom = compared_phantom(union_of(shapes), {52, 17, 17});
    const Measurement measurement = measure(mesh, phantom.reference, kOptions);
    EXPECT_EQ(measurement.certificate.surfaces_expected, radii.size());
    EXPECT_EQ(measurement.certificate.surfaces_meshed, radii.size() - removed.size());
    ASSERT_EQ(measurement.certificate.missing.size(), removed.size());
    const auto report = to_json(measurement, phantom.reference);
    std::set<std::size_t> places;
    for (const auto& missing : report.at("surfaces").at("missing"))
        places.insert(
            static_cast<std::size_t>(std::lround((missing.at("center_mm").at(0).get<double>() - 8.3) / 9.0)));
    EXPECT_EQ(places, removed);
}

TEST(Measurement, the_report_has_what_a_sphere_is)
{
    const ComparedPhantom phantom = compared_phantom(sphere_phantom(kCenter, 12.0), {33, 33, 33});
    const TriangleMesh mesh = moved(sample::icosphere(4, 12.0), kCenter);
    const auto report = to_json(measure(mesh, phantom.reference, kOptions), phantom.reference);
    EXPECT_EQ(report.at("faces"), 20 * 256);
    EXPECT_EQ(report.at("topology").at("genus"), 0);
    EXPECT_EQ(report.at("topology").at("self_intersections"), 0);
    EXPECT_TRUE(report.at("topology").at("closed"));
    EXPECT_TRUE(report.at("topology").at("oriented"));
    EXPECT_NEAR(report.at("area_mm2"), 4.0 * M_PI * 144.0, 5.0);
    EXPECT_EQ(report.at("angles").at("faces_below_30"), 0);
}

} // namespace

} // namespace voroprobe
