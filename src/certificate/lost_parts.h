#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! A part of a surface of the scan that its mesh does not come to.
struct LostPart
{
    SurfaceId surface;
    std::size_t points;          //!< of those spread over the surface, that are there
    std::size_t points_of_hairs; //!< of these, where the object, or the gap in it, is thin
    Point3 place;                //!< one of them, where it is not thin if there is one

    //! Most of it is: all but its tips, which are thin along no axis.
    [[nodiscard]] bool is_hair() const { return 2 * points_of_hairs >= points; }
};

//! The parts of the surfaces of a scan that are farther from every vertex of their meshes than the longest
//! side of a face and `reach` together, one entry for each surface. However coarse a mesh is, each of its
//! points is within the longest side of a vertex.
//! `surface_of_face`: kNoSurface for faces that count for none. Caps and surfaces without faces are passed
//! over; none where the oracle has no inventory. A hair is thinner than two `floor_radius` along one of the
//! axes. Frame: the oracle's; lengths in scan units, > 0. Cost: that of cover().
std::vector<LostPart> find_lost_parts(const TriangleMesh& mesh, std::span<const SurfaceId> surface_of_face,
                                      const SurfaceOracle& oracle, double reach, double floor_radius);

} // namespace voroprobe
