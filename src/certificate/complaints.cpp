#include "certificate/complaints.h"

#include "support/number_text.h"

namespace voroprobe
{

void Complaints::add(std::size_t count, const std::string& one, const std::string& many)
{
    if (count > 0)
        text_ += (text_.empty() ? "" : ", ") + count_text(count) + ' ' + (count == 1 ? one : many);
}

void Complaints::add_crowding(const MeshTopology& topology)
{
    add(topology.non_manifold_edges, "edge on more than two faces", "edges on more than two faces");
    add(topology.non_manifold_vertices, "vertex whose faces are not one fan",
        "vertices whose faces are not one fan");
    add(topology.misoriented_edges, "edge whose faces wind against each other",
        "edges whose faces wind against each other");
}

std::optional<std::string> Complaints::text() const
{
    return text_.empty() ? std::nullopt : std::optional(text_);
}

} // namespace voroprobe
