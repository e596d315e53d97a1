#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "bench/isolated_run.h"

namespace voroprobe::bench
{

enum class Clock
{
    kWall,
    kCpu //!< processor time: steadier on a busy machine
};

//! What one contestant achieved: the checked run, and the timed ones after it.
struct Standing
{
    std::string name;
    Kind kind;
    std::size_t threads;
    RunRecord checked;
    std::vector<RunRecord> timed;
    std::optional<std::string> failure = std::nullopt; //!< why it did not finish a run; the others count

    //! 0 where there is no timed run.
    [[nodiscard]] double median_seconds(Clock clock) const;

    //! By processor time on one thread, by the clock on the wall on several.
    [[nodiscard]] double vertices_per_second() const;
    [[nodiscard]] std::size_t peak_memory_bytes() const; //!< largest of the timed runs
    [[nodiscard]] double bytes_per_vertex() const;
    [[nodiscard]] double share_below_30_deg() const; //!< of the faces
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
