#pragma once

#include <cstddef>
#include <string_view>

namespace voroprobe
{

//! What a long computation says of itself. Unknown or meaningless counts are zero.
struct ProgressReport
{
    std::string_view phase;          //!< "read", "refinement", "initialization", "probing", "write"
    std::size_t vertices = 0;        //!< vertices inserted so far
    std::size_t bad_facets_left = 0; //!< bad facets known and not yet refined
};

//! Receives progress and may ask to stop. Called about every thousand insertions, always from the thread that
//! started the computation; must be quick. The library itself prints nothing.
class ProgressSink
{
public:
    virtual ~ProgressSink() = default;

    //! Called at every change of phase and regularly in between.
    virtual void report(const ProgressReport& report) = 0;

    //! True once the user wants to stop; the computation returns within a second with a result flagged as
    //! interrupted.
    [[nodiscard]] virtual bool stop_requested() const = 0;
};

} // namespace voroprobe
