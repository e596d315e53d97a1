#include "postprocess/face_grid.h"

#include <algorithm>
#include <cmath>

#include "support/check.h"

namespace voroprobe
{

namespace
{

//! Boxes over more cells are compared with all faces, and faces over more cells with all boxes.
constexpr double kMostCells = 1000.0;

bool overlap(const Box3& a, const Box3& b)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (a.max[axis] < b.min[axis] || a.min[axis] > b.max[axis])
            return false;
    return true;
}

} // namespace

FaceGrid::FaceGrid(const EditableMesh& mesh, double cell_size) : mesh_(mesh), cell_size_(cell_size)
{
    CHECK_GT(cell_size, 0.0);
    update();
}

//! Source of the factors: Teschner et al. 2003, Optimized spatial hashing.
std::size_t FaceGrid::Hash::operator()(const Cell& cell) const
{
    constexpr std::array<std::size_t, 3> kPrimes{73856093, 19349663, 83492791};
    std::size_t hash = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        hash ^= static_cast<std::size_t>(cell[axis]) * kPrimes[axis];
    return hash;
}

auto FaceGrid::cell_of(const Point3& p) const -> Cell
{
    Cell cell{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        cell[axis] = static_cast<std::int64_t>(std::floor(p[axis] / cell_size_));
    return cell;
}

Box3 FaceGrid::box_of(std::uint32_t face) const
{
    Box3 box;
    for (const std::uint32_t v : mesh_.face(face))
        box.include(mesh_.point(v));
    return box;
}

template <typename Visit>
bool FaceGrid::for_cells(const Box3& box, Visit visit) const
{
    const Cell low = cell_of(box.min);
    const Cell high = cell_of(box.max);
    double cells = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        cells *= static_cast<double>(high[axis] - low[axis] + 1);
    if (cells > kMostCells)
        return false;
    for (std::int64_t z = low[2]; z <= high[2]; ++z)
        for (std::int64_t y = low[1]; y <= high[1]; ++y)
            for (std::int64_t x = low[0]; x <= high[0]; ++x)
                visit(Cell{x, y, z});
    return true;
}

void FaceGrid::update()
{
    for (; known_ < mesh_.face_count(); ++known_)
        if (mesh_.is_alive(known_) &&
            !for_cells(box_of(known_), [this](const Cell& cell) { cells_[cell].push_back(known_); }))
            large_.push_back(known_);
}

std::vector<std::uint32_t> FaceGrid::faces_near(const Box3& box) const
{
    std::vector<std::uint32_t> result;
    const auto look = [&](std::uint32_t f)
    {
        if (mesh_.is_alive(f) && overlap(box_of(f), box))
            result.push_back(f);
    };
    const auto look_into = [&](const Cell& cell)
    {
        if (const auto entry = cells_.find(cell); entry != cells_.end())
            std::for_each(entry->second.begin(), entry->second.end(), look);
    };
    std::for_each(large_.begin(), large_.end(), look);
    if (!for_cells(box, look_into))
        for (std::uint32_t f = 0; f < known_; ++f)
            look(f);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

} // namespace voroprobe
