#include "solid_topology.h"

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "support/union_find.h"

namespace voroprobe
{
namespace
{

constexpr std::size_t kRim = 2; // of outside points: one that is visited, one that is only looked at

//! Inside and outside points of a lattice.
class Lattice
{
public:
    Lattice(const LevelFunction& function, const Box3& box, std::size_t n)
        : n_(n + 2 * kRim), inside_(n_ * n_ * n_, false)
    {
        const Vec3 step = box.extent() / static_cast<double>(n - 1);
        for (std::size_t k = 0; k < n; ++k)
            for (std::size_t j = 0; j < n; ++j)
                for (std::size_t i = 0; i < n; ++i)
                    inside_[(i + kRim) + n_ * ((j + kRim) + n_ * (k + kRim))] =
                        function(box.min + Vec3{static_cast<double>(i) * step.x,
                                                static_cast<double>(j) * step.y,
                                                static_cast<double>(k) * step.z}) >= 0.0;
    }

    //! Points - edges + squares - cubes: for every point and every choice of axes, the box of the lattice
    //! that extends from there along those axes.
    [[nodiscard]] long solid_euler_characteristic() const
    {
        long sum = 0;
        for (std::size_t point = 0; point < inside_.size(); ++point)
            for (unsigned axes = 0; inside_[point] && axes < 8; ++axes)
                if (is_in_solid(point, axes))
                    sum += std::popcount(axes) % 2 == 0 ? 1 : -1;
        return sum;
    }

    //! Inside parts connect through faces, outside parts through faces, edges and corners.
    [[nodiscard]] std::size_t count_parts() const
    {
        UnionFind parts(inside_.size());
        for (std::size_t k = 1; k + 1 < n_; ++k)
            for (std::size_t j = 1; j + 1 < n_; ++j)
                for (std::size_t i = 1; i + 1 < n_; ++i)
                    join_neighbors(parts, i + n_ * (j + n_ * k));
        std::size_t count = 0;
        for (std::uint32_t point = 0; point < inside_.size(); ++point)
            count += parts.find(point) == point ? 1 : 0;
        return count;
    }

private:
    [[nodiscard]] std::size_t offset(unsigned axes) const
    {
        return (axes & 1U) + n_ * ((axes >> 1U & 1U) + n_ * (axes >> 2U & 1U));
    }

    [[nodiscard]] bool is_in_solid(std::size_t point, unsigned axes) const
    {
        for (unsigned corner = 0; corner < 8; ++corner)
            if ((corner & ~axes) == 0 && !inside_[point + offset(corner)])
                return false;
        return true;
    }

    void join_neighbors(UnionFind& parts, std::size_t point) const
    {
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                {
                    const auto n = static_cast<std::ptrdiff_t>(n_);
                    const auto other =
                        static_cast<std::size_t>(static_cast<std::ptrdiff_t>(point) + dx + n * (dy + n * dz));
                    const bool across_face = std::abs(dx) + std::abs(dy) + std::abs(dz) == 1;
                    if (inside_[point] == inside_[other] && (across_face || !inside_[point]))
                        parts.unite(static_cast<std::uint32_t>(point), static_cast<std::uint32_t>(other));
                }
    }

    std::size_t n_;
    std::vector<bool> inside_;
};

} // namespace

SurfaceTopology count_on_lattice(const LevelFunction& function, const Box3& box, std::size_t n)
{
    const Lattice lattice(function, box, n);
    return {.components = lattice.count_parts() - 1,
            .euler_characteristic = 2 * lattice.solid_euler_characteristic()};
}

} // namespace voroprobe
