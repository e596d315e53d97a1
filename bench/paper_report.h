#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace voroprobe::bench
{

//! What an experiment of the report came to.
struct Report
{
    std::string table; //!< for people
    nlohmann::json json;
    std::string svg;
    bool keeps_promises = true;
};

} // namespace voroprobe::bench
