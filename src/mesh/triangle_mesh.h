#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/affine_transform.h"
#include "geometry/box3.h"
#include "geometry/vec3.h"

namespace voroprobe
{

//! Triangles over shared vertices. Seen from outside the object the vertices of a face run counter-clockwise.
struct TriangleMesh
{
    using Face = std::array<std::uint32_t, 3>;

    std::vector<Point3> vertices; //!< scan units; the frame is told by whoever made the mesh
    std::vector<Face> faces;

    [[nodiscard]] Point3 corner(const Face& face, std::size_t i) const { return vertices[face[i]]; }
};

Box3 bounding_box(const TriangleMesh& mesh);

//! The faces whose place in `kept` is true, in their order, and the vertices they use. \pre one for each
//! face.
TriangleMesh with_faces(const TriangleMesh& mesh, const std::vector<bool>& kept);

//! Moves every vertex; where the transform reverses orientation the faces are turned over, so that they keep
//! facing outward.
void transform(TriangleMesh& mesh, const AffineTransform& to_from_mesh);

} // namespace voroprobe
