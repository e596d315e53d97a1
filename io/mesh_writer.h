#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mesh/mesh_part.h"
#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! All but VTP and 3MF store coordinates as 32-bit floats, the text formats with all digits of those: that is
//! what OpenMesh writes. VTP stores 64 bits, 3MF six digits behind the point of 22 bits.
enum class MeshFormat
{
    kStlBinary, //!< comments in the 80-byte header
    kStlAscii,  //!< comments as the name of the solid
    kPly,       //!< binary, little-endian; comment lines
    kObj,       //!< comment lines
    kOff,       //!< text; no comments, which many readers do not expect
    kVtp,       //!< VTK XML poly data, compressed; comments as a string array of the field data
    k3mf        //!< print jobs: objects with names and colours, always mm; comments as description
};

//! Format by name ("stl", "stl-ascii", "ply", "obj", "off", "vtp", "3mf") or, where that is unset, by the
//! extension of `path`. \throw UsageError that lists the known ones.
MeshFormat mesh_format(const std::filesystem::path& path,
                       const std::optional<std::string>& name = std::nullopt);

//! Whether a file is to have the normals of vertices, see mesh/vertex_normals.h.
enum class VertexNormals
{
    kLeftOut,
    kWritten //!< 32-bit floats, VTP 64 bits
};

//! Whether a format has room for them: PLY, OBJ and VTP do.
bool holds_normals(MeshFormat format);

//! Tells before any work is done whether `path` could be written: its folder exists and takes a file of ours.
//! \throw OutputError with the reason.
void check_writable(const std::filesystem::path& path);

//! What had to be done to a mesh so that a format of 32-bit floats keeps its promises, see float_rounding.h.
struct WriteReport
{
    //! Moved by a few units in the last place, so that no two coincide and no face folds.
    std::size_t vertices_nudged = 0;
};

//! Writes to a temporary name beside `path` and renames: the target is either whole or untouched. Comments go
//! where the format has room for them. Not for several threads at once: OpenMesh and VTK are silenced by
//! process-wide switches. \pre the mesh is closed and manifold where the reader is meant to find it so.
//! `last_look` is called when the file is whole and only the renaming is left; whatever it throws leaves the
//! target as it was. \throw OutputError with the reason; UsageError where the format does not hold the
//! normals that are asked for.
WriteReport write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path, MeshFormat format,
                       const std::vector<std::string>& comments = {},
                       const std::function<void()>& last_look = {},
                       VertexNormals normals = VertexNormals::kLeftOut);

//! The same for several objects beside one another, with names and colours, as 3MF: each is rounded for
//! itself, so that vertices which parts share stay where they are in both, but for those that are nudged.
//! \pre there is one at least.
WriteReport write_parts(std::span<const MeshPart> parts, const std::filesystem::path& path,
                        const std::vector<std::string>& comments = {},
                        const std::function<void()>& last_look = {});

} // namespace voroprobe
