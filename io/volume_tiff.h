#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "io/volume_formats.h"
#include "io/volume_samples.h"

//! Inside of io/: pages of TIFF files.
struct tiff;

namespace voroprobe
{

//! An open TIFF file that keeps libtiff's first error instead of printing it; one page at a time is the
//! current one.
class TiffFile
{
public:
    //! \throw InputError where it is no TIFF file.
    explicit TiffFile(const std::filesystem::path& path);
    ~TiffFile();
    TiffFile(const TiffFile&) = delete;
    TiffFile& operator=(const TiffFile&) = delete;

    [[nodiscard]] tiff* get() const { return tiff_; }
    [[nodiscard]] const std::string& error() const { return *error_; } //!< empty where there was none

private:
    std::unique_ptr<std::string> error_ = std::make_unique<std::string>();
    tiff* tiff_ = nullptr;
};

//! What all pages of a volume have in common.
struct PageLayout
{
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint16_t bits = 1;
    StoredType type = StoredType::kUint8;

    [[nodiscard]] std::size_t byte_count() const { return std::size_t{width} * height * byte_size(type); }
    friend bool operator==(const PageLayout&, const PageLayout&) = default;
};

//! Layout of the current page. \throw InputError where its samples are not single numbers of a known type.
PageLayout page_layout(const TiffFile& file);

//! "512 x 512 uint16"
std::string layout_text(const PageLayout& layout);

//! The samples of the current page in native byte order. \throw InputError.
void read_page(const TiffFile& file, const PageLayout& layout, std::span<std::byte> to);

//! A volume of `page_count` pages; `fill_page` is asked for one after the other.
using FillPage = std::function<void(std::size_t page, std::span<std::byte> to)>;
StoredVolume stack_pages(const PageLayout& layout, std::size_t page_count, const FillPage& fill_page);

} // namespace voroprobe
