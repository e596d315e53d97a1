#include "certificate/certificate.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"
#include "certificate/surface_assignment.h"
#include "oracles/sphere_union_oracle.h"
#include "support/error.h"
#include "support/random.h"

namespace voroprobe
{
namespace
{

//! Spheres with an inventory: surface i is sphere i.
class SpheresWithInventory final : public SurfaceOracle
{
public:
    explicit SpheresWithInventory(std::vector<Sphere> spheres) : spheres_(spheres), plain_(spheres) {}

    [[nodiscard]] Box3 domain() const override { return plain_.domain(); }
    [[nodiscard]] Region region(const Point3& p) const override { return plain_.region(p); }
    void find_crossings(const Segment3& segment, std::vector<Crossing>& crossings) const override
    {
        plain_.find_crossings(segment, crossings);
    }
    [[nodiscard]] bool may_cross(const Box3& box) const override { return plain_.may_cross(box); }

    [[nodiscard]] SurfaceId surface_at(const Point3& crossing) const override
    {
        for (std::size_t i = 0; i < spheres_.size(); ++i)
            if (std::abs(distance(crossing, spheres_[i].center) - spheres_[i].radius) < 1e-9)
                return static_cast<SurfaceId>(i);
        return kNoSurface;
    }

    //! For points_on(), whatever the surface.
    void set_points(std::vector<Point3> points) { points_ = std::move(points); }

    [[nodiscard]] std::vector<std::vector<Point3>> points_on(std::span<const SurfaceId> surfaces,
                                                             std::size_t /*most*/) const override
    {
        return std::vector<std::vector<Point3>>(surfaces.size(), points_);
    }

    [[nodiscard]] std::vector<ScanSurface> inventory() const
    {
        std::vector<ScanSurface> surfaces;
        for (const Sphere& sphere : spheres_)
        {
            const Vec3 r{sphere.radius, sphere.radius, sphere.radius};
            const bool cavity = !is_inside(plain_.region(sphere.center + 0.99 * Vec3{sphere.radius, 0, 0}));
            surfaces.push_back(
                {.inside = 1,
                 .outside = kOuterRegion,
                 .parent = kNoSurface,
                 .cavity = cavity,
                 .box = {sphere.center - r, sphere.center + r},
                 .enclosed_samples = static_cast<std::size_t>(4.18 * std::pow(sphere.radius, 3)),
                 .point = sphere.center + Vec3{sphere.radius, 0, 0},
                 .touches_border = false,
                 .euler_characteristic = 2});
        }
        return surfaces;
    }

private:
    std::vector<Sphere> spheres_;
    SphereUnionOracle plain_;
    std::vector<Point3> points_;
};

TriangleMesh turned_inside_out(TriangleMesh mesh)
{
    for (TriangleMesh::Face& face : mesh.faces)
        std::swap(face[0], face[1]);
    return mesh;
}

//! A ball with a cavity, a small ball beside it, and a speck far off.
class CertificateTest : public testing::Test
{
protected:
    CertificateTest()
    {
        sample::append(mesh_, sample::icosphere(3, 10.0));
        sample::append(mesh_, turned_inside_out(sample::icosphere(3, 4.0)));
        sample::append(mesh_, sample::icosphere(2, 2.0), {14, 0, 0});
        sample::append(mesh_, sample::icosphere(1, 0.5), {0, 20, 0});
    }

    //! The mesh without one of its four spheres.
    [[nodiscard]] TriangleMesh mesh_without(std::uint32_t piece) const
    {
        const auto pieces = component_of_faces(mesh_);
        TriangleMesh rest{.vertices = mesh_.vertices, .faces = {}};
        for (std::size_t f = 0; f < pieces.size(); ++f)
            if (pieces[f] != piece)
                rest.faces.push_back(mesh_.faces[f]);
        return rest;
    }

    [[nodiscard]] Certificate certificate_of(const TriangleMesh& mesh) const
    {
        return certify(mesh, oracle_, oracle_.inventory(), options_);
    }

    SpheresWithInventory oracle_{{{{0, 0, 0}, 10.0}, {{0, 0, 0}, 4.0}, {{14, 0, 0}, 2.0}, {{0, 20, 0}, 0.5}}};
    CertificateOptions options_{.reach = 0.5, .sampling = {.mesh_samples = 1000, .surface_samples = 1000}};
    TriangleMesh mesh_;
};

TEST_F(CertificateTest, of_the_whole_mesh_is_complete)
{
    const Certificate certificate = certificate_of(mesh_);
    EXPECT_EQ(certificate.surfaces_expected, 4U);
    EXPECT_EQ(certificate.surfaces_meshed, 4U);
    EXPECT_TRUE(certificate.complete());
    EXPECT_TRUE(certificate.closed && certificate.manifold() && certificate.oriented());
    EXPECT_EQ(certificate.self_intersections, 0U);
    EXPECT_TRUE(certificate.genus_mismatches.empty());
    EXPECT_EQ(broken_promise(certificate), std::nullopt);
    EXPECT_LT(certificate.distance.max(), 0.4);
}

TEST_F(CertificateTest, names_a_missing_speck_with_its_place)
{
    const Certificate certificate = certificate_of(mesh_without(3));
    ASSERT_EQ(certificate.missing.size(), 1U);
    EXPECT_EQ(certificate.missing[0].id, 3);
    EXPECT_EQ(certificate.missing[0].reason, "no vertex of the mesh lies on it");
    EXPECT_EQ(certificate.missing[0].box.min.y, 19.5);
    EXPECT_EQ(certificate.surfaces_meshed, 3U);
    EXPECT_FALSE(certificate.complete());
    EXPECT_EQ(broken_promise(certificate), "1 surface missing");
    EXPECT_GT(certificate.distance.from_surface.max, 9.0) << "its point is sampled whatever the lines meet";
}

TEST_F(CertificateTest, names_a_missing_cavity)
{
    const Certificate certificate = certificate_of(mesh_without(1));
    ASSERT_EQ(certificate.missing.size(), 1U);
    EXPECT_EQ(certificate.missing[0].id, 1);
}

TEST_F(CertificateTest, does_not_miss_what_was_dropped_on_purpose)
{
    options_.dropped = {{3, "encloses less than 5 mm3"}};
    const Certificate certificate = certificate_of(mesh_without(3));
    EXPECT_EQ(certificate.surfaces_expected, 3U);
    EXPECT_TRUE(certificate.complete());
    ASSERT_EQ(certificate.dropped.size(), 1U);
    EXPECT_EQ(certificate.dropped[0].reason, "encloses less than 5 mm3");
    EXPECT_LT(certificate.distance.from_surface.max, 12.0);
}

TEST_F(CertificateTest, names_the_surface_another_was_merged_with)
{
    // A tube between the ball and its neighbour: one face of each, over which the two are drawn together.
    TriangleMesh mesh = mesh_;
    const auto pieces = component_of_faces(mesh);
    const auto face_of = [&](std::uint32_t piece, const Point3& towards)
    {
        std::size_t best = 0;
        double nearest = 1e9;
        for (std::size_t f = 0; f < mesh.faces.size(); ++f)
            if (pieces[f] == piece && distance(mesh.corner(mesh.faces[f], 0), towards) < nearest)
            {
                nearest = distance(mesh.corner(mesh.faces[f], 0), towards);
                best = f;
            }
        return best;
    };
    const std::size_t f = face_of(0, {11, 0, 0});
    const std::size_t g = face_of(2, {11, 0, 0});
    const auto [a, b, c] = mesh.faces[f];
    const auto [p, q, r] = mesh.faces[g];
    mesh.faces[f] = {a, b, p};
    mesh.faces[g] = {b, r, p};
    mesh.faces.insert(mesh.faces.end(), {{b, c, r}, {c, q, r}, {c, a, q}, {a, p, q}});

    options_.test_self_intersections = false;
    const Certificate certificate = certificate_of(mesh);
    ASSERT_EQ(certificate.missing.size(), 1U);
    EXPECT_EQ(certificate.missing[0].id, 2);
    EXPECT_EQ(certificate.missing[0].reason, "merged with surface 0");
    EXPECT_EQ(certificate.topology.components, 3U);
    EXPECT_TRUE(certificate.closed);
    EXPECT_EQ(certificate.self_intersections, std::nullopt);
}

TEST_F(CertificateTest, names_a_surface_in_two_pieces)
{
    TriangleMesh mesh = mesh_;
    sample::append(mesh, sample::icosphere(2, 1.99), {14, 0, 0});
    const Certificate certificate = certificate_of(mesh);
    ASSERT_EQ(certificate.split.size(), 1U);
    EXPECT_EQ(certificate.split[0].id, 2);
    EXPECT_EQ(certificate.split[0].pieces, 2U);
    EXPECT_EQ(certificate.surfaces_meshed, 4U);
    EXPECT_FALSE(certificate.complete());
    ASSERT_EQ(certificate.genus_mismatches.size(), 1U);
    EXPECT_EQ(certificate.genus_mismatches[0].mesh_euler_characteristic, 4);
}

TEST_F(CertificateTest, names_a_piece_on_no_surface)
{
    TriangleMesh mesh = mesh_;
    sample::append(mesh, sample::icosphere(2, 1.0), {-14, 0, 0});
    const Certificate certificate = certificate_of(mesh);
    ASSERT_EQ(certificate.foreign.size(), 1U);
    EXPECT_EQ(certificate.foreign[0].faces, 320U);
    EXPECT_EQ(broken_promise(certificate), "1 piece on no surface of the scan");
}

TEST_F(CertificateTest, names_a_surface_whose_piece_has_a_hole)
{
    TriangleMesh mesh = mesh_;
    mesh.faces.pop_back();
    const Certificate certificate = certificate_of(mesh);
    ASSERT_EQ(certificate.missing.size(), 1U);
    EXPECT_EQ(certificate.missing[0].reason, "its piece is not closed: 3 edges are on one face only");
    EXPECT_FALSE(certificate.closed);
}

TEST_F(CertificateTest, finds_a_cavity_that_winds_outward)
{
    TriangleMesh mesh = mesh_without(1);
    sample::append(mesh, sample::icosphere(3, 4.0));
    const Certificate certificate = certificate_of(mesh);
    EXPECT_EQ(certificate.surfaces_inside_out, 1U);
    EXPECT_FALSE(certificate.oriented());
    EXPECT_EQ(broken_promise(certificate), "1 surface inside out");
}

TEST_F(CertificateTest, finds_another_number_of_handles)
{
    auto inventory = oracle_.inventory();
    inventory[0].euler_characteristic = 0;
    const Certificate certificate = certify(mesh_, oracle_, inventory, options_);
    ASSERT_EQ(certificate.genus_mismatches.size(), 1U);
    EXPECT_EQ(certificate.genus_mismatches[0].expected_euler_characteristic, 0);
    EXPECT_EQ(certificate.genus_mismatches[0].mesh_euler_characteristic, 2);
    EXPECT_TRUE(certificate.complete()) << "handles are listed, they are no part of the promise";
}

TEST_F(CertificateTest, believes_the_maker_of_the_mesh_where_it_names_the_surfaces)
{
    const auto pieces = component_of_faces(mesh_);
    std::vector<SurfaceId> surface_of_face(pieces.begin(), pieces.end());
    const auto inventory = oracle_.inventory();
    EXPECT_TRUE(certify(mesh_, oracle_, inventory, options_, surface_of_face).complete());

    std::replace(surface_of_face.begin(), surface_of_face.end(), 3, 2);
    const Certificate certificate = certify(mesh_, oracle_, inventory, options_, surface_of_face);
    EXPECT_EQ(certificate.missing.size(), 1U);
    EXPECT_EQ(certificate.split.size(), 1U);

    surface_of_face.pop_back();
    EXPECT_THROW(certify(mesh_, oracle_, inventory, options_, surface_of_face), UsageError);
}

TEST_F(CertificateTest, finds_the_surfaces_of_vertices_that_lie_beside_them)
{
    TriangleMesh mesh = mesh_;
    Random random(1);
    for (Point3& p : mesh.vertices)
        p += Vec3{random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05)};
    const auto pieces = component_of_faces(mesh);
    const auto surfaces = surface_of_vertices(mesh, oracle_, 0.5);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        for (const std::uint32_t v : mesh.faces[f])
            ASSERT_EQ(surfaces[v], static_cast<SurfaceId>(pieces[f]));
}

TEST_F(CertificateTest, takes_sheets_for_one_surface_where_the_border_is_open)
{
    // Two spheres without one face each stand for what the border leaves of the small ball.
    TriangleMesh mesh = mesh_without(2);
    for (const double radius : {2.0, 1.99})
    {
        TriangleMesh sheet = sample::icosphere(2, radius);
        sheet.faces.pop_back();
        sample::append(mesh, sheet, {14, 0, 0});
    }
    auto inventory = oracle_.inventory();
    inventory[2].touches_border = true;
    options_.caps = BorderCaps::kLeftOut;
    const Certificate sheets = certify(mesh, oracle_, inventory, options_);
    EXPECT_TRUE(sheets.split.empty());
    EXPECT_TRUE(sheets.complete());
    EXPECT_EQ(broken_promise(sheets), std::nullopt);

    sample::append(mesh, sample::icosphere(1, 1.98), {14, 0, 0});
    const Certificate with_closed_piece = certify(mesh, oracle_, inventory, options_);
    ASSERT_EQ(with_closed_piece.split.size(), 1U) << "no border cuts off a closed piece";
    EXPECT_EQ(with_closed_piece.split[0].pieces, 3U);
}

TEST_F(CertificateTest, lists_what_lies_in_an_open_border_instead_of_missing_it)
{
    // The speck's points lie at the top of the domain, or a floor's diameter below it.
    const Point3 top{0, oracle_.domain().max.y, 0};
    auto inventory = oracle_.inventory();
    inventory[3].touches_border = true;
    options_.floor_radius = 0.1;
    oracle_.set_points({top, top - Vec3{0, 0.15, 0}});
    EXPECT_EQ(certify(mesh_without(3), oracle_, inventory, options_).missing.size(), 1U) << "closed";

    options_.caps = BorderCaps::kLeftOut;
    const Certificate certificate = certify(mesh_without(3), oracle_, inventory, options_);
    EXPECT_TRUE(certificate.missing.empty());
    ASSERT_EQ(certificate.in_border.size(), 1U);
    EXPECT_EQ(certificate.in_border[0].id, 3);
    EXPECT_EQ(certificate.surfaces_expected, 3U);
    EXPECT_TRUE(certificate.complete());

    oracle_.set_points({top, top - Vec3{0, 0.25, 0}});
    const Certificate deeper = certify(mesh_without(3), oracle_, inventory, options_);
    EXPECT_EQ(deeper.missing.size(), 1U);
    EXPECT_TRUE(deeper.in_border.empty());
}

TEST_F(CertificateTest, of_an_empty_mesh_misses_everything)
{
    const Certificate certificate = certificate_of({});
    EXPECT_EQ(certificate.missing.size(), 4U);
    EXPECT_TRUE(std::isinf(certificate.distance.max()));
}

TEST_F(CertificateTest, refuses_a_reach_of_nothing)
{
    options_.reach = 0.0;
    EXPECT_THROW(certificate_of(mesh_), UsageError);
}

} // namespace
} // namespace voroprobe
