#pragma once

#include <cstddef>
#include <vector>

#include "certificate/certificate.h"
#include "mesher/seeded_mesher.h"

namespace voroprobe
{

//! Takes surfaces off a mesh, of the `surface_count` that there are. \pre result.surface_of_face is known.
void drop_surfaces(const std::vector<DroppedSurface>& dropped, std::size_t surface_count,
                   MeshingResult& result);

} // namespace voroprobe
