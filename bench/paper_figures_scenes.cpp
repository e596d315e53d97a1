#include "bench/paper_figures_scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "oracles/implicit_expression.h"
#include "oracles/implicit_oracle.h"

namespace voroprobe::bench
{
namespace
{

constexpr double kLeastRadius = 1.0;
constexpr double kLeastGap = 1.0;
constexpr double kBoundingRadius = 100.0;
constexpr double kLargestRadius = 50.0; //!< the report does not say; larger ones leave no room for forty
constexpr std::size_t kMostAttempts = 1'000'000;

//! Of the implicit surface, by Federer's formula |b - a|^2 / (2 dist(b - a, tangent plane at a)) over pairs
//! of 60,000 of its points: 0.1373, where its three small components curve most (7.28).
constexpr double kImplicitSurfaceReach = 0.137;

//! The spheres in the box around the report's bounding ball, so that rays begin at its center.
class BoundedSpheres final : public SurfaceOracle
{
public:
    explicit BoundedSpheres(std::vector<Sphere> spheres) : spheres_(std::move(spheres)) {}

    [[nodiscard]] Box3 domain() const override
    {
        const double r = kBoundingRadius;
        return {{-r, -r, -r}, {r, r, r}};
    }
    [[nodiscard]] Region region(const Point3& p) const override { return spheres_.region(p); }
    void find_crossings(const Segment3& segment, std::vector<Crossing>& crossings) const override
    {
        spheres_.find_crossings(segment, crossings);
    }
    [[nodiscard]] bool may_cross(const Box3& box) const override { return spheres_.may_cross(box); }

private:
    SphereUnionOracle spheres_;
};

//! Criteria for spheres of radius >= 1 that are >= 1 apart. What bounds the size is the distance: it gives
//! small spheres small faces, and a trial of forty spheres some thousands of vertices.
MeshingOptions sphere_criteria()
{
    return {.max_facet_radius = 20.0,
            .max_facet_distance = 0.25,
            .min_facet_angle_deg = 30.0,
            .floor_radius = 0.05,
            .reach_lower_bound = 0.5 * kLeastGap};
}

std::size_t nearest_sphere(const std::vector<Sphere>& spheres, const Point3& p)
{
    const auto gap = [&](const Sphere& sphere)
    { return std::abs(distance(p, sphere.center) - sphere.radius); };
    const auto nearest = std::min_element(spheres.begin(), spheres.end(),
                                          [&](const Sphere& a, const Sphere& b) { return gap(a) < gap(b); });
    return static_cast<std::size_t>(nearest - spheres.begin());
}

Scene sphere_scene(const std::vector<Sphere>& spheres, std::unique_ptr<SurfaceOracle> oracle)
{
    return {.oracle = std::move(oracle),
            .euler_characteristics = std::vector<long>(spheres.size(), 2),
            .component_at = [spheres](const Point3& p) { return nearest_sphere(spheres, p); },
            .options = sphere_criteria()};
}

bool are_apart(const Sphere& a, const Sphere& b)
{
    const double centers = distance(a.center, b.center);
    const bool disjoint = centers >= a.radius + b.radius + kLeastGap;
    const bool nested = centers + kLeastGap <= std::abs(a.radius - b.radius);
    return disjoint || nested;
}

//! Uniform in the ball, by rejection from the cube around it.
Point3 random_point_in_ball(double radius, Random& random)
{
    while (true)
    {
        const Point3 p{random.uniform(-radius, radius), random.uniform(-radius, radius),
                       random.uniform(-radius, radius)};
        if (squared_norm(p) <= radius * radius)
            return p;
    }
}

Sphere random_sphere(Random& random)
{
    const double radius = kLeastRadius * std::exp(random.uniform(0.0, std::log(kLargestRadius)));
    return {random_point_in_ball(kBoundingRadius - radius, random), radius};
}

// Figure 2: a sphere and minor radii of 1, distances of 1. The major radius is not given, and no torus around
// each half axis is 1 from both the sphere and its neighbours. Here neighbours are: 2 + 1 from ring to ring,
// so the distance of a ring's center is its radius + 3 / sqrt(2), and the sphere is 1.92 away. Reach 0.5.
constexpr double kTorusTube = 1.0;
constexpr double kTorusRing = 1.5;
constexpr double kTorusDistance = kTorusRing + 3.0 * std::numbers::sqrt2 / 2.0;

//! Component 0 is the sphere; 1 to 6 are the tori.
double depth_in_component(const Point3& p, std::size_t component)
{
    if (component == 0)
        return 1.0 - norm(p);
    const std::size_t axis = (component - 1) / 2;
    Point3 center;
    center[axis] = component % 2 == 1 ? kTorusDistance : -kTorusDistance;
    return Torus{center, axis, kTorusRing, kTorusTube}.depth(p);
}

std::size_t deepest_component(const Point3& p)
{
    std::size_t deepest = 0;
    for (std::size_t component = 1; component < 7; ++component)
        if (depth_in_component(p, component) > depth_in_component(p, deepest))
            deepest = component;
    return deepest;
}

//! Spheres that `draw` gives, those left out that come too near to one before.
template <class Draw>
std::vector<Sphere> draw_apart(std::size_t count, Draw draw)
{
    std::vector<Sphere> spheres;
    for (std::size_t attempt = 0; attempt < kMostAttempts && spheres.size() < count; ++attempt)
    {
        const Sphere sphere = draw();
        if (std::all_of(spheres.begin(), spheres.end(),
                        [&](const Sphere& other) { return are_apart(sphere, other); }))
            spheres.push_back(sphere);
    }
    if (spheres.size() < count)
        throw std::runtime_error("random spheres: found place for " + std::to_string(spheres.size()) +
                                 " of " + std::to_string(count));
    return spheres;
}

//! Of spheres none within another: the smallest radius, or half of the smallest gap.
double reach_of(const std::vector<Sphere>& spheres)
{
    double reach = spheres.front().radius;
    for (std::size_t i = 0; i < spheres.size(); ++i)
    {
        reach = std::min(reach, spheres[i].radius);
        for (std::size_t k = 0; k < i; ++k)
            reach = std::min(reach, 0.5 * (distance(spheres[i].center, spheres[k].center) -
                                           spheres[i].radius - spheres[k].radius));
    }
    return reach;
}

Scene torus_scene(const Torus& torus)
{
    constexpr double kResolution = 1e-6; // far below the tube
    constexpr double kMargin = 0.5;
    const double half = torus.ring + torus.tube + kMargin;
    const Box3 domain = Box3{torus.center, torus.center}.expanded(half);
    return {.oracle = std::make_unique<ImplicitOracle>([torus](const Point3& p) { return torus.depth(p); },
                                                       domain, 1.0, kResolution),
            .euler_characteristics = {0},
            .component_at = [](const Point3&) { return std::size_t{0}; },
            .options = {.max_facet_radius = torus.tube,
                        .floor_radius = 0.01 * torus.tube,
                        .reach_lower_bound = 0.5 * torus.tube},
            .reach = std::min(torus.tube, torus.ring - torus.tube)};
}

} // namespace

double Torus::depth(const Point3& p) const
{
    const Vec3 d = p - center;
    const double along = d[axis];
    const double across = std::sqrt(std::max(0.0, squared_norm(d) - along * along));
    return tube - std::hypot(across - ring, along);
}

Scene random_spheres(std::size_t count, Random& random)
{
    const std::vector<Sphere> spheres = draw_apart(count, [&] { return random_sphere(random); });
    Scene scene = sphere_scene(spheres, std::make_unique<BoundedSpheres>(spheres));
    scene.options.domain_ball = Ball{{0, 0, 0}, kBoundingRadius};
    return scene;
}

Scene tori_around_sphere()
{
    constexpr double kHalfDomain = 5.5;
    constexpr double kResolution = 1e-6; // far below the gaps and the tubes
    const Box3 domain{{-kHalfDomain, -kHalfDomain, -kHalfDomain}, {kHalfDomain, kHalfDomain, kHalfDomain}};
    const auto depth = [](const Point3& p) { return depth_in_component(p, deepest_component(p)); };
    return {.oracle = std::make_unique<ImplicitOracle>(depth, domain, 1.0, kResolution),
            .euler_characteristics = {2, 0, 0, 0, 0, 0, 0},
            .component_at = deepest_component,
            .options = {.max_facet_radius = 0.5,
                        .max_facet_distance = 0.5,
                        .floor_radius = 0.05,
                        .reach_lower_bound = 0.49}};
}

Scene single_sphere()
{
    const std::vector<Sphere> spheres = {{{0, 0, 0}, 1.0}};
    Scene scene = sphere_scene(spheres, std::make_unique<SphereUnionOracle>(spheres));
    // About the report's 171 vertices from five seeds.
    scene.options = {.max_facet_radius = 0.25, .floor_radius = 1e-6, .reach_lower_bound = 0.5};
    return scene;
}

Scene sphere_grid(std::size_t side, double spacing)
{
    std::vector<Sphere> spheres;
    for (std::size_t i = 0; i < side * side * side; ++i)
    {
        const auto place = [&](std::size_t k) { return spacing * static_cast<double>(k % side); };
        spheres.push_back({{place(i), place(i / side), place(i / (side * side))}, 1.0});
    }
    return sphere_scene(spheres, std::make_unique<SphereUnionOracle>(spheres));
}

Scene implicit_surface()
{
    // A sum of g(t) = t^2 + sin 4t, with minima at -0.35 (g = -0.86) and 1.04 (0.23), a maximum at 0.45
    // (1.18) between them, and more than 2.3 beyond. So f < 0 around (-0.35, -0.35, -0.35) and on to each
    // place with one coordinate at 1.04; around the three places with two of them too, cut off by planes
    // where f >= 0.54; not around the one with three. 4 components.
    constexpr double kBetween = 0.45;
    const auto component_at = [](const Point3& p) -> std::size_t
    {
        const bool beyond[3] = {p.x > kBetween, p.y > kBetween, p.z > kBetween};
        if (beyond[0] + beyond[1] + beyond[2] != 2)
            return 0;
        return !beyond[0] ? 1 : !beyond[1] ? 2 : 3;
    };
    const Box3 domain{{-3, -3, -3}, {3, 3, 3}};
    return {.oracle =
                make_expression_oracle({.formula = "x^2+y^2+z^2+sin(4*x)+sin(4*y)+sin(4*z)", .isovalue = 0.0},
                                       ImplicitDomain(domain)),
            .euler_characteristics = {2, 2, 2, 2},
            .component_at = component_at,
            .options = {.max_facet_radius = 0.15,
                        .max_facet_distance = 0.02,
                        .floor_radius = 0.01,
                        .reach_lower_bound = 0.05},
            .reach = kImplicitSurfaceReach};
}

Scene few_spheres(Random& random)
{
    constexpr double kRoom = 6.0;
    const std::vector<Sphere> spheres =
        draw_apart(3,
                   [&]
                   {
                       const double radius = random.uniform(1.0, 2.0);
                       return Sphere{random_point_in_ball(kRoom - radius, random), radius};
                   });
    Scene scene = sphere_scene(spheres, std::make_unique<SphereUnionOracle>(spheres));
    scene.reach = reach_of(spheres);
    return scene;
}

Scene random_torus(Random& random)
{
    const Point3 center{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
    const auto axis = static_cast<std::size_t>(random.next() % 3);
    const double ring = random.uniform(1.2, 2.0);
    return torus_scene({center, axis, ring, random.uniform(0.4, 0.8)});
}

Scene single_torus(double ring, double tube)
{
    return torus_scene({{0, 0, 0}, 2, ring, tube});
}

} // namespace voroprobe::bench
