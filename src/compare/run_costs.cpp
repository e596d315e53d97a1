#include "compare/run_costs.h"

#include <malloc.h>
#include <nlohmann/json.hpp>

#include "support/memory.h"

namespace voroprobe
{

namespace
{

using Json = nlohmann::ordered_json;

Json time_json(const std::vector<Stage>& stages)
{
    Json list = Json::array();
    double cpu = 0.0;
    double wall = 0.0;
    for (const Stage& stage : stages)
    {
        list.push_back(
            {{"name", stage.name}, {"cpu_seconds", stage.cpu_seconds}, {"wall_seconds", stage.wall_seconds}});
        cpu += stage.cpu_seconds;
        wall += stage.wall_seconds;
    }
    return {{"cpu_seconds", cpu}, {"wall_seconds", wall}, {"stages", list}};
}

} // namespace

RunCosts::RunCosts() : peak_before_((malloc_trim(0), peak_memory_bytes())) {}

nlohmann::ordered_json RunCosts::end()
{
    Json time = time_json(clock_.end());
    return {{"time", std::move(time)}, {"peak_memory_bytes", peak_memory_bytes() - peak_before_}};
}

} // namespace voroprobe
