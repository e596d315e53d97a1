// The only file compiled with CGAL_LINKED_WITH_TBB: CGAL's sequential classes are others with it.
#include <tbb/global_control.h>

#include "bench/contestants.h"
#include "compare/mesh_3_contestant.h"

namespace voroprobe::bench
{
namespace
{

class ParallelMesh3 final : public Contestant
{
public:
    ParallelMesh3(const MeshingTask& task, Mesh3Seeding seeding)
        : threads_(task.threads), contestant_(task, seeding)
    {
    }

    void mesh(StageClock& clock) override
    {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads_);
        contestant_.mesh(clock);
    }

    [[nodiscard]] TriangleMesh result() const override { return contestant_.result(); }

private:
    std::size_t threads_;
    Mesh3<CGAL::Parallel_tag> contestant_;
};

} // namespace

std::unique_ptr<Contestant> make_parallel_mesh_3(const MeshingTask& task, Mesh3Seeding seeding)
{
    return std::make_unique<ParallelMesh3>(task, seeding);
}

} // namespace voroprobe::bench
