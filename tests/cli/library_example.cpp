#include <memory>
#include <utility>

#include "io/mesh_writer.h"
#include "io/volume_reader.h"
#include "mesher/seeded_mesher.h"
#include "oracles/trilinear_oracle.h"

// Usage: library_example SCAN MESH
int main(int argc, char** argv)
{
    using namespace voroprobe;
    if (argc != 3)
        return 2;

    const auto volume = std::make_shared<const Volume>(read_volume(argv[1]).volume);
    const double voxel = volume->geometry.min_spacing(); // mm
    const auto bone = make_trilinear_oracle(volume, 1150.5);

    MeshingResult result = mesh_surface(*bone, {.max_facet_radius = 3 * voxel,
                                                .max_facet_distance = 0.3 * voxel,
                                                .floor_radius = 0.25 * voxel,
                                                .reach_lower_bound = voxel});

    transform(result.mesh, volume->geometry.world_from_grid); // from the grid's frame to the scanner's, LPS
    write_mesh(result.mesh, argv[2], mesh_format(argv[2]));
    return result.mesh.faces.empty() ? 1 : 0;
}
