#pragma once

#include <cstddef>

namespace voroprobe
{

//! Peak resident memory of this process so far, bytes; 0 where the system does not tell.
std::size_t peak_memory_bytes();

//! Memory of this machine, bytes; 0 where the system does not tell. Readers refuse volumes that exceed it.
std::size_t total_memory_bytes();

} // namespace voroprobe
