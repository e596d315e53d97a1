#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "mesher/meshing_options.h"
#include "oracles/sphere_union_oracle.h"
#include "oracles/surface_oracle.h"
#include "support/random.h"

namespace voroprobe::bench
{

//! A surface of known components, and the criteria it is meshed with. Lengths are those of the figure.
struct Scene
{
    std::unique_ptr<SurfaceOracle> oracle;

    //! Of each component: 2 for a sphere, 0 for a torus.
    std::vector<long> euler_characteristics;

    //! The component that a point of the surface, or one near it, lies on.
    std::function<std::size_t(const Point3&)> component_at;

    MeshingOptions options;

    //! The reach of the surface, or a little less; 0 where it is not known.
    double reach = 0.0;
};

//! Signed distance to a torus, positive inside.
struct Torus
{
    Point3 center;
    std::size_t axis; //!< of the frame
    double ring;      //!< radius of the circle in the middle of the tube
    double tube;      //!< radius

    [[nodiscard]] double depth(const Point3& p) const;
};

//! Figures 3, 7 and 8: `count` spheres of radius at least 1 (at most 50, its logarithm uniform), at least 1
//! apart, possibly nested, in the ball of radius 100 around the origin, which is the domain. \throw
//! std::runtime_error where no place is left for another sphere.
Scene random_spheres(std::size_t count, Random& random);

//! Figure 2: six tori around a sphere.
Scene tori_around_sphere();

//! Figure 4: one sphere.
Scene single_sphere();

//! Figures 5 and 9: side^3 spheres of radius 1 whose centers are `spacing` >= 3 apart.
Scene sphere_grid(std::size_t side, double spacing);

//! Figure 8, right: x^2 + y^2 + z^2 + sin(4x) + sin(4y) + sin(4z) = 0.
Scene implicit_surface();

//! Theorem: three spheres of radii 1 to 2, at least 1 apart.
Scene few_spheres(Random& random);

//! Theorem: one torus, ring 1.2 to 2 and tube 0.4 to 0.8, around any axis of the frame.
Scene random_torus(Random& random);

//! One torus around the z axis.
Scene single_torus(double ring, double tube);

} // namespace voroprobe::bench
