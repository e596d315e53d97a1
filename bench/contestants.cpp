#include "bench/contestants.h"

#include "bench/file_to_stl.h"
#include "bench/parallel_mesh_3.h"
#include "bench/steps.h"

namespace voroprobe::bench
{

namespace
{

std::vector<Entry> meshers()
{
    const auto surface_mesher = [](const MeshingTask& task)
    { return make_surface_mesher(task, FirstPoints::kSeeded); };
    const auto mesh_3 = [](const MeshingTask& task) { return make_mesh_3(task, Mesh3Seeding::kDefault); };
    const auto mesh_3_scan = [](const MeshingTask& task) { return make_mesh_3(task, Mesh3Seeding::kScan); };
    const auto parallel = [](const MeshingTask& task)
    { return make_parallel_mesh_3(task, Mesh3Seeding::kDefault); };
    const auto parallel_scan = [](const MeshingTask& task)
    { return make_parallel_mesh_3(task, Mesh3Seeding::kScan); };
    return {
        {kOurs, Kind::kMesher, 1, make_voroprobe},
        {kOursOnTwo, Kind::kMesher, 2, make_voroprobe},
        {kRefinement, Kind::kMesher, 1, make_voroprobe_refinement},
        {kRefinementOnTwo, Kind::kMesher, 2, make_voroprobe_refinement},
        {kSurfaceMesher, Kind::kMesher, 1, surface_mesher},
        {kMesh3, Kind::kMesher, 1, mesh_3},
        {kMesh3Scan, Kind::kMesher, 1, mesh_3_scan},
        {kMesh3OnTwo, Kind::kMesher, 2, parallel},
        {kMesh3ScanOnTwo, Kind::kMesher, 2, parallel_scan},
        {"flying_edges", Kind::kMesher, 1, make_marching_cubes},
        {"decimated", Kind::kMesher, 1, make_decimated},
        {"remeshed", Kind::kMesher, 1, make_remeshed},
        {"openvdb", Kind::kMesher, 1, make_openvdb},
    };
}

std::vector<Entry> steps(const ReferenceSurface& reference)
{
    const auto certificate = [&reference](const MeshingTask& task)
    { return make_certificate(task, reference); };
    const auto bulk_insertion = [&reference](const MeshingTask& task)
    { return make_bulk_insertion(task, reference); };
    return {{kInventory, Kind::kStep, 1, make_inventory},
            {kCertificate, Kind::kStep, 1, certificate},
            {kBulkInsertion, Kind::kStep, 1, bulk_insertion}};
}

std::vector<Entry> whole_commands(const std::filesystem::path& volume)
{
    const auto ours = [volume](const MeshingTask& task) { return make_command(task, volume); };
    const auto decimated = [volume](const MeshingTask& task)
    { return make_file_to_stl(task, volume, make_decimated); };
    const auto remeshed = [volume](const MeshingTask& task)
    { return make_file_to_stl(task, volume, make_remeshed); };
    return {{kCommand, Kind::kStep, 1, ours},
            {kDecimatedFile, Kind::kStep, 1, decimated},
            {kRemeshedFile, Kind::kStep, 1, remeshed}};
}

} // namespace

std::vector<Entry> all_contestants(const ReferenceSurface& reference,
                                   const std::optional<std::filesystem::path>& volume)
{
    std::vector<Entry> all = meshers();
    for (Entry& entry : steps(reference))
        all.push_back(std::move(entry));
    if (volume)
        for (Entry& entry : whole_commands(*volume))
            all.push_back(std::move(entry));
    return all;
}

} // namespace voroprobe::bench
