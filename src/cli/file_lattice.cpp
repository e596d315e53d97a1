#include "cli/file_lattice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace voroprobe
{

namespace
{

std::size_t longest_axis(const Vec3& v)
{
    const Vec3 a{std::abs(v.x), std::abs(v.y), std::abs(v.z)};
    if (a.x >= a.y && a.x >= a.z)
        return 0;
    return a.y >= a.z ? 1 : 2;
}

} // namespace

FileLattice file_lattice(const std::array<std::size_t, 3>& grid_size, const GridPlacement& placement)
{
    const AffineTransform world_from_index =
        placement.world_from_grid * inverse(placement.source_index_from_grid);
    FileLattice lattice{};
    lattice.origin = world_from_index.translation;
    for (std::size_t grid_axis = 0; grid_axis < 3; ++grid_axis)
    {
        const std::size_t file_axis = longest_axis(placement.source_index_from_grid.linear.column[grid_axis]);
        lattice.size[file_axis] = grid_size[grid_axis];
    }
    for (std::size_t file_axis = 0; file_axis < 3; ++file_axis)
    {
        const Vec3& step = world_from_index.linear.column[file_axis];
        lattice.spacing[file_axis] = norm(step);
        lattice.direction.column[file_axis] = normalized(step);
    }
    return lattice;
}

std::string orientation_letters(const Matrix3& direction)
{
    constexpr std::array<std::array<char, 2>, 3> kLetters{{{'L', 'R'}, {'P', 'A'}, {'S', 'I'}}};
    std::string letters;
    for (const Vec3& axis : direction.column)
    {
        const std::size_t world_axis = longest_axis(axis);
        letters += kLetters[world_axis][axis[world_axis] < 0.0 ? 1 : 0];
    }
    return letters;
}

double obliqueness_deg(const Matrix3& direction)
{
    double smallest_cosine = 1.0;
    for (const Vec3& axis : direction.column)
        smallest_cosine = std::min(smallest_cosine, std::abs(axis[longest_axis(axis)]));
    return std::acos(smallest_cosine) * 180.0 / std::numbers::pi;
}

} // namespace voroprobe
