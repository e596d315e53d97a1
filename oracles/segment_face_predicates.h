#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace voroprobe
{

using MeshKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

//! Whether a segment crosses a face once all query points are moved by one infinitesimal vector (h, h^2,
//! h^3): never undecided, and an even number of times around any closed way for any closed surface. False for
//! faces without area. \pre source != target.
bool crosses(const MeshKernel::Point_3& source, const MeshKernel::Point_3& target,
             const MeshKernel::Triangle_3& face);

//! The parameter along the segment, in [0, 1], where it meets the face's plane. \pre crosses().
double crossing_parameter(const MeshKernel::Point_3& source, const MeshKernel::Point_3& target,
                          const MeshKernel::Triangle_3& face);

} // namespace voroprobe
