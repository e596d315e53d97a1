#pragma once

#include <cstddef>
#include <functional>

namespace voroprobe
{

//! Splits {0, ..., slices - 1} into slabs and calls `work(begin, end)` for each, several at once. `threads`:
//! 0 for all there are; with 1 there is one slab. Exceptions of `work` come out.
void for_each_slab(std::size_t slices, std::size_t threads,
                   const std::function<void(std::size_t begin, std::size_t end)>& work);

} // namespace voroprobe
