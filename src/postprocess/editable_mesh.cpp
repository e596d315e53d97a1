#include "postprocess/editable_mesh.h"

#include <algorithm>

#include "support/check.h"

namespace voroprobe
{

std::uint32_t next_corner(const TriangleMesh::Face& face, std::uint32_t vertex)
{
    return face[0] == vertex ? face[1] : face[1] == vertex ? face[2] : face[0];
}

std::uint32_t opposite_corner(const TriangleMesh::Face& face, std::uint32_t a, std::uint32_t b)
{
    for (const std::uint32_t corner : face)
        if (corner != a && corner != b)
            return corner;
    return a;
}

EditableMesh::EditableMesh(const TriangleMesh& mesh) : points_(mesh.vertices), faces_of_(mesh.vertices.size())
{
    for (const Face& face : mesh.faces)
        attach(face);
}

std::vector<std::uint32_t> EditableMesh::neighbours(std::uint32_t vertex) const
{
    std::vector<std::uint32_t> result;
    for (const std::uint32_t f : faces_of_[vertex])
        result.push_back(next_corner(faces_[f], vertex));
    std::sort(result.begin(), result.end());
    return result;
}

bool EditableMesh::are_neighbours(std::uint32_t a, std::uint32_t b) const
{
    return std::any_of(faces_of_[a].begin(), faces_of_[a].end(),
                       [&](std::uint32_t f)
                       { return std::find(faces_[f].begin(), faces_[f].end(), b) != faces_[f].end(); });
}

std::uint32_t EditableMesh::face_along(std::uint32_t a, std::uint32_t b) const
{
    for (const std::uint32_t f : faces_of_[a])
        if (next_corner(faces_[f], a) == b)
            return f;
    return static_cast<std::uint32_t>(faces_.size());
}

std::uint32_t EditableMesh::add_vertex(const Point3& p)
{
    points_.push_back(p);
    faces_of_.emplace_back();
    return static_cast<std::uint32_t>(points_.size() - 1);
}

void EditableMesh::replace(std::span<const std::uint32_t> removed, std::span<const Face> added)
{
    for (const std::uint32_t f : removed)
        detach(f);
    for (const Face& face : added)
        attach(face);
}

void EditableMesh::detach(std::uint32_t face)
{
    CHECK(alive_[face]);
    alive_[face] = false;
    for (const std::uint32_t v : faces_[face])
        std::erase(faces_of_[v], face);
}

void EditableMesh::attach(const Face& face)
{
    const auto number = static_cast<std::uint32_t>(faces_.size());
    faces_.push_back(face);
    alive_.push_back(true);
    for (const std::uint32_t v : face)
        faces_of_[v].push_back(number);
}

TriangleMesh EditableMesh::mesh() const
{
    return with_faces({points_, faces_}, alive_);
}

} // namespace voroprobe
