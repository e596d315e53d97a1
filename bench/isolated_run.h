#pragma once

#include <cstddef>

#include "bench/contestants.h"

namespace voroprobe::bench
{

//! Facts about one run. Plain data: it travels through a pipe.
struct RunRecord
{
    double wall_seconds = 0.0;         //!< of Contestant::mesh()
    double cpu_seconds = 0.0;          //!< the same, processor time of all threads
    std::size_t peak_memory_bytes = 0; //!< that mesh() added to what was in memory before it
    std::size_t vertices = 0;
    std::size_t faces = 0;

    // Of checked runs only.
    double min_angle_deg = 0.0;
    double mean_min_angle_deg = 0.0;
    std::size_t faces_below_angle_bound = 0;
    std::size_t components = 0;
    std::size_t boundary_edges = 0;
    std::size_t non_manifold_edges = 0;
    std::size_t non_manifold_vertices = 0;
    std::size_t misoriented_edges = 0;
    double area = 0.0;
};

enum class Checks
{
    kNone,
    kAll //!< topology, angles, area
};

//! Runs a contestant once in a child process, so that its peak memory is its own and a crash is only its own.
//! \throw std::runtime_error where the child did not finish; names the contestant and what ended it.
RunRecord run_isolated(const Entry& contestant, const MeshingTask& task, Checks checks);

} // namespace voroprobe::bench
