#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

#include "mesh/triangle_mesh.h"

//! Small meshes with known topology and measures, for tests.
namespace voroprobe::sample
{

//! Adds the pieces of `other`, moved by `offset`. A mesh may be added to itself.
inline void append(TriangleMesh& mesh, const TriangleMesh& other, const Vec3& offset = {})
{
    const std::size_t vertex_count = mesh.vertices.size();
    const std::size_t face_count = mesh.faces.size();
    const auto first = static_cast<std::uint32_t>(vertex_count);
    const std::size_t added_vertices = other.vertices.size();
    const std::size_t added_faces = other.faces.size();
    mesh.vertices.resize(vertex_count + added_vertices);
    mesh.faces.resize(face_count + added_faces);
    for (std::size_t v = 0; v < added_vertices; ++v)
        mesh.vertices[vertex_count + v] = other.vertices[v] + offset;
    for (std::size_t f = 0; f < added_faces; ++f)
        for (std::size_t i = 0; i < 3; ++i)
            mesh.faces[face_count + f][i] = first + other.faces[f][i];
}

//! Corner of the unit cube, edges along the axes: volume 1/6, faces outward.
inline TriangleMesh tetrahedron()
{
    return {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
            .faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

inline TriangleMesh icosahedron()
{
    const double g = std::numbers::phi;
    return {.vertices = {{-1, g, 0},
                         {1, g, 0},
                         {-1, -g, 0},
                         {1, -g, 0},
                         {0, -1, g},
                         {0, 1, g},
                         {0, -1, -g},
                         {0, 1, -g},
                         {g, 0, -1},
                         {g, 0, 1},
                         {-g, 0, -1},
                         {-g, 0, 1}},
            .faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

//! Sphere about the origin: an icosahedron whose faces are cut into four `levels` times; 20 * 4^levels faces.
inline TriangleMesh icosphere(int levels, double radius = 1.0)
{
    TriangleMesh mesh = icosahedron();
    for (int level = 0; level < levels; ++level)
    {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b)
        {
            const auto [entry, is_new] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.vertices.size()));
            if (is_new)
                mesh.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
            return entry->second;
        };
        std::vector<TriangleMesh::Face> finer;
        for (const auto& [a, b, c] : mesh.faces)
        {
            const std::uint32_t ab = middle(a, b);
            const std::uint32_t bc = middle(b, c);
            const std::uint32_t ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        mesh.faces = std::move(finer);
    }
    for (Point3& p : mesh.vertices)
        p = radius * normalized(p);
    return mesh;
}

//! Torus about the z axis, `around` times `across` quadrilaterals, two faces each; closed, Euler
//! characteristic 0.
inline TriangleMesh torus(std::uint32_t around, std::uint32_t across, double major = 3.0, double minor = 1.0)
{
    TriangleMesh mesh;
    const auto id = [&](std::uint32_t i, std::uint32_t j) { return (i % around) * across + j % across; };
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t j = 0; j < across; ++j)
        {
            const double u = 2.0 * std::numbers::pi * i / around;
            const double v = 2.0 * std::numbers::pi * j / across;
            const double r = major + minor * std::cos(v);
            mesh.vertices.push_back({r * std::cos(u), r * std::sin(u), minor * std::sin(v)});
            mesh.faces.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
            mesh.faces.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
        }
    return mesh;
}

} // namespace voroprobe::sample
