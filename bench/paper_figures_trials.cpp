#include "bench/paper_figures_trials.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <set>
#include <stdexcept>

#include "mesh/topology.h"
#include "mesher/seeded_mesher.h"

namespace voroprobe::bench
{
namespace
{

//! Counts the questions about boxes, which the mesher's own statistics do not.
class CertificateCounter final : public SurfaceOracle
{
public:
    explicit CertificateCounter(const SurfaceOracle& oracle) : oracle_(oracle) {}

    [[nodiscard]] std::size_t count() const { return count_; }

    [[nodiscard]] Box3 domain() const override { return oracle_.domain(); }
    [[nodiscard]] Region region(const Point3& p) const override { return oracle_.region(p); }
    void find_crossings(const Segment3& segment, std::vector<Crossing>& crossings) const override
    {
        oracle_.find_crossings(segment, crossings);
    }
    [[nodiscard]] bool may_cross(const Box3& box) const override
    {
        ++count_;
        return oracle_.may_cross(box);
    }

private:
    const SurfaceOracle& oracle_;
    mutable std::atomic<std::size_t> count_ = 0;
};

//! A piece of the mesh: its size and the components its vertices lie on.
struct Piece
{
    std::set<std::uint32_t> vertices;
    std::set<std::size_t> components;
    long faces = 0;

    //! Of a closed triangle mesh: three edges to two faces.
    [[nodiscard]] long euler_characteristic() const { return static_cast<long>(vertices.size()) - faces / 2; }
};

std::vector<Piece> pieces_of(const TriangleMesh& mesh, const Scene& scene)
{
    const std::vector<std::uint32_t> piece_of_face = component_of_faces(mesh);
    std::vector<Piece> pieces(count_components(mesh));
    for (std::size_t face = 0; face < mesh.faces.size(); ++face)
    {
        Piece& piece = pieces[piece_of_face[face]];
        ++piece.faces;
        for (const std::uint32_t vertex : mesh.faces[face])
            if (piece.vertices.insert(vertex).second)
                piece.components.insert(scene.component_at(mesh.vertices[vertex]));
    }
    return pieces;
}

bool is_copy(const Piece& piece, const Scene& scene)
{
    return piece.components.size() == 1 &&
           piece.euler_characteristic() == scene.euler_characteristics[*piece.components.begin()];
}

template <class Value>
double mean(const std::vector<Trial>& trials, Value value)
{
    double sum = 0.0;
    for (const Trial& trial : trials)
        sum += value(trial);
    return trials.empty() ? 0.0 : sum / static_cast<double>(trials.size());
}

double fraction(const Trial& trial)
{
    return static_cast<double>(trial.meshed) / static_cast<double>(trial.components);
}

} // namespace

Trial judge(const TriangleMesh& mesh, const Scene& scene)
{
    const std::vector<Piece> pieces = pieces_of(mesh, scene);
    std::set<std::size_t> meshed;
    for (const Piece& piece : pieces)
        if (is_copy(piece, scene))
            meshed.insert(*piece.components.begin());
    Trial trial;
    trial.components = scene.euler_characteristics.size();
    trial.meshed = meshed.size();
    trial.complete = meshed.size() == trial.components && pieces.size() == trial.components;
    return trial;
}

Trial run_trial(const Scene& scene, const Method& method, std::uint64_t random_seed)
{
    MeshingOptions options = scene.options;
    options.seeding = method.seeding;
    options.random_points = method.random_points;
    options.random_seed = random_seed;
    options.seeds = method.seeds;
    options.component_radius = method.component_radius;
    const CertificateCounter oracle(*scene.oracle);
    const MeshingResult result = mesh_surface(oracle, options);
    if (!result.mesh.faces.empty() && !is_closed_manifold(result.mesh))
        throw std::runtime_error(method.name + ": the mesh is not a closed manifold");

    const MeshingStatistics& work = result.statistics;
    Trial trial = judge(result.mesh, scene);
    trial.oracle_queries = work.queries_initialization + work.queries_refinement + work.queries_probing;
    trial.certificates = oracle.count();
    trial.vertices = result.mesh.vertices.size();
    trial.seconds = work.seconds_refinement;
    return trial;
}

std::size_t Row::complete_trials() const
{
    const auto count =
        std::count_if(trials.begin(), trials.end(), [](const Trial& trial) { return trial.complete; });
    return static_cast<std::size_t>(count);
}

double Row::mean_fraction() const
{
    return mean(trials, fraction);
}

double Row::least_fraction() const
{
    double least = 1.0;
    for (const Trial& trial : trials)
        least = std::min(least, fraction(trial));
    return least;
}

double Row::fraction_deviation() const
{
    const double center = mean_fraction();
    return std::sqrt(mean(trials, [&](const Trial& trial) { return std::pow(fraction(trial) - center, 2); }));
}

double Row::mean_queries() const
{
    return mean(trials, [](const Trial& trial) { return static_cast<double>(trial.oracle_queries); });
}

double Row::mean_certificates() const
{
    return mean(trials, [](const Trial& trial) { return static_cast<double>(trial.certificates); });
}

double Row::mean_vertices() const
{
    return mean(trials, [](const Trial& trial) { return static_cast<double>(trial.vertices); });
}

double Row::mean_seconds() const
{
    return mean(trials, [](const Trial& trial) { return trial.seconds; });
}

} // namespace voroprobe::bench
