#pragma once

#include <memory>

#include "compare/contestant.h"

namespace voroprobe::bench
{

//! CGAL 5.5 make_mesh_3 with Parallel_tag, on as many threads as the process may use.
std::unique_ptr<Contestant> make_parallel_mesh_3(const MeshingTask& task, Mesh3Seeding seeding);

} // namespace voroprobe::bench
