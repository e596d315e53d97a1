#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "mesh/topology.h"
#include "mesher/probe_queue.h"
#include "mesher/seeded_mesher.h"
#include "oracles/sphere_union_oracle.h"
#include "support/error.h"
#include "support/random.h"
#include "support/union_find.h"

namespace voroprobe
{
namespace
{

constexpr std::size_t kSamples = 100000;
constexpr double kContact = 1e-6; //!< segments this near touch: far above rounding, far below the reach

//! Another oracle that remembers what it was asked, and where it certified that there is no surface.
class RecordingOracle final : public SurfaceOracle
{
public:
    explicit RecordingOracle(const SurfaceOracle& oracle) : oracle_(oracle) {}

    [[nodiscard]] Box3 domain() const override { return oracle_.domain(); }
    [[nodiscard]] Region region(const Point3& p) const override { return oracle_.region(p); }
    void find_crossings(const Segment3& segment, std::vector<Crossing>& crossings) const override
    {
        segments.push_back(segment);
        oracle_.find_crossings(segment, crossings);
    }
    [[nodiscard]] bool may_cross(const Box3& box) const override
    {
        const bool answer = oracle_.may_cross(box);
        if (!answer)
            certified.push_back(box);
        return answer;
    }

    mutable std::vector<Segment3> segments;
    mutable std::vector<Box3> certified;

private:
    const SurfaceOracle& oracle_;
};

double squared_distance_to_segment(const Point3& p, const Segment3& s)
{
    const Vec3 along = s.target - s.source;
    const double squared_length = squared_norm(along);
    const double t =
        squared_length > 0.0 ? std::clamp(dot(p - s.source, along) / squared_length, 0.0, 1.0) : 0.0;
    return squared_distance(p, s.at(t));
}

//! Source: Ericson, Real-Time Collision Detection, 2005, Sec. 5.1.9.
double squared_distance_between(const Segment3& a, const Segment3& b)
{
    double least =
        std::min({squared_distance_to_segment(a.source, b), squared_distance_to_segment(a.target, b),
                  squared_distance_to_segment(b.source, a), squared_distance_to_segment(b.target, a)});
    const Vec3 u = a.target - a.source;
    const Vec3 v = b.target - b.source;
    const Vec3 r = a.source - b.source;
    const double denominator = squared_norm(u) * squared_norm(v) - dot(u, v) * dot(u, v);
    if (denominator > 0.0)
    {
        const double s = (dot(u, v) * dot(v, r) - dot(u, r) * squared_norm(v)) / denominator;
        const double t = (squared_norm(u) * dot(v, r) - dot(u, v) * dot(u, r)) / denominator;
        if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0)
            least = std::min(least, squared_distance(a.at(s), b.at(t)));
    }
    return least;
}

//! What is known of a domain after a run: probed segments and certified boxes, in buckets as wide as the
//! reach.
class Known
{
public:
    Known(const RecordingOracle& oracle, double reach)
        : domain_(oracle.domain()), reach_(reach), boxes_(oracle.certified)
    {
        for (const Segment3& segment : oracle.segments)
        {
            const auto range = clip_to_box(segment, domain_.expanded(reach));
            if (!range || segment.source == segment.target)
                continue;
            segments_.push_back({segment.at(range->first), segment.at(range->second)});
            leaves_.push_back(range->first > 0.0 || range->second < 1.0);
        }
        for (std::uint32_t i = 0; i < segments_.size(); ++i)
        {
            const double length = distance(segments_[i].source, segments_[i].target);
            const int steps = static_cast<int>(std::ceil(2.0 * length / reach_)) + 1;
            for (int k = 0; k <= steps; ++k)
            {
                auto& bucket = buckets_[key(segments_[i].at(static_cast<double>(k) / steps))];
                if (bucket.empty() || bucket.back() != i)
                    bucket.push_back(i);
            }
        }
        find_connected();
    }

    //! Whether a point is within the reach of a probed segment, or in a certified box, that is connected to
    //! the outside of the domain.
    [[nodiscard]] bool covers(const Point3& p) const
    {
        for (std::size_t b = 0; b < boxes_.size(); ++b)
        {
            if (connected_[segments_.size() + b] && boxes_[b].contains(p))
                return true;
        }
        bool found = false;
        visit_near(p, 2,
                   [&](std::uint32_t i) {
                       found = found || (connected_[i] &&
                                         squared_distance_to_segment(p, segments_[i]) <= reach_ * reach_);
                   });
        return found;
    }

private:
    using Key = std::array<int, 3>;
    [[nodiscard]] Key key(const Point3& p) const
    {
        return {static_cast<int>(std::floor(p.x / reach_)), static_cast<int>(std::floor(p.y / reach_)),
                static_cast<int>(std::floor(p.z / reach_))};
    }

    template <typename Visit>
    void visit_near(const Point3& p, int rings, Visit visit) const
    {
        const Key center = key(p);
        for (int x = -rings; x <= rings; ++x)
            for (int y = -rings; y <= rings; ++y)
                for (int z = -rings; z <= rings; ++z)
                {
                    const auto bucket = buckets_.find({center[0] + x, center[1] + y, center[2] + z});
                    if (bucket == buckets_.end())
                        continue;
                    for (const std::uint32_t i : bucket->second)
                        visit(i);
                }
    }

    void find_connected()
    {
        const std::size_t outside = segments_.size() + boxes_.size();
        UnionFind sets(outside + 1);
        const auto unite = [&](std::size_t a, std::size_t b)
        { sets.unite(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)); };
        for (const auto& [at, bucket] : buckets_)
        {
            const Point3 middle{(at[0] + 0.5) * reach_, (at[1] + 0.5) * reach_, (at[2] + 0.5) * reach_};
            for (const std::uint32_t i : bucket)
                visit_near(middle, 1,
                           [&](std::uint32_t j)
                           {
                               if (j < i && sets.find(i) != sets.find(j) &&
                                   squared_distance_between(segments_[i], segments_[j]) <=
                                       kContact * kContact)
                                   unite(i, j);
                           });
        }
        for (std::size_t i = 0; i < segments_.size(); ++i)
        {
            if (leaves_[i])
                unite(i, outside);
        }
        for (std::size_t b = 0; b < boxes_.size(); ++b)
        {
            const Box3 grown = boxes_[b].expanded(kContact);
            const std::size_t node = segments_.size() + b;
            if (!domain_.contains(grown.min) || !domain_.contains(grown.max))
                unite(node, outside);
            for (std::size_t i = 0; i < segments_.size(); ++i)
            {
                if (clip_to_box(segments_[i], grown))
                    unite(node, i);
            }
            for (std::size_t c = 0; c < b; ++c)
            {
                if (grown.min.x <= boxes_[c].max.x && boxes_[c].min.x <= grown.max.x &&
                    grown.min.y <= boxes_[c].max.y && boxes_[c].min.y <= grown.max.y &&
                    grown.min.z <= boxes_[c].max.z && boxes_[c].min.z <= grown.max.z)
                    unite(node, segments_.size() + c);
            }
        }
        connected_.resize(outside);
        for (std::uint32_t i = 0; i < outside; ++i)
            connected_[i] = sets.find(i) == sets.find(static_cast<std::uint32_t>(outside));
    }

    Box3 domain_;
    double reach_;
    std::vector<Segment3> segments_; //!< clipped to the domain and what is within the reach of it
    std::vector<bool> leaves_;       //!< the segment goes on beyond the domain
    std::vector<Box3> boxes_;
    std::map<Key, std::vector<std::uint32_t>> buckets_;
    std::vector<bool> connected_; //!< to the outside: segments, then boxes
};

//! Three spheres, one within another, in a domain much larger than they.
SphereUnionOracle scattered_spheres()
{
    return SphereUnionOracle({{{0, 0, 0}, 3.0}, {{0.3, 0, 0}, 1.2}, {{11, 4, -7}, 1.1}, {{-8, 9, 6}, 1.3}},
                             3.0);
}

MeshingOptions options_for(double reach, bool certified_skipping)
{
    MeshingOptions options{
        .max_facet_radius = 0.6, .max_facet_distance = 0.1, .floor_radius = 0.01, .reach_lower_bound = reach};
    options.certified_skipping = certified_skipping;
    return options;
}

class CellProbing : public ::testing::TestWithParam<bool>
{
};

INSTANTIATE_TEST_SUITE_P(Skipping, CellProbing, ::testing::Values(false, true),
                         [](const auto& test) { return test.param ? "with_certificates" : "without"; });

TEST_P(CellProbing, finds_every_component)
{
    const auto result = mesh_surface(scattered_spheres(), options_for(0.8, GetParam()));
    const MeshTopology topology = analyze_topology(result.mesh);
    EXPECT_EQ(result.status, MeshingStatus::kDone);
    EXPECT_TRUE(topology.closed());
    EXPECT_EQ(topology.components, 4U);
    EXPECT_EQ(topology.euler_characteristic, 8);
}

// Every point is near a probe, or in a box known to be empty, that is connected to the outside: this is what
// the proof of Proposition 4 needs, in one sentence.
TEST_P(CellProbing, leaves_no_point_of_the_domain_farther_from_connected_probes_than_the_reach)
{
    const SphereUnionOracle spheres = scattered_spheres();
    const RecordingOracle oracle(spheres);
    constexpr double kReach = 0.8;
    mesh_surface(oracle, options_for(kReach, GetParam()));
    const Known known(oracle, kReach);
    Random random(1);
    const Box3 domain = oracle.domain();
    std::size_t uncovered = 0;
    for (std::size_t i = 0; i < kSamples; ++i)
    {
        const Point3 p{random.uniform(domain.min.x, domain.max.x), random.uniform(domain.min.y, domain.max.y),
                       random.uniform(domain.min.z, domain.max.z)};
        uncovered += known.covers(p) ? 0 : 1;
    }
    EXPECT_EQ(uncovered, 0U);
}

TEST_P(CellProbing, begins_at_an_isolated_speck_that_no_voronoi_edge_meets)
{
    const SphereUnionOracle oracle({{{0, 0, 0}, 3.0}, {{30, 1, 2}, 0.5}}, 3.0);
    const auto result = mesh_surface(oracle, options_for(0.45, GetParam()));
    EXPECT_EQ(analyze_topology(result.mesh).components, 2U);
    const MeshingStatistics& s = result.statistics;
    EXPECT_EQ(s.components_by_initialization + s.components_by_isolated_vertex + s.components_by_refinement +
                  s.components_by_probing,
              2U);
}

TEST_P(CellProbing, takes_a_ball_for_a_domain)
{
    MeshingOptions options = options_for(0.8, GetParam());
    options.domain_ball = Ball{{1, 1, 1}, 18.0};
    EXPECT_EQ(analyze_topology(mesh_surface(scattered_spheres(), options).mesh).components, 4U);
}

TEST_P(CellProbing, passes_over_crossings_near_the_mesh)
{
    const SphereUnionOracle oracle({{{0, 0, 0}, 3.0}}, 5.0);
    MeshingOptions options = options_for(0.8, GetParam());
    const auto probed = mesh_surface(oracle, options);
    options.seeding = Seeding::kIsolated;
    const auto unprobed = mesh_surface(oracle, options);
    EXPECT_EQ(probed.statistics.probe_hits, 0U);
    EXPECT_EQ(probed.mesh.vertices.size(), unprobed.mesh.vertices.size());
}

TEST_P(CellProbing, with_a_larger_component_radius_costs_fewer_queries)
{
    MeshingOptions options = options_for(0.3, GetParam());
    const auto fine = mesh_surface(scattered_spheres(), options);
    options.component_radius = 1.0;
    const auto coarse = mesh_surface(scattered_spheres(), options);
    EXPECT_EQ(analyze_topology(coarse.mesh).components, 4U);
    EXPECT_LT(2 * coarse.statistics.queries_probing, fine.statistics.queries_probing);
}

TEST(Seeding, with_known_seeds_and_count_spends_no_probes)
{
    MeshingOptions options = options_for(0.8, true);
    options.seeds = {{3.1, 0, 0}, {1.4, 0, 0}, {11, 4, -5.8}, {-8, 9, 7.2}};
    options.component_count = 4;
    const auto result = mesh_surface(scattered_spheres(), options);
    EXPECT_EQ(analyze_topology(result.mesh).components, 4U);
    EXPECT_EQ(result.statistics.queries_probing, 0U);
    EXPECT_EQ(result.statistics.seeds_off_surface, 0U);
}

TEST(Seeding, counts_seeds_off_the_surface_and_probes_all_the_same)
{
    MeshingOptions options = options_for(0.8, true);
    options.seeds = {{8, 8, 8}};
    const auto result = mesh_surface(scattered_spheres(), options);
    EXPECT_EQ(result.statistics.seeds_off_surface, 1U);
    EXPECT_EQ(analyze_topology(result.mesh).components, 4U);
}

//! Figure 4 of the report: 303 vertices from 50 points, 171 from 5.
TEST(Seeding, from_fifty_points_takes_no_more_vertices_than_from_five)
{
    const SphereUnionOracle oracle({{{0, 0, 0}, 1.0}});
    const auto mean_vertices = [&](std::size_t points)
    {
        constexpr std::uint64_t kTrials = 10;
        MeshingOptions options{.max_facet_radius = 0.25, .floor_radius = 1e-6, .reach_lower_bound = 0.5};
        options.seeding = Seeding::kRandom;
        options.random_points = points;
        std::size_t vertices = 0;
        for (std::uint64_t trial = 0; trial < kTrials; ++trial)
        {
            options.random_seed = trial;
            const auto result = mesh_surface(oracle, options);
            EXPECT_EQ(analyze_topology(result.mesh).euler_characteristic, 2);
            vertices += result.mesh.vertices.size();
        }
        return static_cast<double>(vertices) / kTrials;
    };
    EXPECT_LT(mean_vertices(50), 1.1 * mean_vertices(5));
}

TEST(Seeding, passes_over_seeds_that_the_mesh_has_come_to_and_begins_at_all_others)
{
    MeshingOptions options = options_for(0.8, true);
    options.seeding = Seeding::kIsolated;
    for (int i = 0; i < 40; ++i) // a crowd on the large sphere, one seed on each of the others
        options.seeds.push_back({3.0 * std::cos(0.01 * i), 3.0 * std::sin(0.01 * i), 0});
    options.seeds.insert(options.seeds.end(), {{1.4, 0, 0}, {11, 4, -5.9}, {-8, 9, 7.3}});
    const auto result = mesh_surface(scattered_spheres(), options);
    EXPECT_EQ(analyze_topology(result.mesh).components, 4U);
    EXPECT_EQ(result.statistics.seeds_off_surface, 0U);
    EXPECT_GE(result.statistics.seeds_passed_over, 30U);
}

TEST(Seeding, at_random_misses_what_no_ray_meets)
{
    MeshingOptions options = options_for(0.8, true);
    options.seeding = Seeding::kRandom;
    const auto result = mesh_surface(scattered_spheres(), options);
    EXPECT_LT(analyze_topology(result.mesh).components, 4U);
    EXPECT_EQ(result.statistics.queries_probing, 0U);
}

TEST(Seeding, without_probing_misses_a_speck)
{
    MeshingOptions options = options_for(0.4, true);
    options.seeding = Seeding::kIsolated;
    const SphereUnionOracle oracle({{{0, 0, 0}, 3.0}, {{300, 1, 2}, 0.5}}, 3.0);
    EXPECT_EQ(analyze_topology(mesh_surface(oracle, options).mesh).components, 1U);
    options.seeding = Seeding::kProbe;
    EXPECT_EQ(analyze_topology(mesh_surface(oracle, options).mesh).components, 2U);
}

TEST(Budget, of_no_time_gives_a_flagged_partial_result)
{
    MeshingOptions options = options_for(0.8, true);
    options.max_seconds = 0.0;
    EXPECT_EQ(mesh_surface(scattered_spheres(), options).status, MeshingStatus::kBudgetExhausted);
}

//! Stops when asked for the n-th time.
class StopAtQuestion final : public ProgressSink
{
public:
    explicit StopAtQuestion(std::size_t n) : left_(n) {}
    void report(const ProgressReport& /*report*/) override {}
    [[nodiscard]] bool stop_requested() const override
    {
        left_ -= left_ > 0 ? 1 : 0;
        return left_ == 0;
    }

private:
    mutable std::size_t left_;
};

// Without certificates a single Voronoi cell may take a million probes; a run stops in the middle of it.
TEST(Budget, stops_within_the_probing_of_one_cell)
{
    const SphereUnionOracle spheres({{{0, 0, 0}, 1.0}}, 20.0);
    const RecordingOracle oracle(spheres);
    StopAtQuestion stop(10);
    const auto result = mesh_surface(oracle, options_for(0.05, false), &stop);
    EXPECT_EQ(result.status, MeshingStatus::kInterrupted);
    EXPECT_LT(oracle.segments.size(), 50000U);
    EXPECT_TRUE(result.mesh.faces.empty() || analyze_topology(result.mesh).closed());
}

TEST(Budget, that_is_just_enough_does_not_make_a_result_partial)
{
    MeshingOptions options = options_for(0.8, true);
    const auto free = mesh_surface(scattered_spheres(), options);
    options.max_vertices = free.mesh.vertices.size();
    const auto bounded = mesh_surface(scattered_spheres(), options);
    EXPECT_EQ(bounded.status, MeshingStatus::kDone);
    EXPECT_EQ(bounded.mesh.vertices.size(), free.mesh.vertices.size());
    --*options.max_vertices;
    EXPECT_EQ(mesh_surface(scattered_spheres(), options).status, MeshingStatus::kBudgetExhausted);
}

TEST(Budget, component_radius_below_the_reach_is_refused)
{
    MeshingOptions options = options_for(0.8, true);
    options.component_radius = 0.5;
    EXPECT_THROW(mesh_surface(scattered_spheres(), options), UsageError);
}

//! The spheres in a domain ten times larger in each direction.
TEST(CellProbingCost, follows_the_surface_where_empty_space_is_certified)
{
    const std::vector<Sphere> spheres{{{0, 0, 0}, 3.0}, {{11, 4, -7}, 2.0}};
    const auto cost = [&](double margin)
    {
        const auto s = mesh_surface(SphereUnionOracle(spheres, margin), options_for(0.8, true)).statistics;
        return static_cast<double>(s.queries_probing + s.queries_refinement);
    };
    EXPECT_LT(cost(100.0), 1.1 * cost(1.0));
}

TEST(CellProbingCost, grows_with_the_domain_where_nothing_is_certified)
{
    const std::vector<Sphere> spheres{{{0, 0, 0}, 3.0}};
    const auto cost = [&](double margin)
    {
        return mesh_surface(SphereUnionOracle(spheres, margin), options_for(0.8, false))
            .statistics.queries_probing;
    };
    EXPECT_GT(cost(10.0), 2 * cost(2.0));
}

TEST(ProbeQueue, gives_the_largest_cell_although_cells_have_shrunk_since)
{
    Triangulation triangulation;
    ProbeQueue queue;
    std::vector<double> size{5.0, 9.0, 7.0, 7.0};
    for (std::uint32_t i = 0; i < size.size(); ++i)
    {
        const VertexHandle vertex = triangulation.insert(cgal_point({1.0 * i, 0, 0}));
        vertex->info().index = i;
        queue.push(vertex, size[i]);
    }
    size[1] = 6.0;
    std::vector<std::uint32_t> order;
    while (!queue.empty())
        order.push_back(queue.pop([&](VertexHandle v) { return size[v->info().index]; })->info().index);
    EXPECT_EQ(order, (std::vector<std::uint32_t>{2, 3, 1, 0}));
}

} // namespace
} // namespace voroprobe
