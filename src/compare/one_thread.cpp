#include "compare/one_thread.h"

#include <tbb/global_control.h>

namespace voroprobe
{

struct OneThread::Control
{
    tbb::global_control limit{tbb::global_control::max_allowed_parallelism, 1};
};

OneThread::OneThread() : control_(std::make_unique<Control>()) {}

OneThread::~OneThread() = default;

} // namespace voroprobe
