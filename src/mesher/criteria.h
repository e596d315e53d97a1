#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "mesher/local_floor.h"
#include "mesher/meshing_options.h"
#include "mesher/restricted_delaunay.h"

namespace voroprobe
{

//! Why a facet is bad, in the order in which it is mended. What is coarse comes first: half of what looks
//! unresolved in a coarse mesh is resolved once size, distance and angle hold.
enum class Badness : std::uint8_t
{
    kSize,       //!< surface Delaunay ball larger than allowed
    kDistance,   //!< circumcenter too far from the center of the surface Delaunay ball
    kAngle,      //!< smallest angle below the bound
    kUnresolved, //!< its dual edge crosses the surface more than once
    kUnfaithful, //!< its vertices lie on another surface than the one between the regions of its cells
    kPinched     //!< the largest around a vertex whose odd facets are not one umbrella (check_umbrellas)
};
inline constexpr std::size_t kBadnessCount = 6;

//! The criteria of Feree & Alliez 2009, Definition 8, in a form without roots or trigonometry. The bounds are
//! squared once.
class FacetCriteria
{
public:
    explicit FacetCriteria(const MeshingOptions& options);

    //! The first criterion the facet breaks by itself, if any. Crossings closer together than the floor are
    //! not pursued.
    [[nodiscard]] std::optional<Badness> badness(const RestrictedFacet& facet,
                                                 const std::array<Point3, 3>& corners) const;

    //! The first criterion that a facet breaks by itself or by lying on another surface than its vertices.
    [[nodiscard]] std::optional<Badness> badness(const RestrictedDelaunay& restricted, FacetId id) const;

    //! Whether the facet is so small that topology is no longer pursued.
    [[nodiscard]] bool at_floor(const RestrictedFacet& facet) const
    {
        return facet.squared_radius <= floor_.squared_base() &&
               facet.squared_radius <= floor_.squared_at(facet.center);
    }

    [[nodiscard]] LocalFloor& floor() { return floor_; }

private:
    [[nodiscard]] std::optional<Badness> shape_badness(const RestrictedFacet& facet,
                                                       const std::array<Point3, 3>& corners) const;

    double squared_size_;
    double squared_distance_;
    double squared_sine_of_angle_;
    LocalFloor floor_;
    double squared_smallest_;
};

} // namespace voroprobe
