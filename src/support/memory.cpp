#include "support/memory.h"

#include <sys/resource.h>
#include <unistd.h>

namespace voroprobe
{

std::size_t peak_memory_bytes()
{
    rusage usage{};
    if (getrusage(RUSAGE_SELF, &usage) != 0)
        return 0;
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024; // Linux counts kilobytes
}

std::size_t total_memory_bytes()
{
    const long pages = sysconf(_SC_PHYS_PAGES);
    const long page_bytes = sysconf(_SC_PAGE_SIZE);
    if (pages <= 0 || page_bytes <= 0)
        return 0;
    return static_cast<std::size_t>(pages) * static_cast<std::size_t>(page_bytes);
}

} // namespace voroprobe
