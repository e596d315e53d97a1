#include "compare/mesh_3_contestant.h"

namespace voroprobe
{

std::unique_ptr<Contestant> make_mesh_3(const MeshingTask& task, Mesh3Seeding seeding)
{
    return std::make_unique<Mesh3<CGAL::Sequential_tag>>(task, seeding);
}

} // namespace voroprobe
