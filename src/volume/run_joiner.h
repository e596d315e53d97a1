#pragma once

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "volume/region_runs.h"

namespace voroprobe
{

//! Disjoint sets of runs, kept in the runs themselves: while they are joined, `region` holds the number of an
//! earlier run of the same set plus 1, or of the run itself, with the sign of the side. Each set is named by
//! its first run, whatever the order of the calls; several threads may join at once.
class RunJoiner
{
public:
    using RunNumber = std::int32_t;

    explicit RunJoiner(Run* runs) : runs_(runs) {}

    [[nodiscard]] static Region alone(RunNumber run, bool inside) { return inside ? run + 1 : -(run + 1); }
    [[nodiscard]] static RunNumber parent(Region stored) { return std::abs(stored) - 1; }

    [[nodiscard]] bool inside(RunNumber run) const { return is_inside(load(run)); }

    //! \pre Both are of one side.
    void join(RunNumber a, RunNumber b)
    {
        while (true)
        {
            a = find(a);
            b = find(b);
            if (a == b)
                return;
            if (a < b)
                std::swap(a, b);
            Region root = load(a);
            if (parent(root) != a)
                continue; // another thread was faster
            const Region joined = alone(b, is_inside(root));
            if (stored(a).compare_exchange_strong(root, joined, std::memory_order_relaxed))
                return;
        }
    }

private:
    [[nodiscard]] std::atomic_ref<Region> stored(RunNumber run) const
    {
        return std::atomic_ref<Region>(runs_[run].region);
    }
    [[nodiscard]] Region load(RunNumber run) const { return stored(run).load(std::memory_order_relaxed); }

    //! By path halving: what is written is an ancestor, whatever other threads do.
    RunNumber find(RunNumber run)
    {
        while (true)
        {
            const RunNumber up = parent(load(run));
            if (up == run)
                return run;
            const Region further = load(up);
            if (parent(further) == up)
                return up;
            stored(run).store(further, std::memory_order_relaxed);
            run = parent(further);
        }
    }

    Run* runs_;
};

} // namespace voroprobe
