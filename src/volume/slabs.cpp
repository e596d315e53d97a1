#include "volume/slabs.h"

#include <algorithm>

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace voroprobe
{
namespace
{

//! A slab also reads the slice after its last: thinner ones would read much twice.
constexpr std::size_t kThinnestSlab = 8;

//! Slabs per thread, so that none waits long for the last.
constexpr std::size_t kSlabsPerThread = 4;

} // namespace

void for_each_slab(std::size_t slices, std::size_t threads,
                   const std::function<void(std::size_t begin, std::size_t end)>& work)
{
    if (threads == 1)
        return work(0, slices);
    // More than there are would only make TBB complain.
    const int available = tbb::info::default_concurrency();
    tbb::task_arena arena(
        threads == 0 ? available : static_cast<int>(std::min(threads, static_cast<std::size_t>(available))));
    arena.execute(
        [&]
        {
            const auto workers = static_cast<std::size_t>(arena.max_concurrency());
            const std::size_t thickness = std::max(kThinnestSlab, slices / (kSlabsPerThread * workers));
            const std::size_t count = (slices + thickness - 1) / thickness;
            tbb::parallel_for(std::size_t{0}, count,
                              [&](std::size_t slab)
                              { work(slab * thickness, std::min(slices, (slab + 1) * thickness)); });
        });
}

} // namespace voroprobe
