#pragma once

#include <cstddef>
#include <optional>

#include "certificate/face_tree.h"
#include "mesh/triangle_mesh.h"
#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! What the faces were asked to satisfy; unset: not counted.
struct FaceCriteria
{
    std::optional<double> min_angle_deg = std::nullopt; //!< in [0, 60]
    std::optional<double> max_radius = std::nullopt;    //!< of the surface Delaunay ball, scan units, > 0
    std::optional<double> max_center_distance =
        std::nullopt; //!< from circumcenter to ball center, scan units, > 0
};

//! Faces that do not; unset where no bound was given.
struct CriteriaExceptions
{
    std::optional<std::size_t> angle = std::nullopt;
    std::optional<std::size_t> size = std::nullopt;
    std::optional<std::size_t> distance = std::nullopt;
};

//! A face's surface Delaunay ball is centered where the line through its circumcenter, at right angles to it,
//! meets the surface next; where it meets none as near as the bounds ask, the face is an exception. Cost: one
//! query per face where a bound on radius or distance is given, on all cores. Frame: the oracle's.
CriteriaExceptions count_exceptions(const TriangleMesh& mesh, const SurfaceOracle& oracle,
                                    const FaceCriteria& criteria);

//! The same for a mesh whose tree there is.
CriteriaExceptions count_exceptions(const FaceTree& tree, const SurfaceOracle& oracle,
                                    const FaceCriteria& criteria);

} // namespace voroprobe
