#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "volume/trilinear_cell.h"

namespace voroprobe
{

//! The sides of the corners of a grid cell: bit c is set where corner c is inside.
using CornerCode = std::uint8_t;

//! The corner reached from `local`, coordinates in [0, 1], by three moves along the axes, each in the
//! direction in which the interpolant, linear along it, does not fall. All of the way lies in {value >= value
//! at `local`}: the corner is inside where trilinear_value() says that `local` is, and belongs to the same
//! region. Exact: the moves compare what trilinear_value() interpolates between. Cost: as trilinear_value().
std::size_t corner_uphill(const CellCorners& corners, const Vec3& local);

//! The same downhill: the corner is outside where `local` is.
std::size_t corner_downhill(const CellCorners& corners, const Vec3& local);

//! Corners reached uphill and downhill from a point of the surface.
struct CornersBeside
{
    std::size_t uphill;
    std::size_t downhill;
};

//! The first move is along the steepest axis, away from the surface: at once out of the reach of rounding.
CornersBeside corners_beside(const CellCorners& corners, const Vec3& on_surface);

//! Which corners of a grid cell the interpolant connects: corner -> a corner of the same part, the same for
//! all of it.
using CornerParts = std::array<std::uint8_t, 8>;

//! The connections of the corners of one side.
struct CellTopology
{
    CornerParts on_faces; //!< within the faces of the grid cell
    CornerParts in_cell;  //!< within the grid cell
};

//! Topology by the sign alone, where it settles it; most mixed grid cells.
struct CodeTopology
{
    bool simple;                //!< the grid's edges join all corners inside, and all corners outside
    std::uint8_t an_inside;     //!< a corner inside, where there is one
    std::uint8_t an_outside;    //!< a corner outside, where there is one
    std::uint8_t crossed_edges; //!< edges between corners of different sides
};
const CodeTopology& topology_of(CornerCode code);

//! Pairs of corners joined by an edge.
using CornerPair = std::array<std::uint8_t, 2>;
const std::array<CornerPair, 12>& cell_edges();

//! Corners of one side are joined along edges; across a face whose diagonals lie on different sides, the
//! diagonal on the side of the face's saddle is (saddles of value 0 are inside), a rule of the face's corners
//! alone, so that both its grid cells agree; through the inside of the grid cell by its body saddles, at most
//! two. That is complete: parts of {value >= v} and of {value < v} meet nowhere else.
//! Source: Nielson & Hamann, The asymptotic decider, 1991; Nielson, On marching cubes, 2003.
CellTopology connect_corners(const CellCorners& corners);

//! The same without body saddles: for grid cells beyond the border, whose far corners are no samples.
CellTopology connect_corners_on_faces(const CellCorners& corners);

} // namespace voroprobe
