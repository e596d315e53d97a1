#pragma once

#include <string>
#include <vector>

#include "bench/paper_figures_trials.h"
#include "bench/paper_report.h"

namespace voroprobe::bench
{

//! One experiment of the report, run.
struct Figure
{
    int number = 0;
    std::string title;
    std::string counted; //!< what components are here: "spheres" or "components"
    std::uint64_t seed = 0;
    std::string note = "";
    std::vector<Row> rows = {};

    [[nodiscard]] bool keeps_promises() const;
};

//! The JSON is {figure, title, seed, note, rows}; of each row the method, the number of components under the
//! name `counted`, trials, complete_trials, fraction_meshed (the mean; beside it the least and the standard
//! deviation), and means over the trials: oracle_queries (segments), certificates (boxes), vertices, seconds.
//! The plot has the fraction meshed against the number of components, a line for each method.
Report report_of(const Figure& figure);

} // namespace voroprobe::bench
