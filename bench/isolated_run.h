#pragma once

#include <cstddef>

#include "bench/contestants.h"

namespace voroprobe::bench
{

//! Facts about one run. Plain data: it travels through a pipe.
struct RunRecord
{
    double wall_seconds = 0.0; //!< of Contestant::mesh()
    double cpu_seconds = 0.0;  //!< the same, processor time of all threads and programs it starts
    std::size_t peak_memory_bytes =
        0; //!< that mesh() added to what was there before it; of a program, all of it
    std::size_t vertices = 0;
    std::size_t faces = 0;

    // Of checked runs of meshers only.
    double mean_edge_length = 0.0;
    double min_angle_deg = 0.0;
    double mean_min_angle_deg = 0.0;
    std::size_t faces_below_30_deg = 0;
    std::size_t pieces = 0;
    std::size_t boundary_edges = 0;
    std::size_t non_manifold_edges = 0;
    std::size_t non_manifold_vertices = 0;
    std::size_t misoriented_edges = 0;
    std::size_t self_intersections = 0;
    double area = 0.0;
    std::size_t surfaces_there = 0; //!< of the scan
    std::size_t surfaces_found = 0; //!< of these, with closed pieces of their own
    double distance_max = 0.0;      //!< both ways between mesh and scan, mm
    double distance_mean = 0.0;
    double distance_root_mean_square = 0.0;
};

enum class Checks
{
    kNone,
    kAll //!< for meshers: topology, angles, surfaces, distance
};

//! Runs a contestant once in a child process, so that its peak memory is its own and a crash is only its own.
//! \throw std::runtime_error where the child did not finish; names the contestant and what ended it.
RunRecord run_isolated(const Entry& contestant, const MeshingTask& task, const ReferenceSurface& reference,
                       Checks checks);

} // namespace voroprobe::bench
