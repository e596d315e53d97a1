#include "io/mesh_writer.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <string_view>

#include "io/atomic_file.h"
#include "io/float_rounding.h"
#include "io/mesh_3mf.h"
#include "io/mesh_openmesh.h"
#include "io/mesh_vtk.h"
#include "mesh/vertex_normals.h"
#include "support/error.h"
#include "support/text.h"

namespace voroprobe
{

namespace fs = std::filesystem;

namespace
{

struct NamedFormat
{
    std::string_view name;
    std::string_view extension; //!< empty: by name only
    MeshFormat format;
};

constexpr std::array<NamedFormat, 7> kFormats{{{"stl", ".stl", MeshFormat::kStlBinary},
                                               {"stl-ascii", "", MeshFormat::kStlAscii},
                                               {"ply", ".ply", MeshFormat::kPly},
                                               {"obj", ".obj", MeshFormat::kObj},
                                               {"off", ".off", MeshFormat::kOff},
                                               {"vtp", ".vtp", MeshFormat::kVtp},
                                               {"3mf", ".3mf", MeshFormat::k3mf}}};

//! "stl, stl-ascii, ply, ..." or ".stl, .ply, ...".
std::string list_of(std::string_view NamedFormat::*field)
{
    std::string list;
    for (const NamedFormat& format : kFormats)
        if (!(format.*field).empty())
            list += (list.empty() ? "" : ", ") + std::string(format.*field);
    return list;
}

const NamedFormat* find_format(std::string_view NamedFormat::*field, const std::string& value)
{
    const auto* found = std::find_if(kFormats.begin(), kFormats.end(),
                                     [&](const NamedFormat& format) { return format.*field == value; });
    return found == kFormats.end() || value.empty() ? nullptr : found;
}

[[noreturn]] void fail(const fs::path& path, const std::string& reason)
{
    throw OutputError("cannot write '" + path.string() + "': " + reason);
}

void check_mesh(const TriangleMesh& mesh, const fs::path& path)
{
    if (mesh.vertices.size() > std::numeric_limits<std::int32_t>::max() ||
        mesh.faces.size() > std::numeric_limits<std::int32_t>::max())
        fail(path, "the mesh has " + std::to_string(mesh.vertices.size()) + " vertices and " +
                       std::to_string(mesh.faces.size()) +
                       " faces; at most 2147483647 of each can be written");
    if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                     [](const Point3& p) { return is_finite(p); }))
        fail(path, "the mesh has a vertex with a coordinate that is not a finite number");
    for (const TriangleMesh::Face& face : mesh.faces)
        if (*std::max_element(face.begin(), face.end()) >= mesh.vertices.size())
            fail(path, "the mesh has a face that names a vertex that does not exist");
}

//! Rounds the mesh where the format asks for it and writes it.
WriteReport write_to_stream(const TriangleMesh& mesh, std::ostream& out, MeshFormat format,
                            const std::vector<std::string>& comments, VertexNormals wanted)
{
    const std::vector<Vec3> normals =
        wanted == VertexNormals::kWritten ? vertex_normals(mesh) : std::vector<Vec3>{};
    if (format == MeshFormat::kVtp)
    {
        write_vtp(mesh, normals, out, comments);
        return {};
    }
    const FloatRounding rounding = round_to_float(mesh);
    write_with_openmesh(rounding.mesh, normals, out, format, comments);
    return {.vertices_nudged = rounding.vertices_nudged};
}

} // namespace

MeshFormat mesh_format(const fs::path& path, const std::optional<std::string>& name)
{
    if (name)
    {
        if (const NamedFormat* format = find_format(&NamedFormat::name, lower_case(*name)))
            return format->format;
        throw UsageError("unknown mesh format '" + *name + "'; known: " + list_of(&NamedFormat::name));
    }
    const std::string extension = path.extension().string();
    if (const NamedFormat* format = find_format(&NamedFormat::extension, lower_case(extension)))
        return format->format;
    throw UsageError("cannot tell the mesh format of '" + path.string() + "' by its extension '" + extension +
                     "'; known: " + list_of(&NamedFormat::extension) + "; or name one of the formats " +
                     list_of(&NamedFormat::name));
}

bool holds_normals(MeshFormat format)
{
    return format == MeshFormat::kPly || format == MeshFormat::kObj || format == MeshFormat::kVtp;
}

void check_writable(const fs::path& path)
{
    if (path == "-")
        throw UsageError("'-' is no name of a file; allowed: a file, or /dev/stdout with --format");
    const AtomicFile trial(path); // leaves again without a trace
}

WriteReport write_mesh(const TriangleMesh& mesh, const fs::path& path, MeshFormat format,
                       const std::vector<std::string>& comments, const std::function<void()>& last_look,
                       VertexNormals normals)
{
    if (normals == VertexNormals::kWritten && !holds_normals(format))
        throw UsageError("'" + path.string() + "' has no room for normals; allowed: .ply, .obj, .vtp");
    if (format == MeshFormat::k3mf)
        return write_parts(std::vector<MeshPart>{{.name = "", .mesh = mesh}}, path, comments, last_look);
    check_mesh(mesh, path);
    WriteReport report;
    write_atomically(path, last_look,
                     [&](std::ostream& out)
                     { report = write_to_stream(mesh, out, format, comments, normals); });
    return report;
}

WriteReport write_parts(std::span<const MeshPart> parts, const fs::path& path,
                        const std::vector<std::string>& comments, const std::function<void()>& last_look)
{
    WriteReport report;
    std::vector<MeshPart> stored;
    for (const MeshPart& part : parts)
    {
        check_mesh(part.mesh, path);
        FloatRounding rounding = round_to_float(part.mesh, kNumbersOf3mf);
        report.vertices_nudged += rounding.vertices_nudged;
        stored.push_back({.name = part.name, .color = part.color, .mesh = std::move(rounding.mesh)});
    }
    write_atomically(path, last_look, [&](std::ostream& out) { write_3mf(stored, out, comments); });
    return report;
}

} // namespace voroprobe
