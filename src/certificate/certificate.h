#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "certificate/criteria_exceptions.h"
#include "certificate/lost_parts.h"
#include "certificate/surface_distance.h"
#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"
#include "oracles/surface_oracle.h"
#include "volume/inventory.h"

namespace voroprobe
{

//! A surface of the scan that has no piece of the mesh to itself, or was left out on purpose.
struct MissingSurface
{
    SurfaceId id;
    std::size_t voxels; //!< samples it encloses
    Box3 box;           //!< oracle frame, as all boxes here
    std::string reason;
};

//! A surface of the scan that is several pieces of the mesh; where it may end at the border, of which some
//! are closed.
struct SplitSurface
{
    SurfaceId id;
    std::size_t pieces;
    Box3 box;
};

//! A surface of the scan whose mesh has another number of handles.
struct GenusMismatch
{
    SurfaceId id;
    long expected_euler_characteristic;
    long mesh_euler_characteristic; //!< of all its pieces together
    Box3 box;

    //! Bridges and tunnels of the scan that lie on the wrong side of the mesh: where handles are lost or
    //! made, if they are not larger than a voxel. Necks beside which nothing is amiss may be among them.
    std::vector<Point3> places;
};

//! A piece of the mesh that lies on no surface of the scan.
struct ForeignPiece
{
    std::uint32_t piece; //!< numbered by first face
    std::size_t faces;
    Box3 box;
};

//! A surface left out of the mesh on purpose.
struct DroppedSurface
{
    SurfaceId id;
    std::string reason;
};

struct CertificateOptions
{
    //! Vertices farther from the surface lie on none, scan units, > 0; a voxel or two.
    double reach;

    //! The mesher's floor: parts of the scan thinner than twice this, scan units, need not be there. Unset: a
    //! quarter of the reach.
    std::optional<double> floor_radius = std::nullopt;

    //! Whether caps close the object on the border of the volume; else a piece may end there.
    BorderCaps caps = BorderCaps::kCounted;

    //! Bounds on faces whose exceptions are to be counted.
    FaceCriteria criteria = {};

    //! Samples for the distance; caps and box are set by certify().
    SamplingOptions sampling = {};

    //! Surfaces that are not expected.
    std::vector<DroppedSurface> dropped = {};

    //! The dear part: leave it to a test of the whole, where there is one already.
    bool test_self_intersections = true;
};

//! Whether a mesh is the mesh of a scan, all of it.
struct Certificate
{
    std::size_t surfaces_expected =
        0;                           //!< those of the scan, but for the dropped ones and those in the border
    std::size_t surfaces_meshed = 0; //!< of these, with a closed piece or several
    std::vector<MissingSurface> missing;
    std::vector<MissingSurface> dropped;
    std::vector<MissingSurface> in_border; //!< left out with their caps where the border is open
    std::vector<SplitSurface> split;
    std::vector<ForeignPiece> foreign;
    std::vector<LostPart> lost_parts; //!< of surfaces that are meshed otherwise
    std::vector<GenusMismatch> genus_mismatches;

    MeshTopology topology;
    std::size_t surfaces_inside_out =
        0;               //!< whose closed pieces, together, wind inward; round a cavity, outward
    bool closed = false; //!< but for rims on the border where it is open
    std::optional<std::size_t> self_intersections = std::nullopt; //!< pairs of faces; unset: not tested

    SurfaceDistance distance;
    CriteriaExceptions criteria_exceptions;

    //! Surfaces of the scan and pieces of the mesh correspond one to one, but for hairs from end to end.
    [[nodiscard]] bool complete() const
    {
        return missing.empty() && split.empty() && foreign.empty() &&
               std::all_of(lost_parts.begin(), lost_parts.end(), std::mem_fn(&LostPart::is_hair));
    }
    [[nodiscard]] bool manifold() const { return topology.manifold(); }
    [[nodiscard]] bool oriented() const { return topology.oriented() && surfaces_inside_out == 0; }
};

//! Compares a mesh, made by anyone, with the inventory of a scan.
//!
//! The mesh falls into pieces connected through edges. Each represents the surface that most of its area lies
//! on; a surface is meshed where a closed piece represents it. Of several surfaces on one piece the others
//! are missing, merged with it, unless they have pieces of their own.
//!
//! Without caps a surface that touches the border may be any number of sheets with a rim. Where it comes
//! nowhere farther from the border than twice the floor's radius, it need not have a piece.
//!
//! `surfaces`: those of the oracle's inventory, by id. `surface_of_face`: where the maker of the mesh knows
//! it; else found by surface_of_vertices(). Frame: the oracle's. \pre equal points of the mesh are one
//! vertex. Cost: that of surface_of_vertices(), self_intersections(), count_exceptions() and
//! surface_distance(), each where it is called for. Deterministic. \throw UsageError where options.reach is
//! not > 0, a dropped id is none, or `surface_of_face` has another length than the faces.
Certificate certify(const TriangleMesh& mesh, const SurfaceOracle& oracle,
                    std::span<const ScanSurface> surfaces, const CertificateOptions& options,
                    std::optional<std::span<const SurfaceId>> surface_of_face = std::nullopt);

//! Why the promise does not hold, in one line; nullopt where it does. Genus and criteria are no part of it.
std::optional<std::string> broken_promise(const Certificate& certificate);

} // namespace voroprobe
