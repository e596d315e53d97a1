// DICOM files through GDCM, as ITK uses it.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <mutex>
#include <set>
#include <sstream>

#include <gdcmTrace.h>
#include <itkGDCMImageIO.h>

#include "io/dicom_outline.h"
#include "io/dicom_stack.h"
#include "io/volume_formats.h"
#include "io/volume_itk.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

//! The largest angle between the direction cosines of slices of one volume, as a difference of cosines.
constexpr double kSameDirection = 1e-4;

//! Keeps GDCM from printing. Its trace is one for the whole program.
class QuietGdcm
{
public:
    QuietGdcm() : lock_(mutex()) { gdcm::Trace::SetStream(text_); }
    ~QuietGdcm() { gdcm::Trace::SetStream(std::cerr); }
    QuietGdcm(const QuietGdcm&) = delete;
    QuietGdcm& operator=(const QuietGdcm&) = delete;

private:
    static std::mutex& mutex()
    {
        static std::mutex the_mutex;
        return the_mutex;
    }

    std::lock_guard<std::mutex> lock_;
    std::ostringstream text_;
};

//! Runs `action`, putting the name of the slice in front of what it throws.
template <class Action>
void with_slice(const std::string& file, const Action& action)
{
    try
    {
        action();
    }
    catch (const InputError& error)
    {
        throw InputError("slice " + std::filesystem::path(file).filename().string() + " " + error.what());
    }
}

struct Series
{
    std::string uid;
    std::vector<std::string> files;
};

std::string read_series_uid(const std::string& file)
{
    const auto image_io = itk::GDCMImageIO::New();
    read_itk_header(*image_io, file);
    std::string uid;
    image_io->GetValueFromTag("0020|000e", uid);
    return uid;
}

//! Files of the folder that are or should be DICOM, by name.
std::set<std::string> dicom_files(const std::filesystem::path& folder)
{
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
        const std::string name = entry.path().filename().string();
        const bool is_passed_over = !entry.is_regular_file() || name.starts_with('.') || name == "DICOMDIR";
        if (!is_passed_over && (entry.path().extension() == ".dcm" || has_dicom_mark(entry.path())))
            files.insert(entry.path().string());
    }
    return files;
}

//! The image series of a folder, by UID. \throw InputError that names a file that cannot be read.
std::vector<Series> find_series(const std::filesystem::path& folder)
{
    std::map<std::string, std::vector<std::string>> files_of_uid;
    for (const std::string& file : dicom_files(folder))
        with_slice(
            file,
            [&]
            {
                const DicomOutline outline = read_dicom_outline(file);
                if (outline.has_pixels)
                    files_of_uid[outline.series_uid ? *outline.series_uid : read_series_uid(file)].push_back(
                        file);
            });
    std::vector<Series> all;
    for (auto& [uid, files] : files_of_uid)
        all.push_back({uid, std::move(files)});
    return all;
}

std::string list_text(const std::vector<const Series*>& series)
{
    std::string text;
    for (const Series* one : series)
        text += (text.empty() ? "" : ", ") + one->uid + " (" + std::to_string(one->files.size()) + " files)";
    return text;
}

const Series& choose_series(const std::vector<Series>& all, const std::optional<std::string>& part)
{
    std::vector<const Series*> fitting;
    std::vector<const Series*> every;
    for (const Series& one : all)
    {
        every.push_back(&one);
        if (!part || one.uid.find(*part) != std::string::npos)
            fitting.push_back(&one);
    }
    if (every.empty())
        throw InputError("holds no DICOM series");
    if (fitting.empty())
        throw InputError("has no series with \"" + *part + "\" in its UID, expected one of " +
                         list_text(every));
    if (fitting.size() > 1)
        throw InputError("holds " + std::to_string(fitting.size()) +
                         " series, expected one: choose with --series from " + list_text(fitting));
    return *fitting.front();
}

int tag_number(itk::GDCMImageIO& image_io, const std::string& tag)
{
    std::string text;
    return image_io.GetValueFromTag(tag, text) ? std::atoi(text.c_str()) : 0;
}

//! From Bits Allocated and Pixel Representation.
std::string stored_type_text(itk::GDCMImageIO& image_io)
{
    return (tag_number(image_io, "0028|0103") == 1 ? "int" : "uint") +
           std::to_string(tag_number(image_io, "0028|0100"));
}

Slice read_slice_header(itk::GDCMImageIO& image_io, const std::string& file)
{
    read_itk_header(image_io, file);
    std::string position;
    Slice slice{.file = file,
                .lattice = itk_lattice(image_io),
                .type = itk_stored_type(image_io),
                .stored_type = stored_type_text(image_io),
                .has_position = image_io.GetValueFromTag("0020|0032", position)};
    // GDCM rescales to double; 32 bits hold what was stored in 16.
    if (slice.type == StoredType::kFloat64 && tag_number(image_io, "0028|0100") <= 16)
        slice.type = StoredType::kFloat32;
    return slice;
}

//! Headers of all slices; refuses those that do not fit together in one volume.
std::vector<Slice> read_slice_headers(const Series& series)
{
    std::vector<Slice> slices;
    for (const std::string& file : series.files)
        with_slice(
            file,
            [&]
            {
                const auto image_io = itk::GDCMImageIO::New();
                slices.push_back(read_slice_header(*image_io, file));
                const StoredLattice& lattice = slices.back().lattice;
                const StoredLattice& first = slices.front().lattice;
                if (lattice.size != first.size)
                    throw InputError("is " + std::to_string(lattice.size[0]) + " x " +
                                     std::to_string(lattice.size[1]) +
                                     ", expected it to be like the first, " + std::to_string(first.size[0]) +
                                     " x " + std::to_string(first.size[1]));
                if (!slices.back().has_position)
                    throw InputError("has no position (Image Position Patient)");
                for (std::size_t axis = 0; axis < 2; ++axis)
                    if (dot(lattice.direction.column[axis], first.direction.column[axis]) <
                            1.0 - kSameDirection ||
                        std::abs(lattice.spacing[axis] / first.spacing[axis] - 1.0) > kSameDirection)
                        throw InputError("has another orientation or pixel spacing than " +
                                         std::filesystem::path(slices.front().file).filename().string());
            });
    return slices;
}

//! The type that holds the samples of all slices: theirs where it is one that a Volume keeps, else double.
StoredType common_type(const std::vector<Slice>& slices)
{
    const StoredType first = slices.front().type;
    const bool same =
        std::all_of(slices.begin(), slices.end(), [&](const Slice& slice) { return slice.type == first; });
    const bool kept = byte_size(first) <= 2 || first == StoredType::kInt32 || first == StoredType::kFloat32;
    return same && kept ? first : StoredType::kFloat64;
}

SampleArray empty_samples(StoredType type, std::size_t count)
{
    const auto reserved = [count](auto samples) -> SampleArray
    {
        samples.reserve(count);
        return samples;
    };
    switch (type)
    {
    case StoredType::kUint8:
        return reserved(std::vector<std::uint8_t>{});
    case StoredType::kInt8:
        return reserved(std::vector<std::int8_t>{});
    case StoredType::kUint16:
        return reserved(std::vector<std::uint16_t>{});
    case StoredType::kInt16:
        return reserved(std::vector<std::int16_t>{});
    case StoredType::kInt32:
        return reserved(std::vector<std::int32_t>{});
    case StoredType::kFloat32:
        return reserved(std::vector<float>{});
    default:
        return reserved(std::vector<double>{});
    }
}

void append(SampleArray& all, const SampleArray& more)
{
    std::visit(
        [](auto& to, const auto& from)
        {
            using Sample = typename std::decay_t<decltype(to)>::value_type;
            std::transform(from.begin(), from.end(), std::back_inserter(to),
                           [](auto value) { return static_cast<Sample>(value); });
        },
        all, more);
}

SampleArray read_slice_samples(const std::string& file, std::vector<std::string>& warnings)
{
    const QuietGdcm quiet;
    const auto image_io = itk::GDCMImageIO::New();
    read_itk_header(*image_io, file);
    return read_itk_samples(*image_io, std::nullopt, warnings);
}

} // namespace

StoredVolume read_dicom_file(const std::filesystem::path& path, const ReadOptions& options)
{
    const QuietGdcm quiet;
    if (!read_dicom_outline(path).has_pixels)
        throw InputError("is a DICOM file without pixel data, expected an image");
    const auto image_io = itk::GDCMImageIO::New();
    read_itk_header(*image_io, path);
    StoredVolume volume{.lattice = itk_lattice(*image_io), .format = "DICOM"};
    if (volume.lattice.size[2] == 1)
        throw InputError("a single slice is not a volume: expected the folder that holds the whole series");
    volume.stored_type = stored_type_text(*image_io);
    volume.samples = read_itk_samples(*image_io, options.frame, volume.warnings);
    return volume;
}

StoredVolume read_dicom_folder(const std::filesystem::path& folder, const ReadOptions& options)
{
    std::vector<Series> all;
    std::vector<Slice> slices;
    {
        const QuietGdcm quiet;
        all = find_series(folder);
        slices = read_slice_headers(choose_series(all, options.series));
    }
    if (slices.size() == 1 && slices.front().lattice.size[2] > 1)
        return read_dicom_file(slices.front().file, options);
    choose_frame(1, options.frame);
    order_by_position(slices);

    StoredVolume volume{.lattice = {.size = {}}, .format = "DICOM"};
    volume.lattice = stack_lattice(slices, volume.warnings);
    volume.stored_type = slices.front().stored_type;
    const StoredType type = common_type(slices);
    const std::array<std::int64_t, 3> size{static_cast<std::int64_t>(volume.lattice.size[0]),
                                           static_cast<std::int64_t>(volume.lattice.size[1]),
                                           static_cast<std::int64_t>(volume.lattice.size[2])};
    volume.samples = empty_samples(type, require_sane_size(size, byte_size(type)));
    for (const Slice& slice : slices)
        with_slice(slice.file,
                   [&] { append(volume.samples, read_slice_samples(slice.file, volume.warnings)); });
    return volume;
}

} // namespace voroprobe
