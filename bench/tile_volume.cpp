// Writes a volume N x N x N times side by side into one raw NRRD file: scans as large as one likes.
#include <array>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <variant>
#include <vector>

#include <CLI/CLI.hpp>

#include "bench/run_program.h"
#include "io/volume_reader.h"
#include "support/error.h"

namespace voroprobe::bench
{
namespace
{

struct Options
{
    std::string volume;
    std::size_t count = 2;
    std::string output;
};

//! Sample type as NRRD calls it.
std::string_view nrrd_type_name(const SampleArray& samples)
{
    const std::string_view name = sample_type_name(samples);
    if (name == "float32")
        return "float";
    return name == "float64" ? "double" : name;
}

void write_vector(std::ostream& out, const Vec3& v)
{
    out << '(' << v.x << ',' << v.y << ',' << v.z << ')';
}

//! The first sample stays where it is in the world.
void write_header(std::ostream& out, const Volume& volume, std::size_t count)
{
    const GridGeometry& geometry = volume.geometry;
    const auto [columns, rows, slices] = geometry.size;
    const AffineTransform& world_from_grid = geometry.world_from_grid;
    const Point3 origin = world_from_grid * Point3{0, 0, 0};
    out.precision(17);
    out << "NRRD0004\ntype: " << nrrd_type_name(volume.samples)
        << "\ndimension: 3\nsizes: " << count * columns << ' ' << count * rows << ' ' << count * slices
        << "\nencoding: raw\nendian: little\nspace: left-posterior-superior\nspace directions: ";
    const Vec3& spacing = geometry.spacing;
    for (const Point3& step : {Point3{spacing.x, 0, 0}, Point3{0, spacing.y, 0}, Point3{0, 0, spacing.z}})
    {
        write_vector(out, world_from_grid * step - origin);
        out << ' ';
    }
    out << "\nspace origin: ";
    write_vector(out, Vec3{origin.x, origin.y, origin.z});
    out << "\n\n";
}

template <typename Sample>
void write_samples(std::ostream& out, const std::vector<Sample>& samples,
                   const std::array<std::size_t, 3>& size, std::size_t count)
{
    const auto [columns, rows, slices] = size;
    for (std::size_t slice = 0; slice < count * slices; ++slice)
        for (std::size_t row = 0; row < count * rows; ++row)
        {
            const Sample* begin = samples.data() + ((slice % slices) * rows + row % rows) * columns;
            for (std::size_t i = 0; i < count; ++i)
                out.write(reinterpret_cast<const char*>(begin),
                          static_cast<std::streamsize>(columns * sizeof(Sample)));
        }
}

void tile(const Options& options)
{
    const Volume volume = read_volume(options.volume).volume;
    std::ofstream file(options.output, std::ios::binary);
    write_header(file, volume, options.count);
    std::visit([&](const auto& samples)
               { write_samples(file, samples, volume.geometry.size, options.count); },
               volume.samples);
    if (!file.flush())
        throw OutputError(options.output + ": cannot be written");
}

} // namespace
} // namespace voroprobe::bench

int main(int argc, char** argv)
{
    voroprobe::bench::Options options;
    CLI::App app("Writes a volume N x N x N times side by side into one NRRD file");
    app.add_option("VOLUME", options.volume)->required();
    app.add_option("COUNT", options.count, "N")->required()->check(CLI::Range(1, 64));
    app.add_option("OUTPUT", options.output, "NRRD file; N^3 times the samples, in their own type")
        ->required();
    CLI11_PARSE(app, argc, argv);
    return voroprobe::bench::run_program("bench_tile_volume",
                                         [&]
                                         {
                                             voroprobe::bench::tile(options);
                                             return 0;
                                         });
}
