#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

enum class MeshFormat
{
    kStlBinary,
    kStlAscii,
    kPly,
    kObj,
    kOff,
    kVtp
};

//! Format by name ("stl", "stl-ascii", "ply", "obj", "off", "vtp") or, where that is unset, by the extension
//! of `path`. \throw UsageError that lists the known ones.
MeshFormat mesh_format(const std::filesystem::path& path,
                       const std::optional<std::string>& name = std::nullopt);

//! Tells before any work is done whether `path` could be written: its folder exists and takes a file of ours.
//! \throw OutputError with the reason.
void check_writable(const std::filesystem::path& path);

//! What had to be done to a mesh so that a format of 32-bit floats keeps its promises.
struct WriteReport
{
    std::size_t vertices_nudged =
        0; //!< moved by a few units in the last place, so that no two coincide and no face folds
};

//! Writes to a temporary name beside `path` and renames: the target is either whole or untouched. Comments go
//! where the format has room for them. \pre the mesh is closed and manifold where the reader is meant to find
//! it so. \throw OutputError with the reason.
WriteReport write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path, MeshFormat format,
                       const std::vector<std::string>& comments = {});

} // namespace voroprobe
