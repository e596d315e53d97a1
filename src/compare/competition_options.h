#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "compare/reference_surface.h"

namespace voroprobe
{

//! How contestants are run and looked at.
struct CompetitionOptions
{
    MeasuringOptions measuring;
    double contestant_seconds = 120.0; //!< wall clock, measuring included: after that a contestant has failed
    double sweep_seconds =
        16.0; //!< processor time of equal_accuracy(): once that is used no more trials are begun; 0: none are
    std::size_t at_once = 1;           //!< processes; each uses one thread
    std::size_t faces_shown = 2400000; //!< in all views together; larger meshes are decimated for them
    bool pictures = true;              //!< draws each mesh; needs a display, see VirtualDisplay
    std::function<void(const std::string&)> tell = {}; //!< what has just been done, for a line of progress
};

} // namespace voroprobe
