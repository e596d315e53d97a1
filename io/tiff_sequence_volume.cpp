#include <algorithm>
#include <cstdlib>
#include <limits>

#include <tiffio.h>

#include "io/volume_formats.h"
#include "io/volume_natural_order.h"
#include "io/volume_tiff.h"
#include "support/error.h"
#include "support/text.h"

namespace voroprobe
{

namespace
{

std::vector<std::filesystem::path> tiff_files(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
        const std::string extension = lower_case(entry.path().extension().string());
        if (entry.is_regular_file() && (extension == ".tif" || extension == ".tiff") &&
            !entry.path().filename().string().starts_with('.'))
            files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end(),
              [](const std::filesystem::path& a, const std::filesystem::path& b)
              { return natural_less(a.filename().string(), b.filename().string()); });
    return files;
}

//! The last number in a file's name; -1 where there is none or it is too long to count with.
long last_number(const std::filesystem::path& path)
{
    const std::string name = path.stem().string();
    const std::size_t last = name.find_last_of("0123456789");
    if (last == std::string::npos)
        return -1;
    const std::size_t before = name.find_last_not_of("0123456789", last);
    const std::string digits = name.substr(before + 1, last - before);
    constexpr std::size_t kMaxDigits = 17;
    return digits.size() > kMaxDigits ? -1 : std::strtol(digits.c_str(), nullptr, 10);
}

//! Numbered slices have to follow each other in equal steps.
void require_no_gap(const std::vector<std::filesystem::path>& files)
{
    long step = std::numeric_limits<long>::max();
    for (std::size_t i = 0; i + 1 < files.size(); ++i)
    {
        const long from = last_number(files[i]);
        const long to = last_number(files[i + 1]);
        if (from < 0 || to <= from)
            return; // not numbered along the sequence
        step = std::min(step, to - from);
    }
    for (std::size_t i = 0; i + 1 < files.size(); ++i)
        if (const long found = last_number(files[i + 1]) - last_number(files[i]); found != step)
            throw InputError("a slice is missing between " + files[i].filename().string() + " and " +
                             files[i + 1].filename().string() + ": the numbers differ by " +
                             std::to_string(found) + ", expected " + std::to_string(step));
}

//! Runs `action`, putting the name of the slice in front of what it throws.
template <class Action>
void with_slice(const std::filesystem::path& path, const Action& action)
{
    try
    {
        action();
    }
    catch (const InputError& error)
    {
        throw InputError("slice " + path.filename().string() + " " + error.what());
    }
}

void read_slice(const std::filesystem::path& path, const PageLayout& layout, std::span<std::byte> to)
{
    const TiffFile file(path);
    if (const PageLayout found = page_layout(file); !(found == layout))
        throw InputError("is " + layout_text(found) + ", expected it to be like the first, " +
                         layout_text(layout));
    if (TIFFLastDirectory(file.get()) == 0)
        throw InputError("holds several pages, expected one in each file of a sequence");
    read_page(file, layout, to);
}

} // namespace

StoredVolume read_tiff_sequence(const std::filesystem::path& folder, const ReadOptions& options)
{
    const std::vector<std::filesystem::path> files = tiff_files(folder);
    if (files.size() == 1)
        return read_tiff_pages(files.front(), options);
    require_no_gap(files);
    choose_frame(1, options.frame);

    PageLayout layout;
    with_slice(files.front(), [&] { layout = page_layout(TiffFile(files.front())); });
    return stack_pages(layout, files.size(),
                       [&](std::size_t slice, std::span<std::byte> to)
                       { with_slice(files[slice], [&] { read_slice(files[slice], layout, to); }); });
}

} // namespace voroprobe
