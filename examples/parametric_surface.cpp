// parametric_surface MESH: a knotted tube, given by two parameters.

#include <cmath>
#include <iostream>
#include <numbers>

#include "io/mesh_writer.h"
#include "mesh/topology.h"
#include "mesher/seeded_mesher.h"
#include "oracles/parametric_oracle.h"

namespace
{

using voroprobe::Point3;
using voroprobe::Vec3;

//! A trefoil knot, once around for t from 0 to 1.
Point3 knot(double t)
{
    const double a = 2.0 * std::numbers::pi * t;
    return {std::sin(a) + 2.0 * std::sin(2.0 * a), std::cos(a) - 2.0 * std::cos(2.0 * a), -std::sin(3.0 * a)};
}

//! Around the knot at distance 0.4: u runs along it, v around it.
Point3 tube(double u, double v)
{
    constexpr double kStep = 1e-4; // of t, for a tangent good to eight digits
    const Vec3 along = voroprobe::normalized(knot(u + kStep) - knot(u - kStep));
    const Vec3 across = voroprobe::normalized(voroprobe::cross(along, Vec3{0, 0, 1}));
    const double a = 2.0 * std::numbers::pi * v;
    return knot(u) + 0.4 * (std::cos(a) * across + std::sin(a) * voroprobe::cross(along, across));
}

} // namespace

int main(int argc, char** argv)
{
    using namespace voroprobe;
    if (argc != 2)
        return 2;

    const ParametricSurface surface{.point = tube, .joined_in_u = true, .joined_in_v = true};
    const auto oracle = make_parametric_oracle(surface, 0.005); // tessellated to that tolerance
    const TriangleMesh mesh =
        mesh_surface(*oracle, {.max_facet_radius = 0.2, .floor_radius = 0.02, .reach_lower_bound = 0.2}).mesh;

    write_mesh(mesh, argv[1], mesh_format(argv[1]));
    std::cout << count_components(mesh) << " surfaces, " << mesh.faces.size() << " faces\n";
    return is_closed_manifold(mesh) && euler_characteristic(mesh) == 0 ? 0 : 1;
}
