#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "geometry/box3.h"

//! What the JSON of all commands is made of.
namespace voroprobe
{

//! [x, y, z]
nlohmann::ordered_json json_of(const Vec3& v);

//! {"min": [x, y, z], "max": [x, y, z]}
nlohmann::ordered_json json_of(const Box3& box);

template <typename Value>
nlohmann::ordered_json value_or_null(const std::optional<Value>& value)
{
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

//! For json_text: everything on one line.
inline constexpr int kOneLine = -1;

//! JSON as text, lines indented by so many blanks. Bytes that are no UTF-8, which names of files may hold,
//! become U+FFFD.
std::string json_text(const nlohmann::ordered_json& json, int indentation = 2);

} // namespace voroprobe
