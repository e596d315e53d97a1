#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "cli/mesh_defaults.h"
#include "cli/output_frame.h"
#include "mesher/meshing_options.h"

namespace CLI // NOLINT(readability-identifier-naming): the name of the library
{
class App;
}

namespace voroprobe
{

//! What the user knows of the components, and how those that are not known are looked for.
struct SeedingArguments
{
    std::optional<Seeding> seeding = std::nullopt; //!< unset: as MeshingOptions has it
    std::optional<std::size_t> random_points = std::nullopt;
    std::optional<double> component_radius = std::nullopt; //!< mm, at least the reach
    std::optional<std::size_t> component_count = std::nullopt;
    std::optional<std::filesystem::path> seeds = std::nullopt;
    std::optional<double> max_seconds = std::nullopt;
    bool theorem = false;
};

//! Declares the options; `arguments` must outlive the parsing and holds the values after it.
void add_seeding_options(CLI::App& command, SeedingArguments& arguments);

//! Largest surface Delaunay ball for which the theorem holds, in reaches. Source: Boissonnat & Oudot 2005,
//! Theorem 4.4; the report's "0.019" in the pseudo-code and in the proof of Proposition 3 is a misprint of
//! it.
inline constexpr double kTheoremSizeInReaches = 0.091;

//! \throw UsageError where --theorem is given beside what it settles.
void check_theorem(const SeedingArguments& arguments, const RequestedCriteria& criteria);

//! Puts the arguments into the options; seeds from world to grid coordinates. \throw UsageError where they
//! contradict each other; InputError where the seeds cannot be read.
void apply_seeding(const SeedingArguments& arguments, const GridPlacement& placement,
                   MeshingOptions& options);

} // namespace voroprobe
