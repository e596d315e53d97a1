#include "oracles/sphere_union_oracle.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "support/error.h"

namespace voroprobe
{
namespace
{

bool holds(const Sphere& sphere, const Point3& p)
{
    return squared_distance(p, sphere.center) <= sphere.radius * sphere.radius;
}

bool are_disjoint_or_nested(const Sphere& a, const Sphere& b)
{
    const double centers = distance(a.center, b.center);
    return centers > a.radius + b.radius || centers < std::abs(a.radius - b.radius);
}

void check_sphere(const Sphere& sphere, std::size_t index)
{
    if (!(sphere.radius > 0.0) || !std::isfinite(sphere.radius) || !is_finite(sphere.center))
        throw UsageError("sphere " + std::to_string(index) + ": radius " + std::to_string(sphere.radius) +
                         ", expected a positive radius and finite coordinates");
}

void check_spheres(const std::vector<Sphere>& spheres)
{
    if (spheres.empty())
        throw UsageError("sphere union: 0 spheres, expected at least 1");
    for (std::size_t i = 0; i < spheres.size(); ++i)
    {
        check_sphere(spheres[i], i);
        for (std::size_t j = 0; j < i; ++j)
            if (!are_disjoint_or_nested(spheres[i], spheres[j]))
                throw UsageError("sphere union: spheres " + std::to_string(j) + " and " + std::to_string(i) +
                                 " intersect, expected disjoint or nested spheres");
    }
}

Box3 bounding_box(const std::vector<Sphere>& spheres, double margin)
{
    Box3 box;
    for (const Sphere& sphere : spheres)
    {
        const Box3 around = Box3{sphere.center, sphere.center}.expanded(sphere.radius);
        box.include(around.min);
        box.include(around.max);
    }
    return box.expanded(margin);
}

//! Where the line of a segment enters and leaves a sphere; both equal where it passes by.
ParameterRange chord(const Sphere& sphere, const Segment3& segment)
{
    const Vec3 along = segment.target - segment.source;
    const double squared_length = squared_norm(along);
    const double middle = dot(sphere.center - segment.source, along) / squared_length;

    // From the foot of the perpendicular, not from the quadratic's coefficients: no cancellation for far
    // ends.
    const double squared_half_chord =
        sphere.radius * sphere.radius - squared_distance(segment.at(middle), sphere.center);
    const double half = std::sqrt(std::max(0.0, squared_half_chord) / squared_length);
    return {middle - half, middle + half};
}

//! Appends where the segment changes side of one sphere. The ends decide how many times, so that the number
//! always agrees with holds(); the roots only say where.
void append_crossings(const Sphere& sphere, const Segment3& segment, std::vector<Crossing>& crossings)
{
    const bool from_inside = holds(sphere, segment.source);
    const bool to_inside = holds(sphere, segment.target);
    if (from_inside && to_inside)
        return;

    const ParameterRange range = chord(sphere, segment);
    const auto append = [&](double t)
    {
        const double clamped = std::clamp(t, 0.0, 1.0);
        crossings.push_back({.t = clamped, .point = segment.at(clamped)});
    };
    if (from_inside)
        append(range.second);
    else if (to_inside)
        append(range.first);
    else if (0.0 < range.first && range.first < range.second && range.second < 1.0)
    {
        append(range.first);
        append(range.second);
    }
}

} // namespace

SphereUnionOracle::SphereUnionOracle(std::vector<Sphere> spheres, double margin)
    : spheres_(std::move(spheres))
{
    check_spheres(spheres_);
    if (!(margin >= 0.0) || !std::isfinite(margin))
        throw UsageError("sphere union: margin " + std::to_string(margin) + ", expected at least 0");
    domain_ = bounding_box(spheres_, margin);
}

Region SphereUnionOracle::region(const Point3& p) const
{
    const auto around =
        std::count_if(spheres_.begin(), spheres_.end(), [&](const Sphere& s) { return holds(s, p); });
    return around % 2 == 1 ? Region{1} : kOuterRegion;
}

void SphereUnionOracle::find_crossings(const Segment3& segment, std::vector<Crossing>& crossings) const
{
    crossings.clear();
    if (segment.source == segment.target || !is_finite(segment.source) || !is_finite(segment.target))
        return;
    for (const Sphere& sphere : spheres_)
        append_crossings(sphere, segment, crossings);
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
}

bool SphereUnionOracle::may_cross(const Box3& box) const
{
    // A sphere meets the box unless it lies all outside or has the whole box within.
    return std::any_of(spheres_.begin(), spheres_.end(),
                       [&](const Sphere& sphere)
                       {
                           Vec3 nearest;
                           Vec3 farthest;
                           for (std::size_t axis = 0; axis < 3; ++axis)
                           {
                               const double low = box.min[axis] - sphere.center[axis];
                               const double high = box.max[axis] - sphere.center[axis];
                               nearest[axis] = std::clamp(0.0, low, high);
                               farthest[axis] = std::max(std::abs(low), std::abs(high));
                           }
                           return norm(nearest) <= sphere.radius && sphere.radius <= norm(farthest);
                       });
}

} // namespace voroprobe
