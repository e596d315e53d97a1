#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "compare/reference_surface.h"
#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! A mesh as the page shows it: whole where it is small, else decimated, with what is known of the faces of
//! the whole mesh carried over to the nearest face shown.
struct ViewMesh
{
    TriangleMesh mesh;                       //!< world, mm
    std::vector<double> smallest_angles_deg; //!< by face
    std::vector<double> distances;           //!< by face: from its centroid to the scan's surface, mm
    std::vector<std::uint32_t> pieces;       //!< by face: which piece of the whole mesh it belongs to
    std::size_t faces_of_whole = 0;

    [[nodiscard]] bool decimated() const { return mesh.faces.size() != faces_of_whole; }
};

//! `mesh`: grid frame. Pieces of few faces are kept as they are. Cost: up to two segment queries for each
//! face shown and, where there are more than `most_faces`, VTK's quadric decimation. Deterministic.
ViewMesh make_view_mesh(const TriangleMesh& mesh, const ReferenceSurface& reference, std::size_t most_faces);

//! Distances that the packed form tells apart reach to so many voxels.
constexpr double kLongestDistanceInVoxels = 1.0;

//! Bytes as text, padded (RFC 4648).
std::string base64(std::string_view bytes);

//! Packed for the page: places rounded to 1/65535 of the mesh's box, angles to a quarter of a degree,
//! distances to 1/255 of `longest_distance` (mm), faces in an order of their own; deflated (zlib), then
//! base64. report/src/mesh.js reads it.
std::string pack(const ViewMesh& view, double longest_distance);

} // namespace voroprobe
