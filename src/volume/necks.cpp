#include "volume/necks.h"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

#include "volume/cell_sweep.h"
#include "volume/sample_neighborhood.h"

namespace voroprobe
{
namespace
{

class Necks
{
public:
    Necks(const LatticeFrame& frame, const Inventory& inventory) : frame_(frame), inventory_(inventory) {}

    void add(const Point3& middle, Region region, std::vector<Point3> ends, std::span<const Region> beside)
    {
        Neck neck{middle, std::move(ends), region, {}};
        for (const Region other : beside)
        {
            const SurfaceId surface = inventory_.surface_between(region, other);
            if (surface != kNoSurface &&
                std::find(neck.surfaces.begin(), neck.surfaces.end(), surface) == neck.surfaces.end())
                neck.surfaces.push_back(surface);
        }
        necks_.push_back(std::move(neck));
    }

    [[nodiscard]] Point3 at(const std::array<int, 3>& index) const { return frame_.at(index); }
    [[nodiscard]] Region region(const std::array<int, 3>& index) const
    {
        return inventory_.region(index[0], index[1], index[2]);
    }
    [[nodiscard]] std::vector<Neck> take() && { return std::move(necks_); }

private:
    const LatticeFrame& frame_;
    const Inventory& inventory_;
    std::vector<Neck> necks_;
};

//! A face of a grid cell: a and d are opposite, as are b and c.
struct CellFace
{
    std::size_t a, b, c, d;
};

//! Those with the lowest corner; the others are other grid cells'.
constexpr std::array<CellFace, 3> kLowFaces{{{0, 2, 4, 6}, {0, 1, 4, 5}, {0, 1, 2, 3}}};

//! Finds necks at the saddles of one grid cell after the other.
class SaddleSearch
{
public:
    explicit SaddleSearch(Necks& necks) : necks_(necks) {}

    void visit(SweptCell& cell)
    {
        if (topology_of(cell.code()).simple)
            return; // which no face leaves open
        for (const CellFace& face : kLowFaces)
            visit_face(cell, face);
    }

private:
    void visit_face(SweptCell& cell, const CellFace& face)
    {
        const auto [a, b, c, d] = face;
        const auto side = [&](std::size_t corner) { return (cell.code() >> corner & 1U) != 0; };
        if (side(a) != side(d) || side(b) != side(c) || side(a) == side(b) || !cell.is_sample(a) ||
            !cell.is_sample(d))
            return;
        const double ad = cell.height(a) * cell.height(d);
        const double bc = cell.height(b) * cell.height(c);
        const bool inside = side(a) ? ad >= bc : bc >= ad; // as connect_corners() has it
        const auto [first, last] = side(a) == inside ? std::pair(a, d) : std::pair(b, c);
        const auto [beside, opposite] = side(a) == inside ? std::pair(b, c) : std::pair(a, d);
        const std::array<Region, 2> others{necks_.region(cell.index(beside)),
                                           necks_.region(cell.index(opposite))};
        necks_.add(saddle(cell, face), necks_.region(cell.index(first)),
                   {necks_.at(cell.index(first)), necks_.at(cell.index(last))}, others);
    }

    //! \pre The diagonals lie on different sides: there is one, within the face.
    [[nodiscard]] Point3 saddle(const SweptCell& cell, const CellFace& face) const
    {
        const double a = cell.height(face.a);
        const double b = cell.height(face.b);
        const double c = cell.height(face.c);
        const double d = cell.height(face.d);
        const double curvature = (a + d) - (b + c);
        const Point3 origin = necks_.at(cell.index(face.a));
        return origin + (a - c) / curvature * (necks_.at(cell.index(face.b)) - origin) +
               (a - b) / curvature * (necks_.at(cell.index(face.c)) - origin);
    }

    Necks& necks_;
};

//! Finds necks at samples, slice by slice.
class SampleSearch
{
public:
    SampleSearch(const std::array<int, 3>& sample_count, Necks& necks)
        : size_(sample_count), necks_(necks),
          beside_crossing_((static_cast<std::size_t>(size_[0]) + kWord - 1) / kWord * kWord)
    {
    }

    //! The window's slice k. \pre the window has moved up.
    void visit_slice(const SliceWindow& slices)
    {
        for (int j = 0; j < size_[1]; ++j)
            visit_row(slices, j);
    }

private:
    //! By row of the neighbourhood: for columns -1 and up, bit 0 the column's side and bit 1 the next one's.
    using Rows = std::array<const std::uint8_t*, 9>;

    void visit_row(const SliceWindow& slices, int j)
    {
        const std::array<const PaddedSlice*, 3> around{&slices.before(), &slices.below(), &slices.above()};
        Rows rows;
        for (std::size_t row = 0; row < 9; ++row)
            rows[row] = around[row / 3]->pair_row(j + static_cast<int>(row % 3) - 1);
        note_crossings(rows);
        for (std::size_t first = 0; first < beside_crossing_.size(); first += kWord)
        {
            std::uint64_t word = 0;
            std::memcpy(&word, beside_crossing_.data() + first, kWord);
            for (std::size_t at = first; word != 0 && at < first + kWord; ++at)
                if (beside_crossing_[at] != 0)
                    visit_sample({static_cast<int>(at), j, slices.k()}, code_at(rows, at));
        }
    }

    //! Which samples of a row have another side than one of the six joined to them. Rows begin at the column
    //! before.
    void note_crossings(const Rows& rows)
    {
        // Local variables, for the loop to be done with vectors.
        const auto count = static_cast<std::size_t>(size_[0]);
        const auto [r0, below, r2, before, row, after, r6, above, r8] = rows;
        std::uint8_t* beside_crossing = beside_crossing_.data();
        for (std::size_t at = 0; at < count; ++at)
        {
            const unsigned here = row[at];
            const unsigned differ = (here ^ here << 1U) | (here ^ row[at + 1]) | (here ^ before[at]) |
                                    (here ^ after[at]) | (here ^ below[at]) | (here ^ above[at]);
            beside_crossing[at] = static_cast<std::uint8_t>(differ & 2U);
        }
    }

    void visit_sample(const std::array<int, 3>& index, NeighborhoodCode code)
    {
        if (!is_simple_center(code))
            add(index, code);
    }

    static NeighborhoodCode code_at(const Rows& rows, std::size_t at)
    {
        NeighborhoodCode code = 0;
        for (std::size_t row = 0; row < 9; ++row)
            code |= static_cast<NeighborhoodCode>(rows[row][at] | (rows[row][at + 1] & 2U) << 1U) << 3 * row;
        return code;
    }

    void add(const std::array<int, 3>& index, NeighborhoodCode code)
    {
        const bool inside = (code >> kCenterBit & 1U) != 0;
        std::vector<Point3> ends;
        std::vector<Region> beside;
        for (std::size_t n = 0; n < 6; ++n)
        {
            std::array<int, 3> next = index;
            next[n / 2] += n % 2 == 0 ? -1 : 1;
            if (((code >> kEdgeNeighbors[n] & 1U) != 0) != inside)
                beside.push_back(necks_.region(next));
            else if (next[n / 2] >= 0 && next[n / 2] < size_[n / 2])
                ends.push_back(necks_.at(next));
        }
        if (!ends.empty())
            necks_.add(necks_.at(index), necks_.region(index), std::move(ends), beside);
    }

    static constexpr std::size_t kWord = sizeof(std::uint64_t);

    std::array<int, 3> size_;
    Necks& necks_;
    std::vector<std::uint8_t> beside_crossing_; //!< by sample of the row, and zeros up to a whole word
};

} // namespace

std::vector<Neck> find_necks(const HeightField& field, const Inventory& inventory)
{
    const LatticeFrame frame = field.frame();
    static constexpr Run kBeyondBorder{0, kOuterRegion};
    Necks necks(frame, inventory);
    SaddleSearch saddles(necks);
    CellSweep sweep(inventory.runs(), &kBeyondBorder, [&](SweptCell& cell) { saddles.visit(cell); });
    SliceWindow window(field, -1);
    sweep.sweep(window);
    SampleSearch samples(frame.sample_count, necks);
    for (int k = 0; k < frame.sample_count[2]; ++k)
    {
        window.move_up();
        sweep.sweep(window);
        samples.visit_slice(window);
    }
    return std::move(necks).take();
}

} // namespace voroprobe
