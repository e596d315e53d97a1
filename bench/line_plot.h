#pragma once

#include <string>
#include <utility>
#include <vector>

namespace voroprobe::bench
{

//! A place on an axis with what is written beside it.
using Tick = std::pair<double, std::string>;

struct PlotAxis
{
    std::string label;
    double low = 0.0; //!< above 0 where the scale is logarithmic
    double high = 1.0;
    bool logarithmic = false;
    std::vector<Tick> ticks = {};
};

struct PlotSeries
{
    std::string name;
    std::vector<std::pair<double, double>> points = {}; //!< joined in this order
};

//! A plot with a line and dots for each series and a legend.
struct LinePlot
{
    std::string title;
    PlotAxis x;
    PlotAxis y;
    std::vector<PlotSeries> series = {};
};

//! An axis from the power of ten below the values to that above, with a tick at each. \pre Values > 0.
PlotAxis decades(std::string label, const std::vector<double>& values);

//! The text of an SVG file.
std::string to_svg(const LinePlot& plot);

} // namespace voroprobe::bench
