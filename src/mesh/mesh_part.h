#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! A colour as screens show it (sRGB).
struct Color
{
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;

    friend bool operator==(const Color&, const Color&) = default;
};

//! One of the objects that a file can hold beside one another.
struct MeshPart
{
    std::string name; //!< UTF-8; may be empty
    std::optional<Color> color = std::nullopt;
    TriangleMesh mesh;
};

//! All parts in one mesh, one after another; none of their vertices become one.
TriangleMesh merged(std::span<const MeshPart> parts);

} // namespace voroprobe
