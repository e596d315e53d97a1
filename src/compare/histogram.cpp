#include "compare/histogram.h"

#include <algorithm>

namespace voroprobe
{

void Histogram::add(double value)
{
    const auto bins = static_cast<double>(counts_.size());
    const double place = std::clamp((value - low_) / (high_ - low_) * bins, 0.0, bins - 1.0);
    ++counts_[static_cast<std::size_t>(place)];
}

} // namespace voroprobe
