#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "bench/isolated_run.h"

namespace voroprobe::bench
{

//! What one contestant achieved: the checked run, and the timed ones after it.
struct Standing
{
    std::string name;
    RunRecord checked;
    std::vector<double> seconds;       //!< one per timed run
    std::size_t peak_memory_bytes = 0; //!< largest of the timed runs

    [[nodiscard]] double median_seconds() const;
    [[nodiscard]] double vertices_per_second() const;
    [[nodiscard]] double bytes_per_vertex() const;
    [[nodiscard]] bool closed() const { return checked.boundary_edges == 0; }
    [[nodiscard]] bool manifold() const
    {
        return checked.non_manifold_edges == 0 && checked.non_manifold_vertices == 0;
    }
};

//! One line per contestant; the ratio is the first one's vertices/s over each one's.
void print_table(std::ostream& out, const std::vector<Standing>& standings);

nlohmann::json to_json(const std::vector<Standing>& standings);

} // namespace voroprobe::bench
