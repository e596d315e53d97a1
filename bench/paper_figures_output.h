#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "bench/paper_figures_trials.h"

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

void print_table(std::ostream& out, const Figure& figure);

//! {figure, title, seed, note, rows}; of each row the method, the number of components under the name
//! `counted`, trials, complete_trials, fraction_meshed (the mean; beside it the least and the standard
//! deviation), and means over the trials: oracle_queries (segments), certificates (boxes), vertices, seconds.
nlohmann::json to_json(const Figure& figure);

//! A plot of the fraction meshed against the number of components, a line for each method, as an SVG file's
//! text.
std::string to_svg(const Figure& figure);

} // namespace voroprobe::bench
