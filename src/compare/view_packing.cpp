// The byte order of a packed mesh, little-endian throughout:
//   vertices, faces                      2 x uint32
//   lowest corner, extent of the box     6 x float64
//   places                               for x, y, z: low bytes, then high bytes, of differences of 16-bit
//   numbers corners                              varint of (vertices used so far - corner), so that a new
//   vertex is 0 smallest angles, quarter degrees     1 byte a face distances, 1/255 of the longest      1
//   byte a face pieces                               varint of the zigzag difference to the face before
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string_view>

#include <zlib.h>

#include "compare/view_mesh.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

constexpr double kMostPlaces = 65535.0;
constexpr double kAngleSteps = 4.0; // a degree
constexpr std::uint32_t kUnused = 0xFFFFFFFFU;

template <typename Number>
void append_number(std::string& bytes, Number number)
{
    char buffer[sizeof number];
    std::memcpy(buffer, &number,
                sizeof number); // this project's formats are read where they are written: little-endian
    bytes.append(buffer, sizeof number);
}

void append_varint(std::string& bytes, std::uint32_t number)
{
    for (; number >= 0x80U; number >>= 7U)
        bytes.push_back(static_cast<char>(0x80U | (number & 0x7FU)));
    bytes.push_back(static_cast<char>(number));
}

//! Small numbers of either sign become small numbers.
std::uint32_t zigzag(std::int64_t number)
{
    return static_cast<std::uint32_t>(number < 0 ? -2 * number - 1 : 2 * number);
}

std::array<std::uint16_t, 3> rounded_place(const Point3& p, const Box3& box)
{
    std::array<std::uint16_t, 3> place{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const double extent = box.extent()[axis];
        const double share = extent > 0.0 ? (p[axis] - box.min[axis]) / extent : 0.0;
        place[axis] = static_cast<std::uint16_t>(std::lround(std::clamp(share, 0.0, 1.0) * kMostPlaces));
    }
    return place;
}

//! Bits of the three numbers in turn: neighbours in space are mostly neighbours in this order (Morton 1966).
std::uint64_t morton_code(const std::array<std::uint16_t, 3>& place)
{
    std::uint64_t code = 0;
    for (unsigned bit = 16; bit-- > 0;)
        for (std::size_t axis = 0; axis < 3; ++axis)
            code = code << 1U | (static_cast<std::uint64_t>(place[axis]) >> bit & 1U);
    return code;
}

std::vector<std::uint32_t> faces_along_curve(const TriangleMesh& mesh, const Box3& box)
{
    std::vector<std::uint64_t> code;
    code.reserve(mesh.faces.size());
    for (const TriangleMesh::Face& face : mesh.faces)
        code.push_back(morton_code(
            rounded_place((mesh.corner(face, 0) + mesh.corner(face, 1) + mesh.corner(face, 2)) / 3.0, box)));
    std::vector<std::uint32_t> order(mesh.faces.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return code[a] < code[b]; });
    return order;
}

class Packing
{
public:
    Packing(const ViewMesh& view, double longest_distance)
        : view_(view), longest_distance_(longest_distance), box_(bounding_box(view.mesh)),
          order_(faces_along_curve(view.mesh, box_)), number_(view.mesh.vertices.size(), kUnused)
    {
    }

    std::string run()
    {
        const std::string corners = packed_corners(); // settles the order of the vertices
        append_number(bytes_, static_cast<std::uint32_t>(used_.size()));
        append_number(bytes_, static_cast<std::uint32_t>(order_.size()));
        for (const Vec3& v : {box_.min, box_.extent()})
            for (std::size_t axis = 0; axis < 3; ++axis)
                append_number(bytes_, v[axis]);
        append_places();
        bytes_ += corners;
        append_facts();
        return std::move(bytes_);
    }

private:
    std::string packed_corners()
    {
        std::string corners;
        for (const std::uint32_t face : order_)
            for (const std::uint32_t vertex : view_.mesh.faces[face])
            {
                if (number_[vertex] == kUnused)
                {
                    number_[vertex] = static_cast<std::uint32_t>(used_.size());
                    append_varint(corners, 0);
                    used_.push_back(vertex);
                }
                else
                    append_varint(corners, static_cast<std::uint32_t>(used_.size()) - number_[vertex]);
            }
        return corners;
    }

    void append_places()
    {
        std::vector<std::array<std::uint16_t, 3>> places;
        places.reserve(used_.size());
        for (const std::uint32_t vertex : used_)
            places.push_back(rounded_place(view_.mesh.vertices[vertex], box_));
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            std::string high;
            std::uint16_t before = 0;
            for (const auto& place : places)
            {
                const auto step = static_cast<std::uint16_t>(place[axis] - before);
                before = place[axis];
                bytes_.push_back(static_cast<char>(step & 0xFFU));
                high.push_back(static_cast<char>(step >> 8U));
            }
            bytes_ += high;
        }
    }

    void append_facts()
    {
        for (const std::uint32_t face : order_)
            append_byte(view_.smallest_angles_deg[face] * kAngleSteps);
        for (const std::uint32_t face : order_)
            append_byte(view_.distances[face] / longest_distance_ * 255.0);
        std::int64_t before = 0;
        for (const std::uint32_t face : order_)
        {
            append_varint(bytes_, zigzag(view_.pieces[face] - before));
            before = view_.pieces[face];
        }
    }

    void append_byte(double number)
    {
        bytes_.push_back(static_cast<char>(std::lround(std::clamp(number, 0.0, 255.0))));
    }

    const ViewMesh& view_;
    double longest_distance_;
    Box3 box_;
    std::vector<std::uint32_t> order_;  //!< of the faces
    std::vector<std::uint32_t> number_; //!< of a vertex, in the order of first use
    std::vector<std::uint32_t> used_;   //!< vertices by their numbers
    std::string bytes_;
};

std::string deflated(const std::string& bytes)
{
    uLongf length = compressBound(bytes.size());
    std::string packed(length, '\0');
    constexpr int kLevel = 6; // zlib's own; 9 gains a percent in twice the time
    if (compress2(reinterpret_cast<Bytef*>(packed.data()), &length,
                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), kLevel) != Z_OK)
        throw Error(ExitStatus::kBudget, "out of memory while a mesh was packed for the page");
    packed.resize(length);
    return packed;
}

} // namespace

std::string base64(std::string_view bytes)
{
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve(4 * (bytes.size() + 2) / 3);
    for (std::size_t at = 0; at < bytes.size(); at += 3)
    {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
        std::uint32_t group = 0;
        for (std::size_t i = 0; i < 3; ++i)
            group = group << 8U | (i < count ? static_cast<unsigned char>(bytes[at + i]) : 0U);
        for (std::size_t i = 0; i < 4; ++i)
            text.push_back(i <= count ? kDigits[group >> (18U - 6U * i) & 0x3FU] : '=');
    }
    return text;
}

std::string pack(const ViewMesh& view, double longest_distance)
{
    return base64(deflated(Packing(view, longest_distance).run()));
}

} // namespace voroprobe
