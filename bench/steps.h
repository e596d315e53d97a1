#pragma once

#include <memory>

#include "compare/contestant.h"
#include "compare/reference_surface.h"

namespace voroprobe::bench
{

//! The list of the scan's surfaces.
std::unique_ptr<Contestant> make_inventory(const MeshingTask& task);

//! The certificate of our mesh as `voroprobe mesh` makes it, without the test for self-intersections. The
//! mesh is made before the clock starts.
std::unique_ptr<Contestant> make_certificate(const MeshingTask& task, const ReferenceSurface& reference);

//! CGAL's spatially sorted Delaunay insertion of the vertices of our mesh, which is made before the clock
//! starts: what refinement would cost if it knew its vertices.
std::unique_ptr<Contestant> make_bulk_insertion(const MeshingTask& task, const ReferenceSurface& reference);

} // namespace voroprobe::bench
