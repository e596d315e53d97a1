#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "volume/volume.h"

namespace voroprobe
{

//! What a random volume is like. Each kind is hostile to meshers in its own way.
enum class VolumeKind
{
    kWhiteNoise,
    kSmoothNoise,
    kIntegers, //!< samples 0 to 3 and the isovalue among them: samples equal to it
    kSpecks,   //!< objects of one voxel, some of them touching at corners
    kCheckerboard,
    kThinSheets,  //!< one voxel thick, tilted
    kAnisotropic, //!< smooth noise on voxels of 1 x 1 x 8
    kThroughBorder,
    kBlobs, //!< balls of many sizes, some of them merging
    kShells //!< nested, thin, off center
};
inline constexpr int kVolumeKindCount = 10;

//! As an identifier: "white_noise".
std::string name_of(VolumeKind kind);

//! For GoogleTest.
void PrintTo(VolumeKind kind, std::ostream* out);

struct RandomVolume
{
    std::string name; //!< kind and seed, for messages
    std::shared_ptr<const Volume> volume;
    double isovalue = 0.5;
};

//! At most 14 samples along each axis. The same for the same arguments.
RandomVolume make_random_volume(VolumeKind kind, std::uint64_t seed);

//! The same kinds, `side` samples along each axis, side at least 4. Odd axes of kAnisotropic volumes have
//! fewer.
RandomVolume make_random_volume(VolumeKind kind, std::uint64_t seed, std::size_t side);

} // namespace voroprobe
