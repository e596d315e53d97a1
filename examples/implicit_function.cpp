// implicit_function MESH: the surface of a formula. Beside formulas any function of a point can be meshed,
// given how fast it changes at most: see oracles/implicit_oracle.h.

#include <iostream>

#include "io/mesh_writer.h"
#include "mesh/topology.h"
#include "mesher/seeded_mesher.h"
#include "oracles/implicit_expression.h"

int main(int argc, char** argv)
{
    using namespace voroprobe;
    if (argc != 2)
        return 2;

    // Inside: where the formula is at most the isovalue. What is certain of it comes from interval
    // arithmetic.
    const ExpressionSurface surface{.formula = "x^2+y^2+z^2+sin(4*x)+sin(4*y)+sin(4*z)", .isovalue = 1.0};
    const auto oracle = make_expression_oracle(surface, ImplicitDomain(Box3{{-3, -3, -3}, {3, 3, 3}}));

    const TriangleMesh mesh = mesh_surface(*oracle, {.max_facet_radius = 0.15,
                                                     .max_facet_distance = 0.02,
                                                     .floor_radius = 0.01,
                                                     .reach_lower_bound = 0.1})
                                  .mesh;

    write_mesh(mesh, argv[1], mesh_format(argv[1]));
    std::cout << count_components(mesh) << " surfaces, " << mesh.faces.size() << " faces\n";
    return is_closed_manifold(mesh) ? 0 : 1;
}
