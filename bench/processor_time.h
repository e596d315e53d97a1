#pragma once

namespace voroprobe::bench
{

//! Processor time of this process, all its threads, and of the processes it has waited for.
double processor_seconds();

} // namespace voroprobe::bench
