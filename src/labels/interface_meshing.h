#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "labels/cavity_labels.h"
#include "labels/label_partition.h"
#include "mesh/triangle_mesh.h"
#include "mesher/meshing_options.h"
#include "mesher/seeded_mesher.h"
#include "support/progress.h"

namespace voroprobe
{

//! A face of the surfaces between labels. Seen from the side of `front` its vertices run counter-clockwise.
struct InterfaceFace
{
    TriangleMesh::Face vertices;
    PartitionLabel front;
    PartitionLabel behind; //!< another one
};

//! The surfaces between all labels, the background included, as one complex.
struct InterfaceMesh
{
    std::vector<Point3> vertices; //!< grid frame
    std::vector<InterfaceFace> faces;

    //! Parts, by their places in LabelSurvey::parts() of the label map, some of whose voxels have no Delaunay
    //! cell, those that are one piece with a larger part of their label, and those of several pieces.
    std::vector<std::uint32_t> missing_parts;
    std::vector<std::uint32_t> merged_parts;
    std::vector<std::uint32_t> parts_in_pieces;

    //! What each label encloses of everything else; by its place in LabelSurvey::labels(), plus one.
    std::vector<std::size_t> cavities;

    std::size_t crumbs_dissolved = 0; //!< pieces of labels where the label map has none, given to neighbours
    MeshingStatus status = MeshingStatus::kDone;
};

//! Meshes the surfaces between labels by Delaunay refinement: a facet of the triangulation is a face where
//! the circumcenters of its two Delaunay cells have different labels. So the faces around each label close
//! it, and neighbours have the very same triangles where they touch, whatever the criteria.
//!
//! Each part gets points of its own; one that has no Delaunay cell after refinement gets more, and is listed
//! if that does not help. Refinement ends at the floor of `criteria`: size, distance and angle hold above it,
//! as for mesh_surface(). Lines where three labels meet are followed as closely as the criteria ask, and not
//! kept sharp. Source: Pons et al., High-quality consistent meshing of multi-label datasets, 2007. On the
//! thread that calls. Cost: O(n log n) for n vertices.
//! `partition`: of all labels of `apart`, which is made of `survey`; faces name these.
InterfaceMesh mesh_interfaces(const LabelSurvey& survey, const CavityLabels& apart, const Vec3& spacing,
                              const LabelPartition& partition, const MeshingOptions& criteria,
                              ProgressSink* progress = nullptr);

//! Has faces name the labels of the label map in place of those of `apart`, and drops those between two that
//! stand for the same.
void name_labels_of_map(InterfaceMesh& interfaces, const CavityLabels& apart);

//! The faces of a label, turned outward, with the vertices they use.
TriangleMesh mesh_of_label(const InterfaceMesh& interfaces, PartitionLabel label);

} // namespace voroprobe
