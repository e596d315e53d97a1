#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/paper_figures_scenes.h"
#include "mesh/triangle_mesh.h"

namespace voroprobe::bench
{

//! A way to get points onto the components.
struct Method
{
    std::string name;
    Seeding seeding = Seeding::kProbe;
    std::size_t random_points = 0;               //!< Seeding::kRandom only
    std::vector<Point3> seeds = {};              //!< given beside those
    std::optional<double> component_radius = {}; //!< as MeshingOptions has it
    bool must_be_complete = false;               //!< it promises every component
};

//! What one run made of a scene.
struct Trial
{
    std::size_t components = 0;     //!< of the surface
    std::size_t meshed = 0;         //!< of which a piece of the mesh is a copy
    bool complete = false;          //!< the mesh is a copy of each component, once, and nothing else
    std::size_t oracle_queries = 0; //!< about segments
    std::size_t certificates = 0;   //!< questions whether a box may hold surface
    std::size_t vertices = 0;
    double seconds = 0.0;
};

//! Trials of one method at one number of components.
struct Row
{
    std::string method;
    std::size_t components = 0;
    bool must_be_complete = false;
    std::vector<Trial> trials = {};

    [[nodiscard]] std::size_t complete_trials() const;
    [[nodiscard]] double mean_fraction() const; //!< of components meshed
    [[nodiscard]] double least_fraction() const;
    [[nodiscard]] double fraction_deviation() const; //!< standard deviation over the trials
    [[nodiscard]] double mean_queries() const;
    [[nodiscard]] double mean_certificates() const;
    [[nodiscard]] double mean_vertices() const;
    [[nodiscard]] double mean_seconds() const;
    [[nodiscard]] bool keeps_promise() const
    {
        return !must_be_complete || complete_trials() == trials.size();
    }
};

//! Which components the mesh has a copy of, and whether it is nothing but them; the rest is left.
Trial judge(const TriangleMesh& mesh, const Scene& scene);

//! Meshes the scene with the method. A piece of the mesh is a copy of a component when all its vertices lie
//! on it and it has its Euler characteristic; that pieces are closed manifolds is checked. \throw
//! std::runtime_error where they are not.
Trial run_trial(const Scene& scene, const Method& method, std::uint64_t random_seed);

} // namespace voroprobe::bench
