#pragma once

#include <optional>
#include <string>

#include "oracles/trilinear_oracle.h"
#include "volume/statistics.h"
#include "volume/volume.h"

namespace voroprobe
{

//! The isovalue of a run and where it comes from.
struct IsovalueChoice
{
    double value;
    std::string source; //!< "given", "Otsu", "halfway between the two values"
};

//! The isovalue that --isovalue auto takes: halfway between the values of a mask, Otsu's threshold otherwise;
//! nullopt where all samples are equal or none is finite.
std::optional<IsovalueChoice> automatic_isovalue(const VolumeStatistics& statistics);

//! Whether the isovalue separates samples: some are inside and some are not.
bool separates(double isovalue, InsideIs inside, double min, double max);

//! The isovalue asked for, or the automatic one.
//! \throw EmptySurfaceError with the range of the samples and an isovalue that works where the one asked for
//! does not separate them; UsageError where none was given and the volume looks like a label map.
IsovalueChoice choose_isovalue(const std::optional<double>& asked, InsideIs inside, const Volume& volume,
                               const VolumeStatistics& statistics);

//! Share of the samples that are inside, in [0, 1]; NaN and infinite samples are outside.
double share_inside(const Volume& volume, double isovalue, InsideIs inside);

//! The same over the samples on the six faces of the volume. More than half is a sign that the sides are
//! mistaken.
double border_share_inside(const Volume& volume, double isovalue, InsideIs inside);

} // namespace voroprobe
