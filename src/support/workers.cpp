#include "support/workers.h"

#include <algorithm>

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

namespace voroprobe
{

struct Workers::Arena
{
    explicit Arena(int threads) : arena(threads) {}
    tbb::task_arena arena;
};

Workers::Workers(std::size_t threads)
{
    // More than there are would only make TBB complain.
    const auto available = static_cast<std::size_t>(tbb::info::default_concurrency());
    const std::size_t used = threads == 0 ? available : std::min(threads, available);
    if (used > 1)
        arena_ = std::make_unique<Arena>(static_cast<int>(used));
}

Workers::~Workers() = default;

void Workers::for_each(std::size_t count, const std::function<void(std::size_t i)>& work,
                       std::size_t at_once) const
{
    const auto work_on = [&](const tbb::blocked_range<std::size_t>& range)
    {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
            work(i);
    };
    const tbb::blocked_range<std::size_t> all(0, count, at_once);
    if (!arena_ || count <= at_once)
        return work_on(all);
    arena_->arena.execute([&] { tbb::parallel_for(all, work_on, tbb::simple_partitioner()); });
}

} // namespace voroprobe
