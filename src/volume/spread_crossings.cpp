#include "volume/spread_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>

#include "volume/cell_sweep.h"
#include "volume/slabs.h"

namespace voroprobe
{
namespace
{

//! Which grid cells lie in which cube: by their lowest corners, along each axis.
class CubesOfCells
{
public:
    CubesOfCells(const LatticeFrame& frame, double side)
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            const double cells_in_side = std::max(1.0, side / std::abs(frame.step[axis]));
            for (int index = 0; index <= frame.sample_count[axis]; ++index) // from the rim on
                cube_of_index_[axis].push_back(static_cast<int>(index / cells_in_side));
        }
    }

    [[nodiscard]] std::array<int, 3> cube(const SweptCell& cell) const
    {
        return {cube_at(0, cell.i()), cube_at(1, cell.j()), cube_at(2, cell.k())};
    }

    [[nodiscard]] int columns() const { return cube_of_index_[0].back() + 1; }
    [[nodiscard]] int rows() const { return cube_of_index_[1].back() + 1; }
    [[nodiscard]] int layer(int k) const { return cube_at(2, k); }

private:
    [[nodiscard]] int cube_at(std::size_t axis, int index) const
    {
        return cube_of_index_[axis][static_cast<std::size_t>(index) + 1];
    }

    std::array<std::vector<int>, 3> cube_of_index_; //!< from -1 on
};

//! The first crossing of each surface in each cube, layer by layer of cubes.
class SpreadCrossings
{
public:
    SpreadCrossings(const LatticeFrame& frame, const Inventory& inventory, const CubesOfCells& cubes)
        : frame_(frame), inventory_(inventory), cubes_(cubes),
          taken_(static_cast<std::size_t>(cubes.columns()) * static_cast<std::size_t>(cubes.rows()))
    {
    }

    //! The three edges from the lowest corner; of the others, those of grid cells further on.
    void visit(SweptCell& cell)
    {
        const bool inside = (cell.code() & 1U) != 0;
        for (const std::size_t end : {1U, 2U, 4U})
        {
            if (((cell.code() >> end & 1U) != 0) == inside)
                continue;
            const SurfaceId surface = surface_between(cell.run(0)->region, cell.run(end)->region);
            if (surface != kNoSurface && take(cubes_.cube(cell), surface))
                points_.push_back({surface, crossing(cell, end)});
        }
    }

    [[nodiscard]] std::vector<SurfacePoint> take() && { return std::move(points_); }

private:
    //! Most often that of the edge before.
    [[nodiscard]] SurfaceId surface_between(Region a, Region b)
    {
        if (a != last_pair_.first || b != last_pair_.second)
        {
            last_pair_ = {a, b};
            last_surface_ = inventory_.surface_between(a, b);
        }
        return last_surface_;
    }

    //! False where the surface was taken in this cube.
    bool take(const std::array<int, 3>& cube, SurfaceId surface)
    {
        if (cube[2] != layer_)
        {
            for (std::vector<SurfaceId>& surfaces : taken_)
                surfaces.clear();
            layer_ = cube[2];
        }
        std::vector<SurfaceId>& surfaces =
            taken_[static_cast<std::size_t>(cube[0]) +
                   static_cast<std::size_t>(cube[1]) * static_cast<std::size_t>(cubes_.columns())];
        if (std::find(surfaces.begin(), surfaces.end(), surface) != surfaces.end())
            return false;
        surfaces.push_back(surface);
        return true;
    }

    [[nodiscard]] Point3 crossing(const SweptCell& cell, std::size_t end) const
    {
        const Point3 from = frame_.at(cell.index(0));
        const Point3 to = frame_.at(cell.index(end));
        if (!cell.is_sample(0))
            return to;
        if (!cell.is_sample(end))
            return from;
        return edge_crossing(from, cell.height(0), to, cell.height(end));
    }

    const LatticeFrame& frame_;
    const Inventory& inventory_;
    const CubesOfCells& cubes_;
    int layer_ = -1;                            //!< of cubes
    std::vector<std::vector<SurfaceId>> taken_; //!< by cube of the layer
    std::vector<SurfacePoint> points_;
    std::pair<Region, Region> last_pair_{kOuterRegion, kOuterRegion};
    SurfaceId last_surface_ = kNoSurface;
};

} // namespace

std::vector<SurfacePoint> spread_crossings(const HeightField& field, const Inventory& inventory, double side,
                                           std::size_t threads)
{
    const LatticeFrame frame = field.frame();
    const CubesOfCells cubes(frame, side);
    static constexpr Run kBeyondBorder{0, kOuterRegion};
    // Layers of grid cells, the first between the rim and slice 0; those of a layer of cubes go together.
    std::vector<int> first_of_layer;
    for (int k = -1; k < frame.sample_count[2]; ++k)
        if (static_cast<std::size_t>(cubes.layer(k)) == first_of_layer.size())
            first_of_layer.push_back(k);
    const std::size_t layers = first_of_layer.size();
    first_of_layer.push_back(frame.sample_count[2]);

    std::map<std::size_t, std::vector<SurfacePoint>> points_of_slab; // by its first layer
    std::mutex mutex;
    for_each_slab(layers, threads,
                  [&](std::size_t begin, std::size_t end)
                  {
                      SpreadCrossings crossings(frame, inventory, cubes);
                      CellSweep sweep(inventory.runs(), &kBeyondBorder,
                                      [&](SweptCell& cell) { crossings.visit(cell); });
                      SliceWindow window(field, first_of_layer[begin]);
                      sweep.sweep(window);
                      for (int k = first_of_layer[begin] + 1; k < first_of_layer[end]; ++k)
                      {
                          window.move_up();
                          sweep.sweep(window);
                      }
                      const std::lock_guard lock(mutex);
                      points_of_slab[begin] = std::move(crossings).take();
                  });
    std::vector<SurfacePoint> all;
    for (const auto& [begin, points] : points_of_slab)
        all.insert(all.end(), points.begin(), points.end());
    return all;
}

} // namespace voroprobe
