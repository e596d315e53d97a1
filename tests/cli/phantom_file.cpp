#include "phantom_file.h"

#include <fstream>

namespace voroprobe
{

namespace
{

std::ostream& operator<<(std::ostream& out, const Vec3& v)
{
    return out << v.x << ' ' << v.y << ' ' << v.z;
}

} // namespace

std::function<double(const Point3&)> ball(const Point3& center, double radius)
{
    return [=](const Point3& p_world) { return radius - distance(p_world, center); };
}

Phantom ball_phantom()
{
    Phantom phantom;
    phantom.field = ball({11.5, 11.5, 11.5}, 8.0);
    return phantom;
}

AffineTransform world_from_index(const Phantom& phantom)
{
    const auto& axis = phantom.direction.column;
    return {{{phantom.spacing.x * axis[0], phantom.spacing.y * axis[1], phantom.spacing.z * axis[2]}},
            phantom.origin};
}

void write_phantom(const Phantom& phantom, const std::filesystem::path& path)
{
    std::ofstream file(path, std::ios::binary);
    file.precision(17);
    // MetaImage lists the direction cosines axis by axis.
    file << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = "
            "False\nCompressedData = False\n"
         << "TransformMatrix = " << phantom.direction.column[0] << ' ' << phantom.direction.column[1] << ' '
         << phantom.direction.column[2] << "\nOffset = " << phantom.origin
         << "\nElementSpacing = " << phantom.spacing << "\nDimSize = " << phantom.size[0] << ' '
         << phantom.size[1] << ' ' << phantom.size[2]
         << "\nElementType = MET_FLOAT\nElementDataFile = LOCAL\n";
    const AffineTransform to_world = world_from_index(phantom);
    for (std::size_t k = 0; k < phantom.size[2]; ++k)
        for (std::size_t j = 0; j < phantom.size[1]; ++j)
            for (std::size_t i = 0; i < phantom.size[0]; ++i)
            {
                const Point3 p_index{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
                const auto sample = static_cast<float>(phantom.field(to_world * p_index));
                file.write(reinterpret_cast<const char*>(&sample), sizeof(sample));
            }
}

} // namespace voroprobe
