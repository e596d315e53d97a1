#include <iostream>

#include "mesh/topology.h"
#include "mesher/seeded_mesher.h"
#include "oracles/sphere_union_oracle.h"

int main()
{
    const voroprobe::SphereUnionOracle oracle({{.center = {0, 0, 0}, .radius = 10.0}});
    const auto result = voroprobe::mesh_surface(
        oracle, {.max_facet_radius = 2.0, .floor_radius = 0.1, .reach_lower_bound = 9.0});

    std::cout << result.mesh.vertices.size() << " vertices, " << result.mesh.faces.size() << " faces\n";
    const bool is_a_sphere =
        voroprobe::is_closed_manifold(result.mesh) && voroprobe::euler_characteristic(result.mesh) == 2;
    return is_a_sphere ? 0 : 1;
}
