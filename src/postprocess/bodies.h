#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "certificate/mesh_pieces.h"
#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! What is solid in one piece: a surface that winds outward, and the cavities right inside of it.
struct Body
{
    std::uint32_t shell;                 //!< number of the piece of the mesh
    std::vector<std::uint32_t> cavities; //!< likewise
    double volume = 0.0;                 //!< cubic scan units, the cavities taken off
};

//! The bodies of a mesh, in the order of their shells. A piece that winds inward belongs to the smallest
//! shell around it; where there is none, it is a body of its own, of negative volume. \pre `pieces` are those
//! of the mesh. Cost: per cavity that of the faces of the shells whose boxes hold its box.
std::vector<Body> find_bodies(const TriangleMesh& mesh, const MeshPieces& pieces);

//! Which bodies to keep.
struct BodySelection
{
    std::optional<double> min_volume = std::nullopt;        //!< cubic scan units
    std::optional<std::size_t> keep_largest = std::nullopt; //!< of those that are left
    bool drop_cavities = false;

    [[nodiscard]] bool keeps_all() const { return !min_volume && !keep_largest && !drop_cavities; }
};

//! The bodies as meshes of their own, the one with the largest volume first where `largest_first`.
struct SelectedBodies
{
    std::vector<TriangleMesh> bodies;
    std::size_t bodies_dropped = 0;
    std::size_t cavities_dropped = 0;
    double volume_dropped = 0.0; //!< of bodies; filled cavities add to what is kept
};
SelectedBodies select_bodies(const TriangleMesh& mesh, const BodySelection& selection, bool largest_first);

} // namespace voroprobe
