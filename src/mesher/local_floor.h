#pragma once

#include <cstdint>
#include <unordered_map>

#include "geometry/vec3.h"

namespace voroprobe
{

//! The radius below which refinement no longer pursues topology: one length, and less near places where the
//! mesh turned out not to have the scan's topology at that length. Space is divided into cubes of four floor
//! radii; each cube has a floor of its own.
class LocalFloor
{
public:
    explicit LocalFloor(double floor_radius)
        : squared_base_(floor_radius * floor_radius), inverse_cube_side_(1.0 / (kCubeInFloors * floor_radius))
    {
    }

    //! Squared floor radius at p.
    [[nodiscard]] double squared_at(const Point3& p) const
    {
        if (squared_floor_of_cube_.empty())
            return squared_base_;
        const auto found = squared_floor_of_cube_.find(key(cube_of(p)));
        return found == squared_floor_of_cube_.end() ? squared_base_ : found->second;
    }

    [[nodiscard]] double squared_base() const { return squared_base_; }

    //! Halves the floor in the cube of p and in those around it, in at most kRounds rounds. The
    //! cubes keep the smallest floor asked for in one round: `round` counts from 1, and no cube is lowered
    //! below 2^-round. False where nothing changed.
    bool lower(const Point3& p, int round);

    //! Rounds of lowering that have an effect, at most.
    static constexpr int kRounds = 4;

private:
    static constexpr double kCubeInFloors = 4.0;

    struct Cube
    {
        std::int64_t x;
        std::int64_t y;
        std::int64_t z;
    };

    [[nodiscard]] Cube cube_of(const Point3& p) const;
    [[nodiscard]] static std::uint64_t key(const Cube& cube);

    double squared_base_;
    double inverse_cube_side_;
    std::unordered_map<std::uint64_t, double> squared_floor_of_cube_;
};

} // namespace voroprobe
