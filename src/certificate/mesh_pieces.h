#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/edge_table.h"
#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Faces connected through shared edges. Faces that name a vertex twice add area 0, no edge and nothing to
//! the Euler characteristic.
struct MeshPiece
{
    std::size_t faces = 0;
    long euler_characteristic = 0;  //!< vertices - edges + faces; 2 - 2 genus where closed and manifold
    std::size_t boundary_edges = 0; //!< on one face
    std::size_t crowded_edges = 0;  //!< on three or more faces
    double area = 0.0;              //!< squared scan units
    double enclosed_volume =
        0.0; //!< cubic scan units; negative where the faces wind inward, as around cavities
    Box3 box;

    [[nodiscard]] bool closed() const { return boundary_edges == 0; }

    //! Holes through it, the handles of a cup. \pre closed and manifold.
    [[nodiscard]] long genus() const { return (2 - euler_characteristic) / 2; }
};

struct MeshPieces
{
    std::vector<MeshPiece> pieces;
    std::vector<std::uint32_t> piece_of_face; //!< numbered by their first faces
};

//! \pre faces name existing vertices. Cost: close to linear.
MeshPieces split_into_pieces(const TriangleMesh& mesh);

//! The same where there are the edges of the mesh.
MeshPieces split_into_pieces(const TriangleMesh& mesh, const EdgeTable& edges);

} // namespace voroprobe
