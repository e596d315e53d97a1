// point_cloud CLOUD.xyz MESH: samples a torus, writes the points with their normals, and meshes the surface
// that fits them.

#include <cmath>
#include <fstream>
#include <iostream>
#include <numbers>

#include "io/mesh_writer.h"
#include "io/point_cloud_reader.h"
#include "mesh/topology.h"
#include "mesher/seeded_mesher.h"
#include "oracles/point_cloud_oracle.h"

namespace
{

void write_torus(const char* path)
{
    std::ofstream file(path);
    for (int i = 0; i < 90; ++i)
        for (int j = 0; j < 30; ++j)
        {
            const double a = 2.0 * std::numbers::pi * i / 90;
            const double b = 2.0 * std::numbers::pi * j / 30;
            const voroprobe::Vec3 n{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
            file << 3.0 * std::cos(a) + n.x << ' ' << 3.0 * std::sin(a) + n.y << ' ' << n.z << ' ' << n.x
                 << ' ' << n.y << ' ' << n.z << '\n';
        }
}

} // namespace

int main(int argc, char** argv)
{
    using namespace voroprobe;
    if (argc != 3)
        return 2;

    write_torus(argv[1]);
    const auto oracle = make_point_cloud_oracle(read_point_cloud(argv[1]), argv[1]);
    const TriangleMesh mesh =
        mesh_surface(*oracle, {.max_facet_radius = 0.3, .floor_radius = 0.05, .reach_lower_bound = 0.3}).mesh;

    write_mesh(mesh, argv[2], mesh_format(argv[2]));
    std::cout << count_components(mesh) << " surfaces, " << mesh.faces.size() << " faces\n";
    return is_closed_manifold(mesh) && euler_characteristic(mesh) == 0 ? 0 : 1;
}
