#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/contestant.h"
#include "compare/reference_surface.h"

namespace voroprobe::bench
{

enum class Kind
{
    kMesher, //!< what it makes is measured
    kStep    //!< a piece of work that meshers are held against: its time alone counts
};

//! A contestant by name.
struct Entry
{
    std::string name;
    Kind kind;
    std::size_t threads; //!< that it may use
    std::function<std::unique_ptr<Contestant>(const MeshingTask&)> make;
};

//! Names that the targets are told by.
inline constexpr const char* kOurs = "voroprobe";
inline constexpr const char* kOursOnTwo = "voroprobe_2";
inline constexpr const char* kRefinement = "refinement";
inline constexpr const char* kRefinementOnTwo = "refinement_2";
inline constexpr const char* kSurfaceMesher = "surface_mesher";
inline constexpr const char* kMesh3 = "mesh_3";
inline constexpr const char* kMesh3Scan = "mesh_3_scan";
inline constexpr const char* kMesh3OnTwo = "mesh_3_parallel_2";
inline constexpr const char* kMesh3ScanOnTwo = "mesh_3_parallel_scan_2";
inline constexpr const char* kInventory = "inventory";
inline constexpr const char* kCertificate = "certificate";
inline constexpr const char* kBulkInsertion = "bulk_insertion";
inline constexpr const char* kCommand = "file_to_stl";
inline constexpr const char* kDecimatedFile = "file_to_stl_decimated";
inline constexpr const char* kRemeshedFile = "file_to_stl_remeshed";

//! Ours first. `volume`: the file that the volume was read from; contestants that begin with a file are left
//! out where there is none. The reference must outlive them.
std::vector<Entry> all_contestants(const ReferenceSurface& reference,
                                   const std::optional<std::filesystem::path>& volume);

} // namespace voroprobe::bench
