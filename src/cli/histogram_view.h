#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "volume/statistics.h"

namespace voroprobe
{

//! A value to point at beside the rows.
struct HistogramMark
{
    double value;
    std::string text;
};

//! The histogram as lines of plain text, one row of equal width in value per line, lengths on a logarithmic
//! scale (air fills most of a CT and would flatten the rest); each row with its lower end, its share of the
//! finite samples, and the marks whose values it holds. Empty where there is no finite sample.
std::string histogram_view(const VolumeStatistics& statistics, const std::vector<HistogramMark>& marks,
                           std::size_t rows = 24);

} // namespace voroprobe
