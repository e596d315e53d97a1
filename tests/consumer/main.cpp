// consumer OUTPUT: writes a meshed sphere to OUTPUT, in the format its extension names, and reads it back.
#include <iostream>

#include "io/mesh_reader.h"
#include "io/mesh_writer.h"
#include "mesh/topology.h"
#include "mesher/seeded_mesher.h"
#include "oracles/sphere_union_oracle.h"

namespace
{

bool is_a_sphere(const voroprobe::TriangleMesh& mesh)
{
    return voroprobe::is_closed_manifold(mesh) && voroprobe::euler_characteristic(mesh) == 2;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2)
        return 2;
    const voroprobe::SphereUnionOracle oracle({{.center = {0, 0, 0}, .radius = 10.0}});
    const auto result = voroprobe::mesh_surface(
        oracle, {.max_facet_radius = 2.0, .floor_radius = 0.1, .reach_lower_bound = 9.0});
    voroprobe::write_mesh(result.mesh, argv[1], voroprobe::mesh_format(argv[1]));

    std::cout << result.mesh.vertices.size() << " vertices, " << result.mesh.faces.size() << " faces\n";
    return is_a_sphere(result.mesh) && is_a_sphere(voroprobe::read_mesh(argv[1])) ? 0 : 1;
}
