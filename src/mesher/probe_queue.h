#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "mesher/delaunay.h"

namespace voroprobe
{

//! Q: the vertices whose Voronoi cells were not probed yet, largest first. A cell that insertions have shrunk
//! keeps its old size until it comes up, and is put back then with its new one: sizes only shrink, so the
//! order of the cells that leave is exact. Cells of one size leave in the order of their vertices' indices.
class ProbeQueue
{
public:
    void push(VertexHandle vertex, double size)
    {
        entries_.push_back({size, vertex->info().index, vertex});
        std::push_heap(entries_.begin(), entries_.end());
    }

    [[nodiscard]] bool empty() const { return entries_.empty(); }
    [[nodiscard]] std::size_t size() const { return entries_.size(); }

    //! Takes the largest cell; `size_now` gives the size of a vertex's cell as it is. \pre Not empty. Cost:
    //! O(log n), and as often again as cells have shrunk.
    template <typename SizeNow>
    VertexHandle pop(SizeNow size_now)
    {
        while (true)
        {
            std::pop_heap(entries_.begin(), entries_.end());
            Entry entry = entries_.back();
            entries_.pop_back();
            entry.size = std::min(entry.size, size_now(entry.vertex));
            if (entries_.empty() || !(entry < entries_.front()))
                return entry.vertex;
            entries_.push_back(entry);
            std::push_heap(entries_.begin(), entries_.end());
        }
    }

private:
    struct Entry
    {
        double size;
        std::uint32_t index;
        VertexHandle vertex;

        friend bool operator<(const Entry& a, const Entry& b)
        {
            return a.size != b.size ? a.size < b.size : a.index > b.index;
        }
    };
    std::vector<Entry> entries_; //!< a heap
};

} // namespace voroprobe
