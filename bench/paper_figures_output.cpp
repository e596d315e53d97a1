#include "bench/paper_figures_output.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <ostream>
#include <sstream>

#include <nlohmann/json.hpp>

namespace voroprobe::bench
{
namespace
{

// The plot, in pixels.
constexpr double kLeft = 60.0;
constexpr double kTop = 40.0;
constexpr double kWidth = 440.0;
constexpr double kHeight = 260.0;
constexpr double kLegendWidth = 190.0;

// Distinct in gray as well (Okabe & Ito 2008).
constexpr std::array<const char*, 6> kColors = {"#e69f00", "#56b4e9", "#cc79a7",
                                                "#d55e00", "#009e73", "#0072b2"};

class Plot
{
public:
    explicit Plot(const Figure& figure) : figure_(figure)
    {
        for (const Row& row : figure.rows)
        {
            most_ = std::max(most_, row.components);
            if (std::find(methods_.begin(), methods_.end(), row.method) == methods_.end())
                methods_.push_back(row.method);
        }
    }

    std::string text()
    {
        svg_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << kLeft + kWidth + kLegendWidth
             << "\" height=\"" << kTop + kHeight + 50.0 << "\" font-family=\"sans-serif\" font-size=\"12\">\n"
             << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
        label(kLeft, kTop - 16.0, "start", figure_.title);
        draw_axes();
        for (std::size_t i = 0; i < methods_.size(); ++i)
            draw_method(i);
        svg_ << "</svg>\n";
        return svg_.str();
    }

private:
    [[nodiscard]] double x(std::size_t components) const
    {
        return kLeft + kWidth * static_cast<double>(components) / static_cast<double>(most_);
    }

    static double y(double fraction) { return kTop + kHeight * (1.0 - fraction); }

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
        for (int percent = 0; percent <= 100; percent += 20)
        {
            const double height = y(0.01 * percent);
            line(kLeft, height, kLeft + kWidth, height, percent == 0 ? "black" : "#dddddd");
            label(kLeft - 6.0, height + 4.0, "end", std::to_string(percent) + " %");
        }
        line(kLeft, kTop, kLeft, kTop + kHeight, "black");
        std::vector<std::size_t> ticks;
        for (const Row& row : figure_.rows)
            if (std::find(ticks.begin(), ticks.end(), row.components) == ticks.end())
                ticks.push_back(row.components);
        for (const std::size_t tick : ticks)
            label(x(tick), kTop + kHeight + 16.0, "middle", std::to_string(tick));
        label(kLeft + 0.5 * kWidth, kTop + kHeight + 36.0, "middle", figure_.counted + "; meshed, mean");
    }

    void draw_method(std::size_t index)
    {
        const char* color = kColors[index % kColors.size()];
        std::ostringstream points;
        for (const Row& row : figure_.rows)
            if (row.method == methods_[index])
            {
                points << x(row.components) << ',' << y(row.mean_fraction()) << ' ';
                svg_ << "<circle cx=\"" << x(row.components) << "\" cy=\"" << y(row.mean_fraction())
                     << "\" r=\"3\" fill=\"" << color << "\"/>\n";
            }
        svg_ << "<polyline fill=\"none\" stroke-width=\"2\" stroke=\"" << color << "\" points=\""
             << points.str() << "\"/>\n";
        const double height = kTop + 18.0 * static_cast<double>(index) + 10.0;
        line(kLeft + kWidth + 16.0, height, kLeft + kWidth + 36.0, height, color);
        label(kLeft + kWidth + 42.0, height + 4.0, "start", methods_[index]);
    }

    const Figure& figure_;
    std::vector<std::string> methods_;
    std::size_t most_ = 1;
    std::ostringstream svg_;
};

} // namespace

bool Figure::keeps_promises() const
{
    return std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.keeps_promise(); });
}

void print_table(std::ostream& out, const Figure& figure)
{
    constexpr double kPercent = 100.0;
    out << "Figure " << figure.number << ": " << figure.title << " (seed " << figure.seed << ")\n"
        << "method                 " << std::setw(11) << figure.counted
        << "  trials  complete  meshed %   least %   sigma %     queries  certificates  vertices   seconds\n";
    for (const Row& row : figure.rows)
        out << std::left << std::setw(23) << row.method << std::right << std::fixed << std::setprecision(1)
            << std::setw(11) << row.components << std::setw(8) << row.trials.size() << std::setw(10)
            << row.complete_trials() << std::setw(10) << kPercent * row.mean_fraction() << std::setw(10)
            << kPercent * row.least_fraction() << std::setw(10) << kPercent * row.fraction_deviation()
            << std::setprecision(0) << std::setw(12) << row.mean_queries() << std::setw(14)
            << row.mean_certificates() << std::setw(10) << row.mean_vertices() << std::setprecision(3)
            << std::setw(10) << row.mean_seconds() << (row.keeps_promise() ? "" : "  NOT COMPLETE") << '\n';
    if (!figure.note.empty())
        out << figure.note << '\n';
}

nlohmann::json to_json(const Figure& figure)
{
    nlohmann::json rows = nlohmann::json::array();
    for (const Row& row : figure.rows)
        rows.push_back({{"method", row.method},
                        {figure.counted, row.components},
                        {"trials", row.trials.size()},
                        {"complete_trials", row.complete_trials()},
                        {"fraction_meshed", row.mean_fraction()},
                        {"least_fraction_meshed", row.least_fraction()},
                        {"fraction_deviation", row.fraction_deviation()},
                        {"oracle_queries", row.mean_queries()},
                        {"certificates", row.mean_certificates()},
                        {"vertices", row.mean_vertices()},
                        {"seconds", row.mean_seconds()}});
    return {{"figure", figure.number},
            {"title", figure.title},
            {"seed", figure.seed},
            {"note", figure.note},
            {"rows", rows}};
}

std::string to_svg(const Figure& figure)
{
    return Plot(figure).text();
}

} // namespace voroprobe::bench
