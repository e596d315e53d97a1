#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace voroprobe
{

//! Counts of values in bins of equal width. Values beyond an end are counted in the bin at that end.
class Histogram
{
public:
    //! \pre low < high, bins > 0.
    Histogram(double low, double high, std::size_t bins) : low_(low), high_(high), counts_(bins, 0) {}

    void add(double value);

    [[nodiscard]] double low() const { return low_; }
    [[nodiscard]] double high() const { return high_; }
    [[nodiscard]] std::span<const std::size_t> counts() const { return counts_; }

private:
    double low_;
    double high_;
    std::vector<std::size_t> counts_;
};

} // namespace voroprobe
