#include "support/thread_limit.h"

#include <tbb/global_control.h>

namespace voroprobe
{

struct ThreadLimit::Control
{
    explicit Control(std::size_t threads) : control(tbb::global_control::max_allowed_parallelism, threads) {}
    tbb::global_control control;
};

ThreadLimit::ThreadLimit(std::size_t threads) : control_(std::make_unique<Control>(threads)) {}

ThreadLimit::~ThreadLimit() = default;

} // namespace voroprobe
