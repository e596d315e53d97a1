#include "cli/json_values.h"

namespace voroprobe
{

using Json = nlohmann::ordered_json;

Json json_of(const Vec3& v)
{
    return Json::array({v.x, v.y, v.z});
}

Json json_of(const Box3& box)
{
    return {{"min", json_of(box.min)}, {"max", json_of(box.max)}};
}

std::string json_text(const Json& json, int indentation)
{
    return json.dump(indentation, ' ', false, Json::error_handler_t::replace);
}

} // namespace voroprobe
