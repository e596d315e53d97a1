#pragma once

#include <cstddef>
#include <vector>

#include "volume/volume.h"

namespace voroprobe
{

//! Facts about the samples of a volume; non-finite samples are counted and otherwise left out.
struct VolumeStatistics
{
    double min = 0.0;
    double max = 0.0;
    double mean = 0.0;
    std::size_t nan_count = 0;
    std::size_t infinite_count = 0;
    bool integer_valued = false; //!< every finite sample is a whole number
    std::size_t distinct_values =
        0; //!< number of different finite values, counted up to 4096; 0 where there are more
    std::vector<std::size_t> histogram; //!< equal bins over [min, max]
};

//! \pre bin_count > 0. Cost: two passes over the samples.
VolumeStatistics compute_statistics(const Volume& volume, std::size_t bin_count = 1024);

//! Thresholds that split the histogram into `classes` (2 to 4) of least within-class variance, ascending, in
//! sample values, at bin borders; fewer where the samples have fewer than `classes` different values. Source:
//! Otsu 1979, Sec. II.
std::vector<double> otsu_thresholds(const VolumeStatistics& statistics, std::size_t classes);

} // namespace voroprobe
