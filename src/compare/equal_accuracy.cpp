#include "compare/equal_accuracy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numeric>
#include <optional>

#include "compare/one_thread.h"
#include "mesh/topology.h"

namespace voroprobe
{

namespace
{

using Json = nlohmann::ordered_json;

//! One mesh of a contestant, `factor` times as coarse as the one of the comparison.
struct Trial
{
    double factor;
    std::size_t vertices;
    double max;
    double rms;
};

//! What is made equal.
enum class Goal
{
    kMax,
    kRms
};
constexpr std::array<Goal, 2> kGoals{Goal::kRms, Goal::kMax};

//! Factors tried: a 256th of the length is a 65,536th of a triangle, no mesh of a scan.
constexpr double kFinest = 1.0 / 16.0;
constexpr double kCoarsest = 16.0;

//! Distances grow with lengths to a power between 1 and 2, on noisy scans nearly 1: the first guess.
constexpr double kPower = 1.2;

//! What needs more times the vertices of the reference has lost, and is not followed further.
constexpr double kMostOfReference = 2.0;

//! A contestant that has lost a surface gets no nearer: finer by the first factor or more, it is nearer by
//! less than the second.
constexpr double kFiner = 1.5;
constexpr double kNearer = 1.1;

//! The largest step of a guess, and how far it aims beyond the goal, so that the goal is then between two
//! trials.
constexpr double kLargestStep = 4.0;
constexpr double kBeyond = 1.15;

//! Between two trials the next one aims at this share of the goal: a hair beyond it, and the trial is for
//! nothing.
constexpr double kJustBelow = 0.99;

//! And keeps this share of the way between them from either, or a bent curve would be followed in tiny steps.
//! Largest distances, each that of a single place, follow no line: they are sought by halving, nearly.
double least_share_of_way(Goal goal)
{
    return goal == Goal::kMax ? 0.25 : 0.1;
}

//! The search ends where the next trial would change the factor by less: its vertices by 3 %.
constexpr double kSmallestChange = 1.015;

//! Runs of a contestant for one goal, at most.
constexpr std::size_t kTrialsPerGoal = 4;

//! The headline is about ours: so many trials of it come before the first one of others.
constexpr std::size_t kOursAhead = 3;

double value(const Trial& trial, Goal goal)
{
    return goal == Goal::kMax ? trial.max : trial.rms;
}

//! The trials of a contestant, and what to try next.
class Search
{
public:
    Search(const Trial& first, const Trial& reference) : reference_(reference), trials_{first} {}

    void add(const Trial& trial) { trials_.push_back(trial); }

    //! nullopt where nothing is left to learn.
    [[nodiscard]] std::optional<double> next(Goal goal) const
    {
        const Trial* good = nullptr; // the coarsest that is as near as the goal
        for (const Trial& trial : trials_)
            if (value(trial, goal) <= target(goal) && (good == nullptr || trial.factor > good->factor))
                good = &trial;
        const Trial* bad = nullptr; // the finest that is not, coarser than that
        for (const Trial& trial : trials_)
            if (value(trial, goal) > target(goal) && (good == nullptr || trial.factor > good->factor) &&
                (bad == nullptr || trial.factor < bad->factor))
                bad = &trial;
        if (good != nullptr && bad != nullptr)
            return between(*good, *bad, goal);
        if (good == nullptr && gets_no_nearer(*bad, goal))
            return std::nullopt;
        return good != nullptr ? beyond(*good, goal, kBeyond) : beyond(*bad, goal, 1.0 / kBeyond);
    }

    [[nodiscard]] std::optional<Trial> best(Goal goal) const
    {
        std::optional<Trial> best;
        for (const Trial& trial : trials_)
            if (value(trial, goal) <= target(goal) && (!best || trial.vertices < best->vertices))
                best = trial;
        return best;
    }

    [[nodiscard]] const std::vector<Trial>& trials() const { return trials_; }

private:
    [[nodiscard]] double target(Goal goal) const { return value(reference_, goal); }

    //! Along a straight line in logarithms, but not too near an end.
    [[nodiscard]] std::optional<double> between(const Trial& good, const Trial& bad, Goal goal) const
    {
        const double ratio = bad.factor / good.factor;
        if (ratio < kSmallestChange)
            return std::nullopt;
        const double whole = std::log(value(bad, goal) / value(good, goal));
        const double part = std::log(kJustBelow * target(goal) / value(good, goal));
        const double least = least_share_of_way(goal);
        return good.factor * std::pow(ratio, std::clamp(part / whole, least, 1.0 - least));
    }

    [[nodiscard]] std::optional<double> beyond(const Trial& trial, Goal goal, double aim) const
    {
        const double step = aim * std::pow(target(goal) / value(trial, goal), 1.0 / kPower);
        // Vertices go with the inverse square of lengths.
        const double finest_step = std::sqrt(static_cast<double>(trial.vertices) /
                                             (kMostOfReference * static_cast<double>(reference_.vertices)));
        const double factor =
            trial.factor *
            std::clamp(step, std::min(1.0, std::max(1.0 / kLargestStep, finest_step)), kLargestStep);
        const bool learns =
            factor > trial.factor * kSmallestChange || factor < trial.factor / kSmallestChange;
        return learns && factor >= kFinest && factor <= kCoarsest ? std::optional(factor) : std::nullopt;
    }

    [[nodiscard]] bool gets_no_nearer(const Trial& finest, Goal goal) const
    {
        return std::any_of(trials_.begin(), trials_.end(),
                           [&](const Trial& trial) {
                               return trial.factor >= kFiner * finest.factor &&
                                      value(trial, goal) < kNearer * value(finest, goal);
                           });
    }

    Trial reference_;
    std::vector<Trial> trials_;
};

Trial trial_of(double factor, const Json& report)
{
    const Json& distance = report.at("distance").at("mm");
    return {factor, report.at("vertices"), distance.at("max"), distance.at("rms")};
}

Json json_of(const Trial& trial)
{
    return {
        {"factor", trial.factor}, {"vertices", trial.vertices}, {"max_mm", trial.max}, {"rms_mm", trial.rms}};
}

//! In the child.
void run_trial(const ContestantEntry& entry, const MeshingTask& task, double factor,
               const ReferenceSurface& reference, const MeasuringOptions& options, ChildOutput& output)
{
    const OneThread one_thread;
    const auto contestant = entry.make(coarser(task, entry.knob, factor));
    StageClock clock;
    contestant->mesh(clock);
    const TriangleMesh mesh = weld(contestant->result());
    const TwoSidedDistance distance = measure_distance(mesh, reference, options);
    output.send(json_of(Trial{factor, mesh.vertices.size(), distance.max, distance.root_mean_square}).dump());
}

class Sweep
{
public:
    Sweep(const ContestantOutcome& outcome, const Trial& reference)
        : outcome_(outcome), search_(trial_of(1.0, outcome.report), reference),
          reference_vertices_(reference.vertices)
    {
    }

    [[nodiscard]] const ContestantEntry& entry() const { return outcome_.entry; }

    //! The factor of the next trial for a goal. nullopt where there is none, or the one before is not done.
    [[nodiscard]] std::optional<double> next(Goal goal) const
    {
        const Progress& progress = progress_[static_cast<std::size_t>(goal)];
        return failure_ || progress.running || progress.begun == kTrialsPerGoal ? std::nullopt
                                                                                : search_.next(goal);
    }

    void begin(Goal goal)
    {
        Progress& progress = progress_[static_cast<std::size_t>(goal)];
        progress.running = true;
        ++progress.begun;
    }

    void stop(const std::string& reason) { failure_ = reason; }

    void take(Goal goal, const ChildResult& result)
    {
        progress_[static_cast<std::size_t>(goal)].running = false;
        if (result.parts.empty())
            return stop(result.failure.value_or("it sent nothing"));
        const Json trial = Json::parse(result.parts.front());
        search_.add({trial.at("factor"), trial.at("vertices"), trial.at("max_mm"), trial.at("rms_mm")});
    }

    [[nodiscard]] std::size_t trials_begun() const
    {
        return std::accumulate(progress_.begin(), progress_.end(), std::size_t{0},
                               [](std::size_t sum, const Progress& one) { return sum + one.begun; });
    }

    [[nodiscard]] Json report() const
    {
        Json trials = Json::array();
        for (const Trial& trial : search_.trials())
            trials.push_back(json_of(trial));
        Json json = {{"name", entry().name},
                     {"trials", trials},
                     {"at_equal_max", best_json(Goal::kMax)},
                     {"at_equal_rms", best_json(Goal::kRms)}};
        if (failure_)
            json["ended_by"] = *failure_;
        return json;
    }

private:
    [[nodiscard]] Json best_json(Goal goal) const
    {
        const auto best = search_.best(goal);
        if (!best)
            return nullptr;
        return {
            {"vertices", best->vertices},
            {"of_reference", static_cast<double>(best->vertices) / static_cast<double>(reference_vertices_)}};
    }

    struct Progress
    {
        std::size_t begun = 0;
        bool running = false;
    };

    const ContestantOutcome& outcome_;
    Search search_;
    std::size_t reference_vertices_;
    std::optional<std::string> failure_;
    std::array<Progress, kGoals.size()> progress_{}; //!< by goal
};

//! Runs trials of all sweeps, a few of ours first, until nothing is left to try or the processor time is
//! used. Trials that run then are waited for.
class SweepRun
{
public:
    SweepRun(std::deque<Sweep>& sweeps, const MeshingTask& task, const ReferenceSurface& reference,
             const CompetitionOptions& options)
        : sweeps_(sweeps), task_(task), reference_(reference), options_(options), pool_(options.at_once)
    {
    }

    void run()
    {
        begin_more();
        pool_.run();
    }

private:
    struct Next
    {
        Sweep& sweep;
        Goal goal;
        double factor;
    };

    //! Of the sweep with the fewest trials; ours may be some ahead.
    [[nodiscard]] std::optional<Next> next()
    {
        std::optional<Next> best;
        for (Sweep& sweep : sweeps_)
            for (const Goal goal : kGoals)
                if (const auto factor = sweep.next(goal);
                    factor && (!best || goes_before(sweep, best->sweep)))
                    best.emplace(Next{sweep, goal, *factor});
        return best;
    }

    static bool goes_before(const Sweep& a, const Sweep& b) { return turn_of(a) < turn_of(b); }

    static std::size_t turn_of(const Sweep& sweep)
    {
        return sweep.trials_begun() + (sweep.entry().name == kOurs ? 0 : kOursAhead);
    }

    //! Keeps as many trials running as are allowed.
    void begin_more()
    {
        while (running_ < options_.at_once)
        {
            const std::optional<Next> trial = next();
            if (!trial)
                return;
            if (cpu_seconds_ < options_.sweep_seconds)
                begin(*trial);
            else
                trial->sweep.stop("the time for it was over");
        }
    }

    void begin(const Next& trial)
    {
        ++running_;
        trial.sweep.begin(trial.goal);
        pool_.add(
            [this, trial](ChildOutput& output)
            { run_trial(trial.sweep.entry(), task_, trial.factor, reference_, options_.measuring, output); },
            [this, trial](const ChildResult& result) { take(trial, result); }, options_.contestant_seconds);
    }

    void take(const Next& trial, const ChildResult& result)
    {
        --running_;
        cpu_seconds_ += result.cpu_seconds;
        trial.sweep.take(trial.goal, result);
        if (options_.tell)
            options_.tell("equal accuracy, " + trial.sweep.entry().title);
        begin_more();
    }

    std::deque<Sweep>& sweeps_;
    const MeshingTask& task_;
    const ReferenceSurface& reference_;
    const CompetitionOptions& options_;
    ProcessPool pool_;
    double cpu_seconds_ = 0.0; //!< of the trials that are done
    std::size_t running_ = 0;
};

//! Refinement that did not begin at a surface does not find it with finer criteria.
bool has_lost_more(const ContestantOutcome& outcome, const ContestantOutcome& reference)
{
    const auto meshed = [](const ContestantOutcome& one)
    { return one.report.at("surfaces").at("meshed").get<std::size_t>(); };
    return outcome.entry.knob == Knob::kCriteria && meshed(outcome) < meshed(reference);
}

const ContestantOutcome* find_done(const std::vector<ContestantOutcome>& outcomes, const std::string& name)
{
    for (const ContestantOutcome& outcome : outcomes)
        if (outcome.entry.name == name && outcome.done())
            return &outcome;
    return nullptr;
}

} // namespace

nlohmann::ordered_json equal_accuracy(const std::vector<ContestantOutcome>& outcomes, const MeshingTask& task,
                                      const ReferenceSurface& reference, const CompetitionOptions& options)
{
    const ContestantOutcome* marching_cubes = find_done(outcomes, kReference);
    if (marching_cubes == nullptr)
        return nullptr;
    const Trial goal = trial_of(1.0, marching_cubes->report);
    const ContestantOutcome* ours = find_done(outcomes, kOurs);
    const MeshingTask aimed = ours != nullptr ? with_targets(task, ours->report) : task;

    std::deque<Sweep> sweeps; // referred to while it grows
    for (const ContestantOutcome& outcome : outcomes)
    {
        if (!outcome.done() || outcome.entry.knob == Knob::kNone)
            continue;
        Sweep& sweep = sweeps.emplace_back(outcome, goal);
        if (has_lost_more(outcome, *marching_cubes))
            sweep.stop(
                "it has fewer surfaces than marching cubes, and finer criteria do not bring them back");
    }
    SweepRun(sweeps, aimed, reference, options).run();

    Json contestants = Json::array();
    for (const Sweep& sweep : sweeps)
        contestants.push_back(sweep.report());
    return {{"reference",
             {{"name", kReference}, {"vertices", goal.vertices}, {"max_mm", goal.max}, {"rms_mm", goal.rms}}},
            {"contestants", contestants}};
}

} // namespace voroprobe
