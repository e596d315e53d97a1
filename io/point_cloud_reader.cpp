#include "io/point_cloud_reader.h"

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

#include "io/mesh_file.h"

namespace voroprobe
{
namespace
{

constexpr std::string_view kBlanks = " \t\r";

//! The first six numbers of a line; nullopt where it has fewer.
std::optional<OrientedPoint> parse_point(std::string_view line)
{
    std::array<double, 6> numbers{};
    for (double& number : numbers)
    {
        line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
        const std::string_view word = line.substr(0, line.find_first_of(kBlanks));
        const auto value = parse_number<double>(word);
        if (!value)
            return std::nullopt;
        number = *value;
        line.remove_prefix(word.size());
    }
    const auto& [x, y, z, nx, ny, nz] = numbers;
    return OrientedPoint{{x, y, z}, {nx, ny, nz}};
}

} // namespace

std::vector<OrientedPoint> read_point_cloud(const std::filesystem::path& path)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        fail_reading(path, "there is no such file");
    std::istringstream file(read_whole_file(path));
    std::vector<OrientedPoint> points;
    std::string line;
    for (std::size_t number = 1; std::getline(file, line); ++number)
    {
        const std::size_t first = line.find_first_not_of(kBlanks);
        if (first == std::string::npos || line[first] == '#')
            continue;
        const auto point = parse_point(line);
        if (!point)
            fail_reading(path, "line " + std::to_string(number) +
                                   " is not a point with a normal; expected six numbers: x y z nx ny nz");
        points.push_back(*point);
    }
    if (points.empty())
        fail_reading(path, "it holds no points");
    return points;
}

} // namespace voroprobe
