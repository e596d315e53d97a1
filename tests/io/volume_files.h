#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

//! Volume files written byte by byte from the definitions of their formats, so that a reader is not tested
//! with its own writer, and so that they can be spoiled on purpose.
namespace voroprobe
{

constexpr std::endian kLittle = std::endian::little;
constexpr std::endian kBig = std::endian::big;

//! The bytes of a number in the given order.
template <class Number>
std::string to_bytes(Number number, std::endian order)
{
    std::string bytes(sizeof(Number), '\0');
    std::memcpy(bytes.data(), &number, sizeof(Number));
    if (order != std::endian::native)
        std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

template <class Number>
std::string to_bytes(const std::vector<Number>& numbers, std::endian order)
{
    std::string bytes;
    for (const Number number : numbers)
        bytes += to_bytes(number, order);
    return bytes;
}

std::string gzip_of(const std::string& content);
std::string zlib_of(const std::string& content);
std::string gunzip_of(const std::string& packed);

//! Lines "name: value" and so on, each closed by a newline.
std::string lines(const std::vector<std::string>& text);

struct NiftiHeader
{
    std::vector<std::int16_t> size{6, 5, 4};
    std::int16_t datatype = 4; //!< int16
    std::array<float, 3> spacing{1, 1, 1};
    float slope = 0.0F;
    float intercept = 0.0F;
    std::vector<float> sform = {};      //!< three rows of four, or empty
    std::vector<float> quaternion = {}; //!< b, c, d and the offset of the qform, or empty
    std::endian order = std::endian::native;
};
std::string nifti_of(const NiftiHeader& header, const std::string& samples);

std::string nrrd_of(const std::vector<std::string>& fields, const std::string& samples);
std::string inrimage_of(const std::vector<std::string>& fields, const std::string& samples);

//! A VTK image with raw appended samples.
std::string vti_of(const std::string& extent, const std::string& array_attributes,
                   const std::string& image_attributes, const std::string& samples);

struct TiffPages
{
    std::uint16_t bits = 16;
    std::uint16_t format = 1; //!< 1 unsigned, 2 signed, 3 floating-point
    std::uint16_t samples_per_pixel = 1;
    std::uint32_t width = 6;
    std::uint32_t height = 5;
    std::endian order = std::endian::little;
    std::string description = {};
};
std::string tiff_of(const TiffPages& layout, const std::vector<std::string>& pages);

//! A CT slice of 16-bit samples in explicit little endian.
struct DicomSlice
{
    std::string series = "1.2.3.4";
    int instance = 1;
    std::array<double, 3> position{0, 0, 0};
    std::array<double, 6> orientation{1, 0, 0, 0, 1, 0};
    std::array<double, 2> pixel_spacing{1, 1}; //!< between rows, between columns
    std::uint16_t columns = 6;
    std::uint16_t rows = 5;
    double slope = 1.0;
    double intercept = 0.0;
    std::string further{}; //!< elements before the pixels, as they stand in the file
};
std::string dicom_of(const DicomSlice& slice, const std::vector<std::int16_t>& samples);

} // namespace voroprobe
