#include <algorithm>
#include <sstream>

#include <tiffio.h>

#include "io/volume_formats.h"
#include "io/volume_tiff.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

bool is_thumbnail(const TiffFile& file)
{
    std::uint32_t kind = 0;
    return TIFFGetField(file.get(), TIFFTAG_SUBFILETYPE, &kind) == 1 && (kind & FILETYPE_REDUCEDIMAGE) != 0;
}

//! File positions of the full-size pages. \throw InputError where the chain of pages breaks off or their
//! layouts differ.
std::vector<std::uint64_t> find_pages(const TiffFile& file, const PageLayout& layout)
{
    std::vector<std::uint64_t> pages;
    do
    {
        if (is_thumbnail(file))
            continue;
        if (const PageLayout found = page_layout(file); !(found == layout))
            throw InputError("page " + std::to_string(pages.size()) + " is " + layout_text(found) +
                             ", expected it to be like the first, " + layout_text(layout));
        pages.push_back(TIFFCurrentDirOffset(file.get()));
    } while (TIFFReadDirectory(file.get()) == 1);
    if (TIFFLastDirectory(file.get()) == 0 || !file.error().empty())
        throw InputError("truncated: no page after page " + std::to_string(pages.size()) +
                         " can be read, though the file announces one: " + file.error());
    return pages;
}

//! How ImageJ says that the pages are several volumes: channels vary fastest, then slices, then time frames.
struct Hyperstack
{
    std::size_t images = 1;
    std::size_t channels = 1;
    std::size_t frames = 1;
};

Hyperstack read_hyperstack(const TiffFile& file, std::size_t page_count)
{
    const char* description = nullptr;
    Hyperstack stack{.images = page_count};
    if (TIFFGetField(file.get(), TIFFTAG_IMAGEDESCRIPTION, &description) != 1 || description == nullptr)
        return stack;
    std::istringstream lines(description);
    std::string line;
    if (!std::getline(lines, line) || !line.starts_with("ImageJ="))
        return stack;
    while (std::getline(lines, line))
        for (const auto& [name, value] : {std::pair<std::string_view, std::size_t*>{"images=", &stack.images},
                                          {"channels=", &stack.channels},
                                          {"frames=", &stack.frames}})
            if (line.starts_with(name))
                *value = std::max(1UL, std::strtoul(line.c_str() + name.size(), nullptr, 10));
    if (stack.images != page_count)
        throw InputError("holds " + std::to_string(page_count) + " pages, expected the " +
                         std::to_string(stack.images) + " that its ImageJ description announces");
    if (stack.channels > page_count || page_count % stack.channels != 0 ||
        (page_count / stack.channels) % stack.frames != 0)
        return {.images = page_count};
    return stack;
}

//! The pages of one of the volumes.
std::vector<std::uint64_t> choose_pages(const std::vector<std::uint64_t>& pages, const Hyperstack& stack,
                                        const std::optional<std::size_t>& frame)
{
    const std::size_t chosen = choose_frame(stack.channels * stack.frames, frame);
    const std::size_t channel = chosen % stack.channels;
    const std::size_t time = chosen / stack.channels;
    const std::size_t slices = pages.size() / (stack.channels * stack.frames);
    std::vector<std::uint64_t> result;
    for (std::size_t slice = 0; slice < slices; ++slice)
        result.push_back(pages[channel + stack.channels * (slice + slices * time)]);
    return result;
}

} // namespace

StoredVolume read_tiff_pages(const std::filesystem::path& path, const ReadOptions& options)
{
    const TiffFile file(path);
    const PageLayout layout = page_layout(file);
    const std::vector<std::uint64_t> all_pages = find_pages(file, layout);
    TIFFSetDirectory(file.get(), 0);
    const std::vector<std::uint64_t> pages =
        choose_pages(all_pages, read_hyperstack(file, all_pages.size()), options.frame);
    return stack_pages(layout, pages.size(),
                       [&](std::size_t page, std::span<std::byte> to)
                       {
                           if (TIFFSetSubDirectory(file.get(), pages[page]) != 1)
                               throw InputError("page " + std::to_string(page) +
                                                " cannot be read: " + file.error());
                           read_page(file, layout, to);
                       });
}

} // namespace voroprobe
