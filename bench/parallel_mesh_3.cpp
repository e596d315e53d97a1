// The only file compiled with CGAL_LINKED_WITH_TBB: CGAL's sequential classes are others with it.
#include "bench/parallel_mesh_3.h"

#include "compare/mesh_3_contestant.h"

namespace voroprobe::bench
{

std::unique_ptr<Contestant> make_parallel_mesh_3(const MeshingTask& task, Mesh3Seeding seeding)
{
    return std::make_unique<Mesh3<CGAL::Parallel_tag>>(task, seeding);
}

} // namespace voroprobe::bench
