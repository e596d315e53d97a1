#pragma once

#include <cstring>
#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "compare/process_pool.h"

namespace voroprobe::bench
{

//! What `work` returns when it is run in a process of its own: plain data, it travels through a file.
//! \throw std::runtime_error where the child did not finish; names it and what ended it.
template <typename Record>
Record record_from_child(const std::string& name, const std::function<Record()>& work)
{
    static_assert(std::is_trivially_copyable_v<Record>);
    const ChildResult result = run_in_child(
        [&work](ChildOutput& output)
        {
            const Record record = work();
            output.send({reinterpret_cast<const char*>(&record), sizeof record});
        });
    if (result.failure || result.parts.size() != 1)
        throw std::runtime_error(name + " did not finish: " + result.failure.value_or("it sent nothing"));
    Record record;
    std::memcpy(&record, result.parts.front().data(), sizeof record);
    return record;
}

} // namespace voroprobe::bench
