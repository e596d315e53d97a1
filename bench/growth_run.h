#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "mesher/seeded_mesher.h"
#include "volume/volume.h"

namespace voroprobe::bench
{

//! How much of our work is timed.
enum class Part
{
    kRefinement, //!< without inventory: no surface is looked for
    kWhole       //!< inventory, and the whole mesh
};

struct GrowthTask
{
    std::shared_ptr<const Volume> volume;
    double isovalue;
    double size;     //!< largest surface Delaunay ball radius, mm
    double distance; //!< largest center distance, mm
    Part part;
};

//! Facts about one run on one thread. Plain data: it travels through a file.
struct GrowthRecord
{
    std::size_t vertices;
    std::size_t surfaces; //!< pieces of the mesh
    double cpu_seconds;
    std::size_t peak_memory_bytes; //!< that the run added to what was there
    MeshingStatistics statistics;
};

//! Meshes in a process of its own; the quickest of several runs, where one is short. \throw
//! std::runtime_error where that fails; names the run.
GrowthRecord run_growth(const std::string& name, const GrowthTask& task);

} // namespace voroprobe::bench
