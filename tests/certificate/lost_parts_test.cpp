#include "certificate/lost_parts.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "../mesh/sample_meshes.h"
#include "certificate/certificate.h"
#include "oracles/trilinear_oracle.h"
#include "volume/phantoms.h"

namespace voroprobe
{
namespace
{

constexpr double kLength = 30.0;

//! A rod along x from 4 to 4 + kLength, `thickness` across, about y = z = 6.
class RodTest : public testing::Test
{
protected:
    void scan_rod(double thickness)
    {
        const LevelFunction rod = [thickness](const Point3& p)
        {
            return std::min({p.x - 4.0, 4.0 + kLength - p.x, 0.5 * thickness - std::abs(p.y - 6.0),
                             0.5 * thickness - std::abs(p.z - 6.0)});
        };
        const auto volume = std::make_shared<Volume>(sample_volume(rod, {39, 13, 13}, {1, 1, 1}));
        const LevelledVolume levelled = level_volume(volume, 0.0);
        inventory_ = std::make_shared<const Inventory>(*make_height_field(levelled), 1);
        oracle_ = make_trilinear_oracle(levelled, inventory_);
    }

    //! The first part of the rod, as a box cut into rings of faces with sides of a unit along x.
    [[nodiscard]] static TriangleMesh mesh_of_part(double length, double thickness)
    {
        TriangleMesh mesh;
        const auto rings = static_cast<std::uint32_t>(length);
        const double half = 0.5 * thickness;
        for (std::uint32_t ring = 0; ring <= rings; ++ring)
            for (const auto& [y, z] : {std::pair(-half, -half), {half, -half}, {half, half}, {-half, half}})
                mesh.vertices.push_back({4.0 + ring, 6.0 + y, 6.0 + z});
        for (std::uint32_t ring = 0; ring < rings; ++ring)
            for (std::uint32_t side = 0; side < 4; ++side)
            {
                const std::uint32_t a = 4 * ring + side;
                const std::uint32_t b = 4 * ring + (side + 1) % 4;
                mesh.faces.push_back({a, b, b + 4});
                mesh.faces.push_back({a, b + 4, a + 4});
            }
        const std::uint32_t last = 4 * rings;
        for (const TriangleMesh::Face& cap : std::initializer_list<TriangleMesh::Face>{
                 {0, 2, 1}, {0, 3, 2}, {last, last + 1, last + 2}, {last, last + 2, last + 3}})
            mesh.faces.push_back(cap);
        return mesh;
    }

    [[nodiscard]] Certificate certificate_of(const TriangleMesh& mesh) const
    {
        return certify(mesh, *oracle_, inventory_->surfaces(), {.reach = 1.0, .floor_radius = 0.25});
    }

    std::shared_ptr<const Inventory> inventory_;
    std::shared_ptr<const SurfaceOracle> oracle_;
};

TEST_F(RodTest, from_end_to_end_is_complete)
{
    scan_rod(3.0);
    const Certificate certificate = certificate_of(mesh_of_part(kLength, 3.0));
    EXPECT_TRUE(certificate.complete());
    EXPECT_TRUE(certificate.lost_parts.empty());
}

TEST_F(RodTest, of_which_a_third_is_missing_is_not)
{
    scan_rod(3.0);
    const Certificate certificate = certificate_of(mesh_of_part(20.0, 3.0));
    EXPECT_EQ(certificate.surfaces_meshed, 1U); // closed, manifold, on the surface
    ASSERT_EQ(certificate.lost_parts.size(), 1U);
    EXPECT_FALSE(certificate.lost_parts[0].is_hair());
    EXPECT_GT(certificate.lost_parts[0].place.x, 24.0);
    EXPECT_FALSE(certificate.complete());
    EXPECT_TRUE(broken_promise(certificate).has_value());
}

TEST_F(RodTest, that_is_a_hair_there_is_told_but_no_promise_broken)
{
    scan_rod(0.4); // by one sample: less than twice the floor
    const Certificate certificate = certificate_of(mesh_of_part(20.0, 0.1));
    ASSERT_EQ(certificate.lost_parts.size(), 1U);
    EXPECT_TRUE(certificate.lost_parts[0].is_hair());
    EXPECT_TRUE(certificate.complete());
}

} // namespace
} // namespace voroprobe
