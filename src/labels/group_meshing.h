#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "labels/part_groups.h"
#include "labels/smoothing.h"
#include "mesh/triangle_mesh.h"
#include "mesher/meshing_options.h"
#include "mesher/seeded_mesher.h"
#include "support/progress.h"

namespace voroprobe
{

//! What label meshes have to satisfy.
struct LabelMeshingOptions
{
    MeshingOptions criteria;
    LabelSmoothing smoothing;

    //! How much the volume of a mesh may differ from that of the voxels, as a fraction of it, > 0. Part by
    //! part, where the samples allow it.
    double volume_tolerance = 0.005;
};

//! A part of a label that has no mesh of its own.
struct PartFault
{
    std::uint32_t part; //!< its place in LabelSurvey::parts()
    std::string reason;
};

//! The mesh of a group of parts, and whether it is what was promised.
struct GroupMesh
{
    TriangleMesh mesh; //!< closed, oriented outward; frame: the grid frame of the label map
    std::vector<PartFault> faults;
    std::size_t cavities_expected = 0; //!< in the label map: samples outside joined through faces of voxels
    std::size_t cavities_meshed = 0;
    std::size_t parts_restored = 0; //!< that smoothing would have swallowed
    std::size_t vertices_moved = 0; //!< to keep the volume; 0 where refinement was run anew for it
    std::size_t faces_below_angle = 0;
    std::optional<std::string> broken_promise; //!< of the certificate, in one line; unset where all holds
    MeshingStatus status = MeshingStatus::kDone;
};

//! Smooths and meshes a group, gives each part the volume of its voxels, and holds the mesh against the parts
//! and cavities of the label map.
//!
//! The field is meshed by mesh_surface(); where chords or corners cut off more volume than tolerated, the
//! level is shifted part by part and the vertices follow it; where that breaks the mesh, it is made anew at
//! the shifted level. Cost: that of mesh_surface(), once in most cases. Deterministic, on the thread that
//! calls but for the certificate. `voxels` spacing: scan units.
GroupMesh mesh_group(const LabelSurvey& survey, const PartGroup& group, const Vec3& spacing,
                     const LabelMeshingOptions& options, ProgressSink* progress = nullptr);

} // namespace voroprobe
