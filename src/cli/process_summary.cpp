#include "cli/process_summary.h"

#include <nlohmann/json.hpp>

#include "cli/json_values.h"
#include "cli/number_text.h"

namespace voroprobe
{

namespace
{

using Json = nlohmann::ordered_json;

Json json_of(const StepFacts& facts)
{
    return {{"vertices", facts.vertices},
            {"faces", facts.faces},
            {"components", facts.topology.components},
            {"euler_characteristic", facts.topology.euler_characteristic},
            {"closed", facts.topology.closed()},
            {"manifold", facts.topology.manifold()},
            {"oriented", facts.topology.oriented()},
            {"self_intersections", facts.self_intersections},
            {"flat_faces", facts.flat_faces},
            {"min_angle_deg", facts.angles.min_deg},
            {"mean_min_angle_deg", facts.angles.mean_min_deg},
            {"area_mm2", facts.area_mm2},
            {"volume_mm3", facts.volume_mm3},
            {"box", json_of(facts.box)}};
}

Json json_of(const StepReport& step)
{
    Json result{{"step", step.name},
                {"object", step.part},
                {"done", step.done},
                {"before", json_of(step.before)},
                {"after", json_of(step.after)}};
    if (step.deviation)
        result["distance"] = {{"max_mm", step.deviation->max},
                              {"max_at", json_of(step.deviation->max_at)},
                              {"mean_mm", step.deviation->mean},
                              {"allowed_mm", value_or_null(step.max_distance)}};
    result["seconds"] = step.seconds;
    return result;
}

} // namespace

std::string facts_text(const StepFacts& facts)
{
    return count_text(facts.vertices) + " vertices" + ", " + plural_text(facts.faces, "face") + ", " +
           plural_text(facts.topology.components, "piece") + ", " +
           (facts.topology.closed() ? "closed" : "open") + ", " + crossings_text(facts) +
           ", smallest angle " + number_text(facts.angles.min_deg) + " deg (mean " +
           number_text(facts.angles.mean_min_deg) + "), volume " + number_text(facts.volume_mm3) + " mm3";
}

Json steps_json(const std::vector<StepReport>& steps)
{
    Json list = Json::array();
    for (const StepReport& step : steps)
        list.push_back(json_of(step));
    return list;
}

std::string process_json(const ProcessRun& run)
{
    Json written = Json::array();
    for (const auto& path : run.written)
        written.push_back(path.string());
    const Json result{{"version", VOROPROBE_VERSION},       {"status", run.wrong ? "incomplete" : "done"},
                      {"reason", value_or_null(run.wrong)}, {"input", run.arguments.mesh.string()},
                      {"objects_read", run.objects_read},   {"objects_written", run.objects_written},
                      {"before", json_of(run.before)},      {"steps", steps_json(run.steps)},
                      {"after", json_of(run.after)},        {"written", std::move(written)}};
    return json_text(result) + '\n';
}

} // namespace voroprobe
