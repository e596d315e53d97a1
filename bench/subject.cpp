#include "bench/subject.h"

#include <cmath>
#include <cstdlib>

#include "io/volume_reader.h"
#include "volume/phantoms.h"

namespace voroprobe::bench
{

namespace
{

std::filesystem::path data_folder()
{
    if (const char* folder = std::getenv("VOROPROBE_DATA"))
        return folder;
    return std::filesystem::path(VOROPROBE_SOURCE_DIR) / ".." / "shared" / "data";
}

} // namespace

Subject make_phantom(std::size_t side)
{
    constexpr double kHalfWidth = 2.5;
    const double scale = 2.0 * kHalfWidth / static_cast<double>(side - 1);
    const auto level = [scale](const Point3& p_grid)
    {
        const Vec3 p = scale * p_grid - Vec3{kHalfWidth, kHalfWidth, kHalfWidth};
        return -(squared_norm(p) + std::sin(4 * p.x) + std::sin(4 * p.y) + std::sin(4 * p.z));
    };
    return {sample_volume(level, {side, side, side}, {1, 1, 1}), 0.0,
            "phantom of " + std::to_string(side) + "^3 samples", std::nullopt};
}

Subject read_subject(const std::filesystem::path& file, double isovalue)
{
    return {read_volume(file).volume, isovalue, file.filename().string(), file};
}

Subject read_default_subject(std::optional<double> isovalue)
{
    const auto cranium = data_folder() / "cranium_ct.nrrd";
    if (std::filesystem::exists(cranium))
        return read_subject(cranium, isovalue.value_or(226.5));
    return read_shipped_subject(isovalue);
}

Subject read_shipped_subject(std::optional<double> isovalue)
{
    const auto shipped = std::filesystem::path(VOROPROBE_SOURCE_DIR) / "testdata" / "headsq_ct.nrrd";
    return read_subject(shipped, isovalue.value_or(1150.5));
}

} // namespace voroprobe::bench
