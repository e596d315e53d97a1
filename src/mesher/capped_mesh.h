#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "mesher/cap_finder.h"
#include "mesher/surface_extraction.h"

namespace voroprobe
{

//! Of what a vertex is.
enum class SurfacePart : std::uint8_t
{
    kCap,   //!< the border of the domain, in the object
    kRim,   //!< where the surface meets the border
    kProper //!< the surface itself
};

//! A mesh of a surface and its caps, on its way to one without them.
struct CappedMesh
{
    TriangleMesh mesh;
    std::vector<SurfaceId> surface_of_face;
    std::vector<SurfacePart> part; //!< by vertex
    std::vector<Point3>
        place_on_it; //!< by vertex: its place on the closed mesh, which crosses itself nowhere

    //! Appends a vertex at `at`, that has a place on the closed mesh; its number.
    std::uint32_t add_vertex(const Point3& at, const Point3& place_on_closed_mesh, SurfacePart of);
};

//! Tells the vertices of caps from those of the surface itself. Faces with corners of one kind over a middle
//! of the other get a vertex there. Afterwards no vertex is of the rim yet. Cost: a query for each vertex,
//! and for each face near the border.
CappedMesh with_parts(const Box3& domain, CapFinder& caps, ExtractedSurface surface);

//! The crossing nearest to the middle of a face on the line at right angles to it, within its longest side.
std::optional<Crossing> crossing_across(const TriangleMesh& mesh, const TriangleMesh::Face& face,
                                        CapFinder& caps);

} // namespace voroprobe
