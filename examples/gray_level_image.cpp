// gray_level_image SCAN ISOVALUE MESH: the isosurface of a volume in any format that is read.

#include <cstdlib>
#include <iostream>
#include <memory>

#include "io/mesh_writer.h"
#include "io/volume_reader.h"
#include "mesh/topology.h"
#include "mesher/seeded_mesher.h"
#include "oracles/trilinear_oracle.h"

int main(int argc, char** argv)
{
    using namespace voroprobe;
    if (argc != 4)
        return 2;

    const auto volume = std::make_shared<const Volume>(read_volume(argv[1]).volume);
    const auto oracle = make_trilinear_oracle(volume, std::strtod(argv[2], nullptr));
    const double voxel = volume->geometry.min_spacing(); // mm

    TriangleMesh mesh = mesh_surface(*oracle, {.max_facet_radius = 2 * voxel,
                                               .max_facet_distance = 0.3 * voxel,
                                               .floor_radius = 0.25 * voxel,
                                               .reach_lower_bound = voxel})
                            .mesh;

    transform(mesh, volume->geometry.world_from_grid); // from the axes of the samples to those of the scanner
    write_mesh(mesh, argv[3], mesh_format(argv[3]));
    std::cout << count_components(mesh) << " surfaces, " << mesh.faces.size() << " faces\n";
    return is_closed_manifold(mesh) ? 0 : 1;
}
