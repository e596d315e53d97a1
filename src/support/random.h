#pragma once

#include <cstdint>

namespace voroprobe
{

//! SplitMix64 (Steele, Lea, Flood 2014): a small generator whose sequence is the same on every machine,
//! unlike the distributions of <random>. Passed in, never global, never seeded by time.
class Random
{
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    //! Uniform over all 64-bit values.
    std::uint64_t next()
    {
        std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ULL);
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
        return z ^ (z >> 31U);
    }

    //! Uniform in [0, 1).
    double uniform() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }

    //! Uniform in [low, high).
    double uniform(double low, double high) { return low + (high - low) * uniform(); }

    //! Uniform in {0, ..., count - 1}; count > 0 and far below 2^64.
    std::uint64_t below(std::uint64_t count) { return next() % count; }

private:
    std::uint64_t state_;
};

} // namespace voroprobe
