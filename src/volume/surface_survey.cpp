// The Euler characteristic is additive over the parts into which the padded grid cuts a surface: a crossing
// of a grid edge counts 1, an arc in a grid face -1, a patch in a grid cell 2 minus the number of its
// boundary loops (it is a sphere with holes). Four grid cells share an edge, two a face, hence quarters: of
// the c crossings that a grid cell sees, and of its arcs, which are as many, c / 4 - 2 c / 4 is its own.
//
// Beyond the border lies a rim of samples outside, each at no distance from its neighbour on the border: in
// this rim the surfaces close, and what they do there is what their caps do.

#include "volume/surface_survey.h"

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <tuple>

#include "volume/cell_sweep.h"
#include "volume/slabs.h"

namespace voroprobe
{
namespace
{

bool is_lower(const Point3& p, const Point3& q)
{
    return std::tie(p.z, p.y, p.x) < std::tie(q.z, q.y, q.x);
}

void note_crossing(SurfaceMeasure& measure, const Point3& p)
{
    measure.box.include(p);
    if (!measure.has_crossing || is_lower(p, measure.first_crossing))
        measure.first_crossing = p;
    measure.has_crossing = true;
}

void note_cap(SurfaceMeasure& measure, const Point3& border_sample)
{
    measure.box.include(border_sample);
    measure.touches_border = true;
}

void add(SurfaceMeasure& sum, const SurfaceMeasure& part)
{
    if (!part.box.empty())
    {
        sum.box.include(part.box.min);
        sum.box.include(part.box.max);
    }
    sum.euler_quarters += part.euler_quarters;
    sum.touches_border = sum.touches_border || part.touches_border;
    if (part.has_crossing && (!sum.has_crossing || is_lower(part.first_crossing, sum.first_crossing)))
        sum.first_crossing = part.first_crossing;
    sum.has_crossing = sum.has_crossing || part.has_crossing;
}

//! Contributions to the Euler characteristic, in quarters. See the top of the file.
constexpr int kCrossing = 1 - 2;
constexpr int kPatch = 4 * 2;
constexpr int kLoop = -4;

//! Measures surfaces grid cell by grid cell.
class Surveyor
{
public:
    Surveyor(const LatticeFrame& frame, const Inventory& inventory)
        : frame_(frame), inventory_(inventory), measures_(inventory.surfaces().size())
    {
    }

    void visit(SweptCell& cell)
    {
        const CodeTopology& topology = topology_of(cell.code());
        if (topology.simple)
        {
            const SurfaceId id = surface(cell, topology.an_inside, topology.an_outside);
            add_quarters(id, kPatch + kLoop + topology.crossed_edges * kCrossing);
        }
        else
            visit_complex(cell);
        visit_edges(cell);
    }

    [[nodiscard]] const std::vector<SurfaceMeasure>& measures() const { return measures_; }

private:
    [[nodiscard]] SurfaceId surface(SweptCell& cell, std::size_t inside, std::size_t outside) const
    {
        return inventory_.surface_between(cell.run(inside)->region, cell.run(outside)->region);
    }

    [[nodiscard]] SurfaceMeasure* measure(SurfaceId id)
    {
        return id == kNoSurface ? nullptr : &measures_[static_cast<std::size_t>(id)];
    }

    void add_quarters(SurfaceId id, int quarters)
    {
        if (SurfaceMeasure* found = measure(id))
            found->euler_quarters += quarters;
    }

    //! Patches lie between neighbouring parts of the corners, their loops between neighbouring parts of those
    //! on the faces; neighbours are joined by a crossed edge.
    void visit_complex(SweptCell& cell)
    {
        const CellTopology topology = cell.topology();
        PairSet patches;
        PairSet loops;
        for (const auto& [a, b] : cell_edges())
        {
            const bool a_inside = (cell.code() >> a & 1U) != 0;
            if (a_inside == ((cell.code() >> b & 1U) != 0))
                continue;
            const SurfaceId id = a_inside ? surface(cell, a, b) : surface(cell, b, a);
            add_quarters(id, kCrossing);
            if (patches.insert(topology.in_cell[a], topology.in_cell[b]))
                add_quarters(id, kPatch);
            if (loops.insert(topology.on_faces[a], topology.on_faces[b]))
                add_quarters(id, kLoop);
        }
    }

    //! Unordered pairs of corners.
    class PairSet
    {
    public:
        //! False where the pair was there.
        bool insert(std::size_t a, std::size_t b)
        {
            const std::uint64_t bit = std::uint64_t{1} << (8 * std::min(a, b) + std::max(a, b));
            const bool is_new = (bits_ & bit) == 0;
            bits_ |= bit;
            return is_new;
        }

    private:
        std::uint64_t bits_ = 0;
    };

    //! The three edges from the lowest corner; of the others, those of grid cells further on.
    void visit_edges(SweptCell& cell)
    {
        const bool inside = (cell.code() & 1U) != 0;
        for (const std::size_t end : {1U, 2U, 4U})
            if (((cell.code() >> end & 1U) != 0) != inside)
                visit_edge(cell, end, inside);
    }

    void visit_edge(SweptCell& cell, std::size_t end, bool inside)
    {
        SurfaceMeasure* found = measure(inside ? surface(cell, 0, end) : surface(cell, end, 0));
        if (found == nullptr)
            return;
        const Point3 from = frame_.at(cell.index(0));
        const Point3 to = frame_.at(cell.index(end));
        if (!cell.is_sample(0))
            note_cap(*found, to);
        else if (!cell.is_sample(end))
            note_cap(*found, from);
        else
            note_crossing(*found, edge_crossing(from, cell.height(0), to, cell.height(end)));
    }

    const LatticeFrame& frame_;
    const Inventory& inventory_;
    std::vector<SurfaceMeasure> measures_;
};

} // namespace

std::vector<SurfaceMeasure> measure_surfaces(const HeightField& field, const Inventory& inventory,
                                             std::size_t threads)
{
    const LatticeFrame frame = field.frame();
    const auto slices = static_cast<std::size_t>(frame.sample_count[2]);
    static constexpr Run kBeyondBorder{0, kOuterRegion};
    std::vector<SurfaceMeasure> sums(inventory.surfaces().size());
    std::mutex sums_mutex;
    // Layers, the first between the rim and slice 0.
    for_each_slab(slices + 1, threads,
                  [&](std::size_t begin, std::size_t end)
                  {
                      Surveyor surveyor(frame, inventory);
                      CellSweep sweep(inventory.runs(), &kBeyondBorder,
                                      [&](SweptCell& cell) { surveyor.visit(cell); });
                      SliceWindow window(field, static_cast<int>(begin) - 1);
                      for (std::size_t layer = begin; layer < end; ++layer)
                      {
                          if (layer > begin)
                              window.move_up();
                          sweep.sweep(window);
                      }
                      const std::lock_guard lock(sums_mutex);
                      for (std::size_t id = 0; id < sums.size(); ++id)
                          add(sums[id], surveyor.measures()[id]);
                  });
    return sums;
}

} // namespace voroprobe
