#include "volume/phantoms.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "support/check.h"

namespace voroprobe
{
namespace
{

using std::numbers::pi;

//! Half thickness of the double torus, in units of its scale. The holes close at 0.25.
constexpr double kDoubleTorusThickness = 0.1;

//! Frequency and amplitude of the ripples. Source: Marschner & Lobb 1994, Sec. 4.
constexpr double kMarschnerLobbFrequency = 6.0;
constexpr double kMarschnerLobbAmplitude = 0.25;

double marschner_lobb(const Vec3& p)
{
    const double radius = std::hypot(p.x, p.y);
    const double ripple = std::cos(2.0 * pi * kMarschnerLobbFrequency * std::cos(0.5 * pi * radius));
    return (1.0 - std::sin(0.5 * pi * p.z) + kMarschnerLobbAmplitude * (1.0 + ripple)) /
           (2.0 * (1.0 + kMarschnerLobbAmplitude));
}

} // namespace

LevelFunction sphere_phantom(const Point3& center, double radius)
{
    CHECK_GT(radius, 0.0);
    return [=](const Point3& p) { return radius - distance(p, center); };
}

LevelFunction torus_phantom(const Point3& center, double major_radius, double minor_radius)
{
    CHECK_GT(minor_radius, 0.0);
    CHECK_GT(major_radius, minor_radius);
    return [=](const Point3& p)
    {
        const Vec3 q = p - center;
        return minor_radius - std::hypot(std::hypot(q.x, q.y) - major_radius, q.z);
    };
}

LevelFunction double_torus_phantom(const Point3& center, double scale)
{
    CHECK_GT(scale, 0.0);
    return [=](const Point3& p)
    {
        const Vec3 q = (p - center) / scale;
        const double eight = q.x * q.x * (1.0 - q.x * q.x) - q.y * q.y;
        return kDoubleTorusThickness * kDoubleTorusThickness - eight * eight - q.z * q.z;
    };
}

LevelFunction marschner_lobb_phantom(const Point3& center, double scale)
{
    CHECK_GT(scale, 0.0);
    return [=](const Point3& p) { return marschner_lobb((p - center) / scale) - 0.5; };
}

LevelFunction nested_shells_phantom(const Point3& center, std::vector<double> radii)
{
    CHECK(!radii.empty());
    CHECK_GT(radii.back(), 0.0);
    CHECK(std::adjacent_find(radii.begin(), radii.end(), std::less_equal<>{}) == radii.end());
    return [center, radii = std::move(radii)](const Point3& p)
    {
        const double from_center = distance(p, center);
        double nearest = radii.front() - from_center; // positive inside, as all signs below
        double sign = 1.0;
        for (const double radius : radii)
        {
            const double inward = sign * (radius - from_center);
            nearest = std::abs(inward) < std::abs(nearest) ? inward : nearest;
            sign = -sign;
        }
        return nearest;
    };
}

Volume sample_volume(const LevelFunction& function, const std::array<std::size_t, 3>& size,
                     const Vec3& spacing)
{
    Volume volume;
    volume.geometry.size = size;
    volume.geometry.spacing = spacing;
    volume.geometry.source_index_from_grid.linear = {
        {Vec3{1.0 / spacing.x, 0, 0}, Vec3{0, 1.0 / spacing.y, 0}, Vec3{0, 0, 1.0 / spacing.z}}};

    std::vector<float> samples;
    samples.reserve(volume.geometry.sample_count());
    for (std::size_t k = 0; k < size[2]; ++k)
        for (std::size_t j = 0; j < size[1]; ++j)
            for (std::size_t i = 0; i < size[0]; ++i)
                samples.push_back(static_cast<float>(
                    function({spacing.x * static_cast<double>(i), spacing.y * static_cast<double>(j),
                              spacing.z * static_cast<double>(k)})));
    volume.samples = std::move(samples);
    return volume;
}

} // namespace voroprobe
