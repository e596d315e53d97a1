#include "io/mesh_reader.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "io/mesh_text_reader.h"
#include "io/mesh_vtk.h"
#include "mesh/topology.h"
#include "support/error.h"

namespace voroprobe
{

namespace fs = std::filesystem;

namespace
{

[[noreturn]] void fail(const fs::path& path, const std::string& reason)
{
    throw InputError("cannot read '" + path.string() + "': " + reason);
}

void check_file(const fs::path& path)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
        fail(path, "there is no such file");
    if (!fs::is_regular_file(status))
        fail(path, "it is not a file");
    if (fs::file_size(path, error) == 0)
        fail(path, "the file is empty");
}

std::string lower_case_extension(const fs::path& path)
{
    std::string text = path.extension().string();
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

TriangleMesh read_as_stored(const fs::path& path)
{
    const std::string extension = lower_case_extension(path);
    if (extension == ".stl")
        return read_with_vtk(path, VtkMeshFormat::kStl);
    if (extension == ".ply")
        return read_with_vtk(path, VtkMeshFormat::kPly);
    if (extension == ".vtp")
        return read_with_vtk(path, VtkMeshFormat::kVtp);
    if (extension == ".obj")
        return read_obj(path);
    if (extension == ".off")
        return read_off(path);
    fail(path, "unknown extension '" + extension + "'; known: .stl, .ply, .obj, .off, .vtp");
}

void check_mesh(const TriangleMesh& mesh, const fs::path& path)
{
    if (mesh.faces.empty())
        fail(path, "it holds no faces");
    if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                     [](const Point3& p) { return is_finite(p); }))
        fail(path, "it holds a vertex with a coordinate that is not a finite number");
}

} // namespace

TriangleMesh read_mesh(const fs::path& path)
{
    check_file(path);
    const TriangleMesh mesh = read_as_stored(path);
    check_mesh(mesh, path);
    return weld(mesh);
}

} // namespace voroprobe
