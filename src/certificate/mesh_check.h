#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "certificate/mesh_pieces.h"
#include "certificate/object_overlaps.h"
#include "certificate/self_intersections.h"
#include "mesh/measures.h"
#include "mesh/mesh_part.h"
#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Angles below which faces are counted whatever was asked for, degrees.
inline constexpr std::array<double, 3> kShownAnglesDeg{10.0, 20.0, 30.0};

//! Everything that can be said of a mesh without knowing what it is a mesh of.
struct MeshCheck
{
    std::size_t vertices = 0;
    std::size_t faces = 0;
    MeshTopology topology;
    std::vector<MeshPiece> pieces;
    std::vector<FacePair> self_intersections;   //!< ascending; two faces of one object
    std::vector<ObjectOverlap> object_overlaps; //!< ascending; no defect
    std::size_t flat_faces = 0;                 //!< without area, those that name a vertex twice included
    std::size_t duplicate_faces = 0;            //!< over the same vertices as an earlier face
    AngleMeasures angles;
    std::array<std::size_t, kShownAnglesDeg.size()> faces_below_shown_angle{};
    std::optional<std::size_t> faces_below_angle_bound = std::nullopt; //!< where a bound was given
    double area = 0.0;                                                 //!< squared scan units
    double enclosed_volume = 0.0; //!< cubic scan units; of no meaning where the mesh is not closed
    Box3 box;
};

//! \pre faces name existing vertices, coordinates are finite, equal points are one vertex (see weld). Cost:
//! that of self_intersections(), plus close to linear passes.
MeshCheck check_mesh(const TriangleMesh& mesh, std::optional<double> angle_bound_deg = std::nullopt);

//! The same for objects side by side: faces of different objects may cross, which is told by itself.
MeshCheck check_objects(std::span<const MeshPart> objects,
                        std::optional<double> angle_bound_deg = std::nullopt);

//! What keeps the mesh from being closed, manifold, oriented and free of self-intersections, in one line;
//! nullopt where nothing does.
std::optional<std::string> defects(const MeshCheck& check);

} // namespace voroprobe
