// openvdb_grid GRID.vdb MESH: writes a level set with OpenVDB, as any program may, and meshes it without
// making it dense.

#include <iostream>

#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetSphere.h>

#include "io/mesh_writer.h"
#include "mesh/topology.h"
#include "mesher/seeded_mesher.h"
#include "oracles/vdb_oracle.h"

int main(int argc, char** argv)
{
    using namespace voroprobe;
    if (argc != 3)
        return 2;

    constexpr float kRadius = 3.0F;
    constexpr float kVoxel = 0.2F;
    openvdb::initialize();
    const auto grid = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(kRadius, {}, kVoxel);
    openvdb::io::File(argv[1]).write({grid});

    const VdbSurface surface =
        read_vdb_surface(argv[1]); // the zero set of a level set, unless told otherwise
    TriangleMesh mesh = mesh_surface(*surface.oracle, {.max_facet_radius = 2 * surface.voxel_size,
                                                       .max_facet_distance = 0.3 * surface.voxel_size,
                                                       .floor_radius = 0.25 * surface.voxel_size,
                                                       .reach_lower_bound = surface.voxel_size})
                            .mesh;

    transform(mesh, surface.world_from_grid);
    write_mesh(mesh, argv[2], mesh_format(argv[2]));
    std::cout << count_components(mesh) << " surfaces, " << mesh.faces.size() << " faces\n";
    return is_closed_manifold(mesh) ? 0 : 1;
}
