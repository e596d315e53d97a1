#include "labels/part_presence.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "certificate/mesh_pieces.h"

namespace voroprobe
{

namespace
{

//! Looks up which part lies next to a point.
class NearestPart
{
public:
    NearestPart(const PartMask& mask, const Vec3& spacing) : mask_(mask), spacing_(spacing) {}

    //! The part of the nearest of the samples around a point that belong to one, as PartMask has it; 0 for
    //! none.
    [[nodiscard]] std::uint32_t at(const Point3& p) const
    {
        std::uint32_t part = 0;
        double nearest = std::numeric_limits<double>::infinity();
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                {
                    const std::array<long, 3> index{std::lround(p.x / spacing_.x) + dx,
                                                    std::lround(p.y / spacing_.y) + dy,
                                                    std::lround(p.z / spacing_.z) + dz};
                    const std::uint32_t here = part_of(index);
                    const Point3 sample{spacing_.x * static_cast<double>(index[0]),
                                        spacing_.y * static_cast<double>(index[1]),
                                        spacing_.z * static_cast<double>(index[2])};
                    if (here == 0 || squared_distance(sample, p) >= nearest)
                        continue;
                    nearest = squared_distance(sample, p);
                    part = here;
                }
        return part;
    }

private:
    //! 0 beyond the mask, too.
    [[nodiscard]] std::uint32_t part_of(const std::array<long, 3>& index) const
    {
        std::size_t at = 0;
        for (std::size_t axis = 3; axis-- > 0;)
        {
            if (index[axis] < 0 || index[axis] >= static_cast<long>(mask_.size[axis]))
                return 0;
            at = at * mask_.size[axis] + static_cast<std::size_t>(index[axis]);
        }
        return mask_.part[at];
    }

    const PartMask& mask_;
    Vec3 spacing_;
};

//! The part with the most votes; 0 where that is none.
std::uint32_t winner_of(const std::map<std::uint32_t, std::size_t>& votes)
{
    std::uint32_t winner = 0;
    std::size_t most = 0;
    for (const auto& [part, count] : votes)
        if (count > most)
        {
            most = count;
            winner = part;
        }
    return winner;
}

} // namespace

std::vector<bool> parts_present(const TriangleMesh& mesh, const PartMask& mask, const Vec3& spacing)
{
    const MeshPieces pieces = split_into_pieces(mesh);
    const NearestPart nearest(mask, spacing);
    std::vector<std::map<std::uint32_t, std::size_t>> votes(pieces.pieces.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        for (const std::uint32_t v : mesh.faces[f])
            ++votes[pieces.piece_of_face[f]][nearest.at(mesh.vertices[v])];
    std::vector<bool> present(mask.part_count, false);
    for (std::size_t piece = 0; piece < votes.size(); ++piece)
        if (const std::uint32_t part = winner_of(votes[piece]);
            part != 0 && pieces.pieces[piece].closed() && pieces.pieces[piece].enclosed_volume > 0.0)
            present[part - 1] = true;
    return present;
}

} // namespace voroprobe
