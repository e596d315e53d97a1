// triangle_mesh IN OUT: meshes the surface of a closed mesh anew, with triangles of one size.

#include <iostream>

#include "io/mesh_reader.h"
#include "io/mesh_writer.h"
#include "mesh/topology.h"
#include "mesher/seeded_mesher.h"
#include "oracles/triangle_mesh_oracle.h"

int main(int argc, char** argv)
{
    using namespace voroprobe;
    if (argc != 3)
        return 2;

    const TriangleMesh before = read_mesh(argv[1]);
    const auto oracle = make_triangle_mesh_oracle(before, argv[1]); // refuses what is open or crosses itself
    const double size = 0.02 * bounding_box(before).diagonal();

    const TriangleMesh mesh = mesh_surface(*oracle, {.max_facet_radius = size,
                                                     .max_facet_distance = 0.1 * size,
                                                     .floor_radius = 0.1 * size,
                                                     .reach_lower_bound = size})
                                  .mesh;

    write_mesh(mesh, argv[2], mesh_format(argv[2]));
    std::cout << before.faces.size() << " faces before, " << mesh.faces.size() << " now\n";
    return is_closed_manifold(mesh) && euler_characteristic(mesh) == euler_characteristic(before) ? 0 : 1;
}
