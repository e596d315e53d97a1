#include "bench/line_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace voroprobe::bench
{
namespace
{

// In pixels.
constexpr double kLeft = 60.0;
constexpr double kTop = 40.0;
constexpr double kWidth = 440.0;
constexpr double kHeight = 260.0;
constexpr double kLegendWidth = 230.0;

// Distinct in gray as well (Okabe & Ito 2008).
constexpr std::array<const char*, 6> kColors = {"#e69f00", "#56b4e9", "#cc79a7",
                                                "#d55e00", "#009e73", "#0072b2"};

class Drawing
{
public:
    explicit Drawing(const LinePlot& plot) : plot_(plot) {}

    std::string text()
    {
        svg_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << kLeft + kWidth + kLegendWidth
             << "\" height=\"" << kTop + kHeight + 50.0 << "\" font-family=\"sans-serif\" font-size=\"12\">\n"
             << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
        label(kLeft, kTop - 16.0, "start", plot_.title);
        draw_axes();
        for (std::size_t i = 0; i < plot_.series.size(); ++i)
            draw_series(i);
        svg_ << "</svg>\n";
        return svg_.str();
    }

private:
    static double share(const PlotAxis& axis, double value)
    {
        if (axis.logarithmic)
            return std::log(value / axis.low) / std::log(axis.high / axis.low);
        return (value - axis.low) / (axis.high - axis.low);
    }
    [[nodiscard]] double x(double value) const { return kLeft + kWidth * share(plot_.x, value); }
    [[nodiscard]] double y(double value) const { return kTop + kHeight * (1.0 - share(plot_.y, value)); }

    void label(double at_x, double at_y, const char* anchor, const std::string& text)
    {
        svg_ << "<text x=\"" << at_x << "\" y=\"" << at_y << "\" text-anchor=\"" << anchor << "\">" << text
             << "</text>\n";
    }

    void line(double x1, double y1, double x2, double y2, const char* color)
    {
        svg_ << "<line x1=\"" << x1 << "\" y1=\"" << y1 << "\" x2=\"" << x2 << "\" y2=\"" << y2
             << "\" stroke=\"" << color << "\"/>\n";
    }

    void draw_axes()
    {
        for (const auto& [value, text] : plot_.y.ticks)
        {
            line(kLeft, y(value), kLeft + kWidth, y(value), "#dddddd");
            label(kLeft - 6.0, y(value) + 4.0, "end", text);
        }
        for (const auto& [value, text] : plot_.x.ticks)
            label(x(value), kTop + kHeight + 16.0, "middle", text);
        line(kLeft, kTop, kLeft, kTop + kHeight, "black");
        line(kLeft, kTop + kHeight, kLeft + kWidth, kTop + kHeight, "black");
        label(kLeft + 0.5 * kWidth, kTop + kHeight + 36.0, "middle", plot_.x.label);
        label(kLeft + kWidth, kTop - 16.0, "end", plot_.y.label);
    }

    void draw_series(std::size_t index)
    {
        const char* color = kColors[index % kColors.size()];
        std::ostringstream points;
        for (const auto& [at_x, at_y] : plot_.series[index].points)
        {
            points << x(at_x) << ',' << y(at_y) << ' ';
            svg_ << "<circle cx=\"" << x(at_x) << "\" cy=\"" << y(at_y) << "\" r=\"3\" fill=\"" << color
                 << "\"/>\n";
        }
        svg_ << "<polyline fill=\"none\" stroke-width=\"2\" stroke=\"" << color << "\" points=\""
             << points.str() << "\"/>\n";
        const double height = kTop + 18.0 * static_cast<double>(index) + 10.0;
        line(kLeft + kWidth + 16.0, height, kLeft + kWidth + 36.0, height, color);
        label(kLeft + kWidth + 42.0, height + 4.0, "start", plot_.series[index].name);
    }

    const LinePlot& plot_;
    std::ostringstream svg_;
};

} // namespace

PlotAxis decades(std::string label, const std::vector<double>& values)
{
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    PlotAxis axis{.label = std::move(label), .logarithmic = true};
    const int low = static_cast<int>(std::floor(std::log10(*least)));
    const int high = std::max(low + 1, static_cast<int>(std::ceil(std::log10(*most))));
    axis.low = std::pow(10.0, low);
    axis.high = std::pow(10.0, high);
    for (int exponent = low; exponent <= high; ++exponent)
    {
        std::ostringstream text;
        text << std::pow(10.0, exponent);
        axis.ticks.emplace_back(std::pow(10.0, exponent), text.str());
    }
    return axis;
}

std::string to_svg(const LinePlot& plot)
{
    return Drawing(plot).text();
}

} // namespace voroprobe::bench
