#include "io/mesh_reader.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include "io/mesh_3mf.h"
#include "io/mesh_file.h"
#include "io/mesh_ply_reader.h"
#include "io/mesh_text_reader.h"
#include "io/mesh_vtk.h"
#include "mesh/topology.h"
#include "support/text.h"

namespace voroprobe
{

namespace fs = std::filesystem;

namespace
{

void check_file(const fs::path& path)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
        fail_reading(path, "there is no such file");
    if (!fs::is_regular_file(status))
        fail_reading(path, "it is not a file");
    if (fs::file_size(path, error) == 0)
        fail_reading(path, "the file is empty");
    if (!std::ifstream(path, std::ios::binary))
        fail_reading(path, std::strerror(errno));
}

TriangleMesh read_as_stored(const fs::path& path)
{
    const std::string extension = lower_case(path.extension().string());
    if (extension == ".stl")
        return read_stl(path);
    if (extension == ".ply")
        return read_ply(path);
    if (extension == ".vtp")
        return read_vtp(path);
    if (extension == ".obj")
        return read_obj(path);
    if (extension == ".off")
        return read_off(path);
    fail_reading(path, "unknown extension '" + extension + "'; known: .stl, .ply, .obj, .off, .vtp, .3mf");
}

void check_mesh(const TriangleMesh& mesh, const fs::path& path)
{
    if (mesh.faces.empty())
        fail_reading(path, "it holds no faces");
    if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                     [](const Point3& p) { return is_finite(p); }))
        fail_reading(path, "it holds a vertex with a coordinate that is not a finite number");
    for (const TriangleMesh::Face& face : mesh.faces)
        if (*std::max_element(face.begin(), face.end()) >= mesh.vertices.size())
            fail_reading(path, "a face names a vertex that is not in the file");
}

} // namespace

std::vector<MeshPart> read_parts(const fs::path& path)
{
    check_file(path);
    std::vector<MeshPart> parts;
    if (lower_case(path.extension().string()) == ".3mf")
        parts = read_3mf(path);
    else
        parts.push_back({.name = "", .mesh = read_as_stored(path)});
    for (MeshPart& part : parts)
    {
        check_mesh(part.mesh, path);
        part.mesh = weld(part.mesh);
    }
    return parts;
}

TriangleMesh read_mesh(const fs::path& path)
{
    return merged(read_parts(path));
}

} // namespace voroprobe
