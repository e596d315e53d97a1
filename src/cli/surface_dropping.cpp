#include "cli/surface_dropping.h"

#include <utility>

namespace voroprobe
{

void drop_surfaces(const std::vector<DroppedSurface>& dropped, std::size_t surface_count,
                   MeshingResult& result)
{
    std::vector<bool> is_dropped(surface_count, false);
    for (const DroppedSurface& surface : dropped)
        is_dropped[static_cast<std::size_t>(surface.id)] = true;
    std::vector<bool> kept;
    std::vector<SurfaceId> surface_of_face;
    for (const SurfaceId surface : result.surface_of_face)
    {
        kept.push_back(surface == kNoSurface || !is_dropped[static_cast<std::size_t>(surface)]);
        if (kept.back())
            surface_of_face.push_back(surface);
    }
    result.mesh = with_faces(result.mesh, kept);
    result.surface_of_face = std::move(surface_of_face);
    std::erase_if(
        result.pieces, [&](const FoundPiece& piece)
        { return piece.surface != kNoSurface && is_dropped[static_cast<std::size_t>(piece.surface)]; });
}

} // namespace voroprobe
