#pragma once

#include <cstddef>
#include <vector>

#include "bench/standings.h"

namespace voroprobe::bench
{

//! One checked run each, ours first: it tells the others how many vertices, and how long edges, to aim at.
//! Then the timed ones in turn: A B C A B C. One that crashes has failed, and the others go on. \pre `ours`
//! is make_voroprobe's, whether it takes part or not. \throw Error where ours is not closed, manifold and
//! oriented, or not the same each time; InputError for an empty mesh.
std::vector<Standing> compete(const Entry& ours, const std::vector<Entry>& contestants, MeshingTask task,
                              const ReferenceSurface& reference, std::size_t repeat);

} // namespace voroprobe::bench
