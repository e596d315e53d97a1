#pragma once

#include <memory>

#include "support/progress.h"

namespace voroprobe
{

//! How a run tells of its progress on stderr. In every mode it can be stopped: stop_requested() follows
//! interrupt_requested().
enum class ProgressMode
{
    kAuto, //!< a bar where stderr is a terminal, nothing otherwise
    kBar,  //!< one line, redrawn: share of the known work done, phase, vertices, bad facets left, rate
    kJson, //!< one JSON object a line: phase, vertices, bad_facets_left, vertices_per_second, seconds
    kNone
};

//! Draws or prints at most ten times a second, and at the first report of every phase. The bar is wiped when
//! the sink is destroyed.
std::unique_ptr<ProgressSink> make_progress(ProgressMode mode);

} // namespace voroprobe
