#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace voroprobe
{

//! Which isolated vertices are initialized before the next refinement (Feree & Alliez 2009, Sec. 5).
enum class IsolatedVertices
{
    kOneAtATime, //!< the complete version of the paper: fewest vertices
    kAllAtOnce   //!< fewer refinement rounds
};

//! What the mesh has to satisfy. Lengths in scan units.
struct MeshingOptions
{
    //! Largest surface Delaunay ball radius, > 0: bounds the edge lengths by twice this.
    double max_facet_radius;

    //! Largest distance between a facet's circumcenter and the center of its surface Delaunay ball, > 0.
    //! Unset: no distance criterion.
    std::optional<double> max_facet_distance = std::nullopt;

    //! Smallest accepted facet angle, degrees, in [0, 30]; above 30 refinement need not terminate
    //! (Boissonnat & Oudot 2005).
    double min_facet_angle_deg = 30.0;

    //! Facets whose surface Delaunay ball is no larger than this are not refined for the sake of topology, >
    //! 0. Ends the chase at the creases of the trilinear interpolant and at contacts of zero reach; a quarter
    //! of a voxel is sensible.
    double floor_radius;

    //! A strict lower bound of the surface's reach, > 0: sets the spacing of probes. Components closer or
    //! thinner may be missed.
    double reach_lower_bound;

    IsolatedVertices isolated_vertices = IsolatedVertices::kAllAtOnce;

    //! Keep the faces that close the object where it leaves the domain.
    bool close_border = true;

    //! Refinement stops there with a flagged partial result. Unset: no bound.
    std::optional<std::size_t> max_vertices = std::nullopt;
};

} // namespace voroprobe
