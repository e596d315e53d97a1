#include "cli/info_text.h"

#include <nlohmann/json.hpp>

#include "cli/json_values.h"
#include "cli/number_text.h"

namespace voroprobe
{

namespace
{

//! Below this the axes of a file are called parallel to the world's: direction cosines come with about six
//! digits.
constexpr double kParallelDeg = 0.01;

std::string orientation_text(const Matrix3& direction)
{
    const double oblique = obliqueness_deg(direction);
    return orientation_letters(direction) + " (where the file's axes run), " +
           (oblique > kParallelDeg ? "oblique by up to " + number_text(oblique) + " deg"
                                   : "parallel to the world's axes") +
           (determinant(direction) < 0.0 ? ", left-handed" : "");
}

Vec3 extent_of(const FileLattice& lattice)
{
    Vec3 extent;
    for (std::size_t axis = 0; axis < 3; ++axis)
        extent[axis] = lattice.spacing[axis] * static_cast<double>(lattice.size[axis]);
    return extent;
}

} // namespace

std::string info_line(const std::string& title, const std::string& text)
{
    constexpr std::size_t kTitleWidth = 12;
    return "  " + title + std::string(kTitleWidth - title.size(), ' ') + text + '\n';
}

std::string size_text(const std::array<std::size_t, 3>& size)
{
    return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]);
}

std::string lattice_lines(const FileLattice& lattice)
{
    return info_line("size", size_text(lattice.size) + " voxels") +
           info_line("spacing", triple_text(lattice.spacing) + " mm, extent " +
                                    triple_text(extent_of(lattice)) + " mm") +
           info_line("orientation", orientation_text(lattice.direction)) +
           info_line("origin", triple_text(lattice.origin, ", ") + " mm (lps)");
}

nlohmann::ordered_json lattice_json(const std::string& path, const std::string& format,
                                    const std::string& stored_type, const FileLattice& lattice)
{
    const auto& columns = lattice.direction.column;
    return {{"path", path},
            {"format", format},
            {"type", stored_type},
            {"size", lattice.size},
            {"spacing", json_of(lattice.spacing)},
            {"direction", {json_of(columns[0]), json_of(columns[1]), json_of(columns[2])}},
            {"origin", json_of(lattice.origin)},
            {"orientation", orientation_letters(lattice.direction)}};
}

} // namespace voroprobe
