#include "bench/paper_figures_output.h"

#include <algorithm>
#include <iomanip>
#include <ostream>
#include <sstream>

#include "bench/line_plot.h"

namespace voroprobe::bench
{
namespace
{

//! The mean fraction meshed against the number of components, a line for each method.
LinePlot plot_of(const Figure& figure)
{
    LinePlot plot{.title = figure.title,
                  .x = {.label = figure.counted + "; meshed, mean"},
                  .y = {.label = "", .high = 100.0}};
    for (const int percent : {0, 20, 40, 60, 80, 100})
        plot.y.ticks.emplace_back(percent, std::to_string(percent) + " %");
    for (const Row& row : figure.rows)
    {
        const auto components = static_cast<double>(row.components);
        plot.x.high = std::max(plot.x.high, components);
        const Tick tick{components, std::to_string(row.components)};
        if (std::find(plot.x.ticks.begin(), plot.x.ticks.end(), tick) == plot.x.ticks.end())
            plot.x.ticks.push_back(tick);
        auto line = std::find_if(plot.series.begin(), plot.series.end(),
                                 [&](const PlotSeries& series) { return series.name == row.method; });
        if (line == plot.series.end())
            line = plot.series.insert(line, PlotSeries{row.method, {}});
        line->points.emplace_back(components, 100.0 * row.mean_fraction());
    }
    return plot;
}

} // namespace

bool Figure::keeps_promises() const
{
    return std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.keeps_promise(); });
}

namespace
{

std::string table_of(const Figure& figure)
{
    std::ostringstream out;
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
    return out.str();
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

} // namespace

Report report_of(const Figure& figure)
{
    return {table_of(figure), to_json(figure), to_svg(plot_of(figure)), figure.keeps_promises()};
}

} // namespace voroprobe::bench
