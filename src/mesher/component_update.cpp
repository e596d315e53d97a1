#include "mesher/component_update.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace voroprobe
{
namespace
{

constexpr std::size_t kLongestSearch = 2'000; // Delaunay cells looked at around some that have changed
constexpr std::size_t kMostInPiece = 64;      // that has come apart
constexpr std::size_t kLeastInRest = 256;     // where a piece has

using Number = CellTable::Number;
constexpr auto kNoComponent = std::numeric_limits<std::uint32_t>::max();

class ComponentUpdate
{
public:
    ComponentUpdate(const CellTable& table, std::span<const Number> changed, RegionComponents& components)
        : table_(table), changed_(changed), components_(components), is_changed_(table.size(), false),
          marks_(table.size(), 0)
    {
    }

    bool run()
    {
        if (is_any_region_in_pieces())
            return false;
        components_.of_cell.resize(table_.size(), kNoComponent);
        for (const Number cell : changed_)
        {
            is_changed_[cell] = true;
            components_.of_cell[cell] = kNoComponent;
        }
        return std::all_of(changed_.begin(), changed_.end(),
                           [&](Number cell)
                           { return !is_changed_[cell] || update_around(take_changed_with(cell)); });
    }

private:
    //! Components that were given to other regions are still listed, but no longer hold their first cells.
    [[nodiscard]] bool is_any_region_in_pieces() const
    {
        const std::vector<bool> is_largest = largest_of_each_region(components_.components);
        for (std::uint32_t c = 0; c < is_largest.size(); ++c)
        {
            if (!is_largest[c] && components_.of_cell[components_.components[c].first] == c)
                return true;
        }
        return false;
    }

    //! The changed cells joined to this one, and those around them.
    std::vector<Number> take_changed_with(Number first)
    {
        std::vector<Number> cells{first};
        std::vector<Number> around;
        is_changed_[first] = false;
        for (std::size_t at = 0; at < cells.size(); ++at)
        {
            for (const Number next : table_.neighbors(cells[at]))
            {
                if (is_changed_[next])
                {
                    is_changed_[next] = false;
                    cells.push_back(next);
                }
                else if (components_.of_cell[next] != kNoComponent)
                    around.push_back(next);
            }
        }
        cells.insert(cells.end(), around.begin(), around.end());
        return cells;
    }

    bool update_around(std::vector<Number> cells)
    {
        std::sort(cells.begin(), cells.end(),
                  [&](Number a, Number b)
                  { return std::pair(table_.region(a), a) < std::pair(table_.region(b), b); });
        cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
        for (auto begin = cells.begin(); begin != cells.end();)
        {
            const auto end =
                std::find_if(begin, cells.end(),
                             [&](Number cell) { return table_.region(cell) != table_.region(*begin); });
            if (!update_region({begin, end}))
                return false;
            begin = end;
        }
        return true;
    }

    //! `cells`: of one region, the changed ones and those around them. Each set of them that is joined is the
    //! rest of the region, at most one of them, or a piece.
    bool update_region(std::span<const Number> cells)
    {
        const auto known =
            std::find_if(cells.begin(), cells.end(), [&](Number cell) { return is_known(cell); });
        if (known == cells.end())
            return false;
        const std::uint32_t component = components_.of_cell[*known];
        const auto is_other = [&](Number cell)
        { return is_known(cell) && components_.of_cell[cell] != component; };
        if (components_.of_cell[components_.components[component].first] != component ||
            std::any_of(cells.begin(), cells.end(), is_other))
            return false;
        begin_search(cells);
        std::vector<std::vector<Number>> pieces;
        bool found_rest = false;
        for (const Number cell : cells)
        {
            if (marks_[cell] > sought_)
                continue;
            std::vector<Number> joined;
            const End end = search(cell, pieces.empty() ? 0 : kLeastInRest, joined);
            if (end == End::kAllSeen && joined.size() <= kMostInPiece)
                pieces.push_back(std::move(joined));
            else if (end == End::kAllSeen || (end == End::kStopped && std::exchange(found_rest, true)))
                return false;
        }
        if (!found_rest)
            return false;
        for (const Number cell : cells)
            components_.of_cell[cell] = component;
        for (const std::vector<Number>& piece : pieces)
            add_component(piece);
        return true;
    }

    [[nodiscard]] bool is_known(Number cell) const { return components_.of_cell[cell] != kNoComponent; }

    void add_component(const std::vector<Number>& cells)
    {
        const auto component = static_cast<std::uint32_t>(components_.components.size());
        components_.components.push_back({table_.region(cells.front()), 0.0, cells.front()});
        for (const Number cell : cells)
            components_.of_cell[cell] = component;
    }

    //! How a search has ended.
    enum class End
    {
        kAllSeen, //!< there are no more cells
        kStopped, //!< long enough, or with all wanted ones
        kMet      //!< at one that was reached before
    };

    void begin_search(std::span<const Number> wanted)
    {
        sought_ = ++last_mark_;
        for (const Number cell : wanted)
            marks_[cell] = sought_;
        missing_ = wanted.size();
    }

    //! Through cells of the region of the first one; `joined`: those reached, at least so many of them where
    //! all that are wanted have been.
    End search(Number first, std::size_t least, std::vector<Number>& joined)
    {
        const std::uint32_t own = ++last_mark_;
        const auto reach = [&](Number cell)
        {
            missing_ -= marks_[cell] == sought_ ? 1 : 0;
            marks_[cell] = own;
            joined.push_back(cell);
        };
        reach(first);
        for (std::size_t at = 0; at < joined.size(); ++at)
        {
            if (joined.size() >= kLongestSearch || (missing_ == 0 && joined.size() >= least))
                return End::kStopped;
            for (const Number next : table_.neighbors(joined[at]))
            {
                if (table_.region(next) != table_.region(first) || marks_[next] == own)
                    continue;
                if (marks_[next] > sought_)
                    return End::kMet;
                reach(next);
            }
        }
        return End::kAllSeen;
    }

    const CellTable& table_;
    std::span<const Number> changed_;
    RegionComponents& components_;
    std::vector<bool> is_changed_;
    std::vector<std::uint32_t> marks_;
    std::uint32_t last_mark_ = 0;
    std::uint32_t sought_ = 0; //!< a mark; those after it are of cells reached
    std::size_t missing_ = 0;  //!< of the cells sought
};

} // namespace

bool update_components(const CellTable& table, std::span<const CellTable::Number> changed,
                       RegionComponents& components)
{
    return ComponentUpdate(table, changed, components).run();
}

} // namespace voroprobe
