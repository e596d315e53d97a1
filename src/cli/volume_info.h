#pragma once

#include <string>
#include <vector>

#include "cli/file_lattice.h"
#include "io/volume_reader.h"
#include "volume/statistics.h"

namespace voroprobe
{

//! An isovalue worth trying.
struct SuggestedIsovalue
{
    double value;
    std::string source;  //!< "Otsu, 2 classes", ...
    double share_inside; //!< share of the samples at or above it, in [0, 1]
};

//! What `voroprobe info` tells of a dense volume.
struct VolumeInfo
{
    std::string path;
    std::string format;
    std::string stored_type;
    FileLattice lattice;
    VolumeStatistics statistics;
    bool label_map = false;       //!< the samples look like names of regions
    bool signed_distance = false; //!< the samples look like distances that are negative inside
    std::vector<SuggestedIsovalue> suggestions;
    std::vector<std::string> warnings;
};

VolumeInfo volume_info(const std::filesystem::path& path, const ReadOptions& options);

//! For people, with the histogram.
std::string volume_info_text(const VolumeInfo& info);

//! For programs; README.md, "Looking at a file".
std::string volume_info_json(const VolumeInfo& info);

} // namespace voroprobe
