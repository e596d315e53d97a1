#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "volume/volume.h"

namespace voroprobe
{

//! A level function of a known shape: at least 0 inside, negative outside. The shapes stand wherever the
//! caller puts them; for sample_volume() that is the grid frame. "Signed distance" below means negated: the
//! distance to the surface, positive inside.
using LevelFunction = std::function<double(const Point3&)>;

//! A ball; signed distance. One surface of genus 0, area 4 pi r^2. \pre radius > 0.
LevelFunction sphere_phantom(const Point3& center, double radius);

//! A torus around the z axis; signed distance. One surface of genus 1, area 4 pi^2 R r, volume 2 pi^2 R r^2.
//! \pre major_radius > minor_radius > 0.
LevelFunction torus_phantom(const Point3& center, double major_radius, double minor_radius);

//! A smooth double torus: the figure eight y^2 = x^2 - x^4, thickened. One surface of genus 2, within
//! scale * [-1.05, 1.05] x [-0.6, 0.6] x [-0.1, 0.1] around the center. Not a distance; its gradient is at
//! most 13 / scale within scale * [-1.2, 1.2] x [-0.8, 0.8] x [-0.5, 0.5]. \pre scale > 0.
LevelFunction double_torus_phantom(const Point3& center, double scale);

//! The test signal of Marschner & Lobb 1994 (f_M = 6, alpha = 0.25) minus 0.5, over the cube of half side
//! `scale` around the center: ripples near the Nyquist limit of 41^3 samples. Its gradient is at most 6 /
//! scale. It leaves the cube through five of its faces. \pre scale > 0.
LevelFunction marschner_lobb_phantom(const Point3& center, double scale);

//! Concentric shells: inside between the first and second radius, between the third and fourth, and so on; a
//! ball in the middle where the number of radii is odd. Signed distance; as many surfaces, of genus 0, as
//! radii. \pre radii positive, strictly descending, at least one.
LevelFunction nested_shells_phantom(const Point3& center, std::vector<double> radii);

//! float32 samples of a function of the grid frame, sample (i, j, k) taken at spacing .* (i, j, k); grid and
//! world frame coincide. Cost: one call per sample. \pre size > 0 and spacing > 0 along every axis.
Volume sample_volume(const LevelFunction& function, const std::array<std::size_t, 3>& size,
                     const Vec3& spacing);

} // namespace voroprobe
