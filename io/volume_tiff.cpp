// The format: TIFF 6.0 (Adobe, 1992) and BigTIFF, read with libtiff. ITK's TIFF reader is built on it too,
// but takes a file whose chain of pages breaks off for a shorter volume and turns unusual sample types into
// colors.

#include "io/volume_tiff.h"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <map>
#include <vector>

#include <tiffio.h>

#include "support/error.h"

namespace voroprobe
{

namespace
{

//! Tiles are a few hundred samples wide; a header that asks for more than this is hostile.
constexpr tmsize_t kMaxTileBytes = tmsize_t{1} << 30;

int keep_first_error(TIFF*, void* kept, const char*, const char* format, va_list arguments)
{
    std::string& error = *static_cast<std::string*>(kept);
    if (error.empty())
    {
        std::array<char, 256> text{};
        std::vsnprintf(text.data(), text.size(), format, arguments);
        error = text.data();
    }
    return 1;
}

int drop_warning(TIFF*, void*, const char*, const char*, va_list)
{
    return 1;
}

template <class Value>
Value field(const TiffFile& file, std::uint32_t tag, Value otherwise)
{
    Value value = otherwise;
    return TIFFGetFieldDefaulted(file.get(), tag, &value) == 1 ? value : otherwise;
}

StoredType stored_type(std::uint16_t bits, std::uint16_t sample_format)
{
    static const std::map<std::pair<int, int>, StoredType> kTypes{
        {{1, SAMPLEFORMAT_UINT}, StoredType::kUint8},     {{8, SAMPLEFORMAT_UINT}, StoredType::kUint8},
        {{16, SAMPLEFORMAT_UINT}, StoredType::kUint16},   {{32, SAMPLEFORMAT_UINT}, StoredType::kUint32},
        {{64, SAMPLEFORMAT_UINT}, StoredType::kUint64},   {{8, SAMPLEFORMAT_INT}, StoredType::kInt8},
        {{16, SAMPLEFORMAT_INT}, StoredType::kInt16},     {{32, SAMPLEFORMAT_INT}, StoredType::kInt32},
        {{64, SAMPLEFORMAT_INT}, StoredType::kInt64},     {{32, SAMPLEFORMAT_IEEEFP}, StoredType::kFloat32},
        {{64, SAMPLEFORMAT_IEEEFP}, StoredType::kFloat64}};
    const int format = sample_format == SAMPLEFORMAT_VOID ? SAMPLEFORMAT_UINT : sample_format;
    if (const auto found = kTypes.find({bits, format}); found != kTypes.end())
        return found->second;
    throw InputError("has samples of " + std::to_string(bits) + " bits in TIFF sample format " +
                     std::to_string(sample_format) +
                     ", expected 1, 8, 16, 32 or 64 bits, integer or floating-point");
}

//! Copies rows of `bits` bits per sample from a strip or tile to their place in a page, one byte for samples
//! of one bit.
struct RowCopy
{
    const PageLayout& layout;
    std::span<std::byte> page;

    void operator()(const std::byte* row, std::size_t x, std::size_t y, std::size_t count) const
    {
        const std::size_t sample_bytes = byte_size(layout.type);
        std::byte* to = page.data() + (y * layout.width + x) * sample_bytes;
        if (layout.bits != 1)
            std::copy_n(row, count * sample_bytes, to);
        else
            for (std::size_t i = 0; i < count; ++i)
                to[i] = (row[i / 8] >> (7 - i % 8)) & std::byte{1};
    }
};

[[noreturn]] void throw_unreadable_page(const TiffFile& file)
{
    throw InputError("page " + std::to_string(TIFFCurrentDirectory(file.get())) +
                     " cannot be read: " + file.error());
}

void read_strips(const TiffFile& file, const RowCopy& copy)
{
    const PageLayout& layout = copy.layout;
    const auto rows_per_strip = std::min(
        std::max(field<std::uint32_t>(file, TIFFTAG_ROWSPERSTRIP, layout.height), 1U), layout.height);
    const auto row_bytes = static_cast<std::size_t>(TIFFScanlineSize64(file.get()));
    std::vector<std::byte> strip(row_bytes * rows_per_strip);
    for (std::uint32_t first = 0; first < layout.height; first += rows_per_strip)
    {
        const std::size_t rows = std::min(rows_per_strip, layout.height - first);
        const auto expected = static_cast<tmsize_t>(rows * row_bytes);
        const std::uint32_t index = TIFFComputeStrip(file.get(), first, 0);
        if (TIFFReadEncodedStrip(file.get(), index, strip.data(), expected) != expected)
            throw_unreadable_page(file);
        for (std::size_t row = 0; row < rows; ++row)
            copy(strip.data() + row * row_bytes, 0, first + row, layout.width);
    }
}

void read_tiles(const TiffFile& file, const RowCopy& copy)
{
    const PageLayout& layout = copy.layout;
    const auto tile_width = field<std::uint32_t>(file, TIFFTAG_TILEWIDTH, 0);
    const auto tile_height = field<std::uint32_t>(file, TIFFTAG_TILELENGTH, 0);
    const tmsize_t tile_bytes = TIFFTileSize(file.get());
    if (tile_width == 0 || tile_height == 0 || tile_bytes <= 0 || tile_bytes > kMaxTileBytes)
        throw_unreadable_page(file);
    const auto row_bytes = static_cast<std::size_t>(TIFFTileRowSize(file.get()));
    std::vector<std::byte> tile(static_cast<std::size_t>(tile_bytes));
    for (std::uint32_t y = 0; y < layout.height; y += tile_height)
        for (std::uint32_t x = 0; x < layout.width; x += tile_width)
        {
            const std::uint32_t index = TIFFComputeTile(file.get(), x, y, 0, 0);
            if (TIFFReadEncodedTile(file.get(), index, tile.data(), tile_bytes) != tile_bytes)
                throw_unreadable_page(file);
            const std::size_t rows = std::min(tile_height, layout.height - y);
            for (std::size_t row = 0; row < rows; ++row)
                copy(tile.data() + row * row_bytes, x, y + row, std::min(tile_width, layout.width - x));
        }
}

} // namespace

TiffFile::TiffFile(const std::filesystem::path& path)
{
    TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
    TIFFOpenOptionsSetErrorHandlerExtR(options, &keep_first_error, error_.get());
    TIFFOpenOptionsSetWarningHandlerExtR(options, &drop_warning, nullptr);
    tiff_ = TIFFOpenExt(path.c_str(), "r", options);
    TIFFOpenOptionsFree(options);
    if (tiff_ == nullptr)
        throw InputError("is not a readable TIFF file: " + *error_);
}

TiffFile::~TiffFile()
{
    TIFFClose(tiff_);
}

PageLayout page_layout(const TiffFile& file)
{
    if (const auto values = field<std::uint16_t>(file, TIFFTAG_SAMPLESPERPIXEL, 1); values != 1)
        throw InputError("has " + std::to_string(values) +
                         " values in each sample (a vector or color image), expected one");
    PageLayout layout;
    layout.width = field<std::uint32_t>(file, TIFFTAG_IMAGEWIDTH, 0);
    layout.height = field<std::uint32_t>(file, TIFFTAG_IMAGELENGTH, 0);
    layout.bits = field<std::uint16_t>(file, TIFFTAG_BITSPERSAMPLE, 1);
    layout.type =
        stored_type(layout.bits, field<std::uint16_t>(file, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT));
    return layout;
}

std::string layout_text(const PageLayout& layout)
{
    return std::to_string(layout.width) + " x " + std::to_string(layout.height) + " " +
           std::string(stored_type_name(layout.type));
}

void read_page(const TiffFile& file, const PageLayout& layout, std::span<std::byte> to)
{
    const RowCopy copy{layout, to};
    if (TIFFIsTiled(file.get()) != 0)
        read_tiles(file, copy);
    else
        read_strips(file, copy);
}

StoredVolume stack_pages(const PageLayout& layout, std::size_t page_count, const FillPage& fill_page)
{
    const std::array<std::int64_t, 3> size{layout.width, layout.height,
                                           static_cast<std::int64_t>(page_count)};
    const std::size_t count = require_sane_size(size, byte_size(layout.type));
    StoredVolume volume{.lattice = {.size = {layout.width, layout.height, page_count}},
                        .format = "TIFF",
                        .stored_type = std::string(stored_type_name(layout.type)),
                        .has_spacing = false}; // what TIFF calls resolution is dots per inch of paper
    volume.samples = decode_samples(
        {.type = layout.type}, count,
        [&](std::span<std::byte> to)
        {
            for (std::size_t page = 0; page < page_count; ++page)
                fill_page(page, to.subspan(page * layout.byte_count(), layout.byte_count()));
        },
        volume.warnings);
    return volume;
}

} // namespace voroprobe
