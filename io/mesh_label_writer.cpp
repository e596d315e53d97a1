#include "io/mesh_label_writer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <limits>
#include <ostream>
#include <string_view>

#include "io/atomic_file.h"
#include "io/float_rounding.h"
#include "support/check.h"
#include "support/error.h"

namespace voroprobe
{
namespace
{

constexpr Color kGrey{.red = 192, .green = 192, .blue = 192};

//! One line, whatever a name holds.
std::string one_line(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < ' '; }, ' ');
    return text;
}

//! As the name of a group, where blanks would make several of it.
std::string one_word(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c <= ' '; }, '_');
    return text;
}

//! The fewest digits that give back the very float.
std::string_view digits_of(float value, std::array<char, 32>& room)
{
    const auto [end, error] = std::to_chars(room.data(), room.data() + room.size(), value);
    CHECK(error == std::errc{});
    return {room.data(), static_cast<std::size_t>(end - room.data())};
}

void write_obj(std::span<const MeshPart> parts, std::span<const std::int64_t> labels, std::ostream& out,
               const std::vector<std::string>& comments)
{
    std::array<char, 32> room{};
    for (const std::string& comment : comments)
        out << "# " << one_line(comment) << '\n';
    std::size_t offset = 1;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
        out << "g label_" << labels[i] << ' ' << one_word(parts[i].name) << '\n';
        for (const Point3& p : parts[i].mesh.vertices)
        {
            out << 'v';
            for (const double x : {p.x, p.y, p.z})
                out << ' ' << digits_of(static_cast<float>(x), room);
            if (const auto& color = parts[i].color)
                for (const std::uint8_t channel : {color->red, color->green, color->blue})
                    out << ' ' << digits_of(static_cast<float>(channel) / 255.0F, room);
            out << '\n';
        }
        for (const TriangleMesh::Face& face : parts[i].mesh.faces)
            out << "f " << face[0] + offset << ' ' << face[1] + offset << ' ' << face[2] + offset << '\n';
        offset += parts[i].mesh.vertices.size();
    }
}

//! Numbers as PLY files store them: little-endian.
class LittleEndianBytes
{
public:
    explicit LittleEndianBytes(std::ostream& out) : out_(out) {}

    template <class Number>
    void write(Number number)
    {
        auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
        if constexpr (std::endian::native == std::endian::big)
            std::reverse(bytes.begin(), bytes.end());
        out_.write(bytes.data(), bytes.size());
    }

private:
    std::ostream& out_;
};

std::string ply_header(std::span<const MeshPart> parts, std::span<const std::int64_t> labels,
                       const std::vector<std::string>& comments)
{
    std::size_t vertices = 0;
    std::size_t faces = 0;
    std::string header = "ply\nformat binary_little_endian 1.0\n";
    for (const std::string& comment : comments)
        header += "comment " + one_line(comment) + '\n';
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
        header += "comment label " + std::to_string(labels[i]) + ' ' + one_line(parts[i].name) + '\n';
        vertices += parts[i].mesh.vertices.size();
        faces += parts[i].mesh.faces.size();
    }
    return header + "element vertex " + std::to_string(vertices) +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(faces) +
           "\nproperty list uchar int vertex_indices\nproperty int label\nproperty uchar red\nproperty uchar "
           "green\nproperty uchar blue\nend_header\n";
}

void write_ply(std::span<const MeshPart> parts, std::span<const std::int64_t> labels, std::ostream& out,
               const std::vector<std::string>& comments)
{
    out << ply_header(parts, labels, comments);
    LittleEndianBytes bytes(out);
    for (const MeshPart& part : parts)
        for (const Point3& p : part.mesh.vertices)
            for (const double x : {p.x, p.y, p.z})
                bytes.write(static_cast<float>(x));
    std::uint32_t offset = 0;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
        const Color color = parts[i].color.value_or(kGrey);
        for (const TriangleMesh::Face& face : parts[i].mesh.faces)
        {
            bytes.write(std::uint8_t{3});
            for (const std::uint32_t v : face)
                bytes.write(static_cast<std::int32_t>(v + offset));
            bytes.write(static_cast<std::int32_t>(labels[i]));
            for (const std::uint8_t channel : {color.red, color.green, color.blue})
                bytes.write(channel);
        }
        offset += static_cast<std::uint32_t>(parts[i].mesh.vertices.size());
    }
}

void check_size(std::span<const MeshPart> parts, std::span<const std::int64_t> labels, MeshFormat format,
                const std::filesystem::path& path)
{
    constexpr auto kMost = std::numeric_limits<std::int32_t>::max();
    std::size_t vertices = 0;
    for (const MeshPart& part : parts)
        vertices += part.mesh.vertices.size();
    if (vertices > std::size_t{kMost})
        throw OutputError("cannot write '" + path.string() + "': the meshes have " +
                          std::to_string(vertices) + " vertices; at most 2147483647 can be written");
    for (const std::int64_t label : labels)
        if (format == MeshFormat::kPly && (label > kMost || label < std::numeric_limits<std::int32_t>::min()))
            throw OutputError("cannot write '" + path.string() + "': label " + std::to_string(label) +
                              " is no number of 32 bits, as PLY stores them; allowed: .obj or .3mf");
}

} // namespace

bool holds_labels(MeshFormat format)
{
    return format == MeshFormat::k3mf || format == MeshFormat::kObj || format == MeshFormat::kPly;
}

WriteReport write_labels(std::span<const MeshPart> parts, std::span<const std::int64_t> labels,
                         const std::filesystem::path& path, MeshFormat format,
                         const std::vector<std::string>& comments, const std::function<void()>& last_look)
{
    CHECK(holds_labels(format));
    CHECK_EQ(parts.size(), labels.size());
    if (format == MeshFormat::k3mf)
        return write_parts(parts, path, comments, last_look);
    check_size(parts, labels, format, path);
    WriteReport report;
    std::vector<MeshPart> stored;
    for (const MeshPart& part : parts)
    {
        FloatRounding rounding = round_to_float(part.mesh);
        report.vertices_nudged += rounding.vertices_nudged;
        stored.push_back({.name = part.name, .color = part.color, .mesh = std::move(rounding.mesh)});
    }
    write_atomically(path, last_look,
                     [&](std::ostream& out)
                     {
                         if (format == MeshFormat::kObj)
                             write_obj(stored, labels, out, comments);
                         else
                             write_ply(stored, labels, out, comments);
                     });
    return report;
}

} // namespace voroprobe
