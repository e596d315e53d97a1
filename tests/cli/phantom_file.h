#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>

#include "geometry/affine_transform.h"

namespace voroprobe
{

//! A MetaImage to be written for a test; the samples are float32.
struct Phantom
{
    std::array<std::size_t, 3> size{24, 24, 24};
    Vec3 spacing{1, 1, 1};
    Matrix3 direction; //!< direction cosines by columns
    Point3 origin;     //!< world (LPS, mm) position of index (0, 0, 0)
    std::function<double(const Point3& p_world)> field;
};

//! Radius minus distance to the center: positive inside a ball.
std::function<double(const Point3&)> ball(const Point3& center, double radius);

//! A phantom with a ball of radius 8 in the middle, samples from about -12 to 8.
Phantom ball_phantom();

//! World position of index (0, 0, 0) to index: p_world = origin + direction * (spacing .* p_index).
AffineTransform world_from_index(const Phantom& phantom);

//! Writes the phantom as .mha with the samples raw in the file.
void write_phantom(const Phantom& phantom, const std::filesystem::path& path);

} // namespace voroprobe
