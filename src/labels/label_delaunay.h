#pragma once

// CGAL's triangulation as meshing of interfaces uses it. Internal to src/labels: no other folder includes
// this header.

#include <array>
#include <cstdint>
#include <limits>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include "geometry/vec3.h"
#include "labels/label_partition.h"

namespace voroprobe
{

//! What is known of a Delaunay cell.
struct LabelledCellData
{
    Point3 circumcenter;
    PartitionLabel label = 0;
    std::uint64_t stamp = 0;  //!< of its making: cells are made anew in old places
    std::uint32_t number = 0; //!< scratch of LabelPieces
};

using LabelKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using LabelVertexBase = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, LabelKernel>;
using LabelCellBase =
    CGAL::Triangulation_cell_base_with_info_3<LabelledCellData, LabelKernel,
                                              CGAL::Delaunay_triangulation_cell_base_3<LabelKernel>>;

//! Vertices have their number in order of insertion, or kSentinel.
using LabelDelaunay =
    CGAL::Delaunay_triangulation_3<LabelKernel,
                                   CGAL::Triangulation_data_structure_3<LabelVertexBase, LabelCellBase>>;
using LabelCell = LabelDelaunay::Cell_handle;
using LabelVertex = LabelDelaunay::Vertex_handle;

//! A vertex far away, which makes every dual edge that meets a label a segment.
inline constexpr std::uint32_t kSentinel = std::numeric_limits<std::uint32_t>::max();

inline Point3 from_cgal(const LabelKernel::Point_3& p)
{
    return {p.x(), p.y(), p.z()};
}

inline LabelKernel::Point_3 to_cgal(const Point3& p)
{
    return {p.x, p.y, p.z};
}

//! Of the facet opposite vertex `index`.
inline std::array<Point3, 3> facet_corners(LabelCell cell, int index)
{
    return {from_cgal(cell->vertex((index + 1) % 4)->point()),
            from_cgal(cell->vertex((index + 2) % 4)->point()),
            from_cgal(cell->vertex((index + 3) % 4)->point())};
}

} // namespace voroprobe
