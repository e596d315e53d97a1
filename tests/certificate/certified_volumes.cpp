#include "certified_volumes.h"

#include <memory>
#include <span>

#include "certificate/certificate.h"
#include "io/float_rounding.h"
#include "mesh/topology.h"
#include "mesher/seeded_mesher.h"
#include "oracles/trilinear_oracle.h"
#include "self_intersections.h"

namespace voroprobe
{

namespace
{

bool is_manifold(const TriangleMesh& mesh, BorderCaps caps)
{
    return caps == BorderCaps::kCounted ? is_closed_manifold(mesh) : analyze_topology(mesh).manifold();
}

std::optional<std::string> what_is_wrong(const RandomVolume& random, BorderCaps caps)
{
    const LevelledVolume levelled = level_volume(random.volume, random.isovalue);
    const auto inventory = std::make_shared<const Inventory>(*make_height_field(levelled));
    const auto oracle = make_trilinear_oracle(levelled, inventory);
    const double voxel = random.volume->geometry.min_spacing();
    const MeshingResult result = mesh_surface(*oracle, {.max_facet_radius = 2.0 * voxel,
                                                        .max_facet_distance = 0.3 * voxel,
                                                        .floor_radius = 0.25 * voxel,
                                                        .reach_lower_bound = 0.5 * voxel,
                                                        .close_border = caps == BorderCaps::kCounted});
    const TriangleMesh mesh = weld(result.mesh);
    const Certificate certificate = certify(
        mesh, *oracle, inventory->surfaces(),
        {.reach = voxel, .floor_radius = 0.25 * voxel, .caps = caps, .test_self_intersections = false},
        std::span<const SurfaceId>(result.surface_of_face));
    if (auto broken = broken_promise(certificate))
        return broken;
    if (const auto crossing = find_self_intersections(mesh); !crossing.empty())
        return std::to_string(crossing.size()) + " pairs of faces that cross";
    if (!is_manifold(weld(round_to_float(mesh).mesh), caps))
        return "defects once rounded to 32-bit floats";
    return std::nullopt;
}

} // namespace

std::optional<std::string> what_is_wrong_with_the_mesh_of(const RandomVolume& random)
{
    return what_is_wrong(random, BorderCaps::kCounted);
}

std::optional<std::string> what_is_wrong_with_the_open_mesh_of(const RandomVolume& random)
{
    return what_is_wrong(random, BorderCaps::kLeftOut);
}

} // namespace voroprobe
