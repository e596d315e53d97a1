#include "io/volume_itk.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <itkObject.h>

#include "support/error.h"

namespace voroprobe
{

namespace
{

//! Switches ITK's warnings off and back as they were.
class QuietItk
{
public:
    QuietItk() { itk::Object::SetGlobalWarningDisplay(false); }
    ~QuietItk() { itk::Object::SetGlobalWarningDisplay(before_); }
    QuietItk(const QuietItk&) = delete;
    QuietItk& operator=(const QuietItk&) = delete;

private:
    bool before_ = itk::Object::GetGlobalWarningDisplay();
};

//! "expected 240 bytes but received 200" of a message of many lines, the last of which is
//! "[nrrd] _nrrdEncodingGzip_read: expected 240 bytes but received 200".
std::string last_line(std::string text)
{
    text.erase(text.find_last_not_of(" \t\r\n") + 1);
    if (const std::size_t newline = text.find_last_of('\n'); newline != std::string::npos)
        text.erase(0, newline + 1);
    for (const std::string_view prefix : {"ITK ERROR: ", "Reason: "})
        if (text.starts_with(prefix))
            text.erase(0, prefix.size());
    if (const std::size_t colon = text.find(": "); text.starts_with("[nrrd]") && colon != std::string::npos)
        text.erase(0, colon + 2);
    if (const std::size_t address_end = text.find("): "); address_end != std::string::npos)
        text.erase(0, address_end + 3);
    return text;
}

//! Sizes of all axes of an image, at least three of them.
std::vector<std::int64_t> dimensions(const itk::ImageIOBase& image_io)
{
    std::vector<std::int64_t> size;
    for (unsigned axis = 0; axis < image_io.GetNumberOfDimensions(); ++axis)
        size.push_back(static_cast<std::int64_t>(image_io.GetDimensions(axis)));
    if (size.size() < 3)
        throw InputError("has " + std::to_string(size.size()) +
                         " dimensions, expected 3: a single slice is not a volume");
    return size;
}

void read_whole_image(itk::ImageIOBase& image_io, std::span<std::byte> to)
{
    itk::ImageIORegion region(image_io.GetNumberOfDimensions());
    for (unsigned axis = 0; axis < image_io.GetNumberOfDimensions(); ++axis)
        region.SetSize(axis, image_io.GetDimensions(axis));
    image_io.SetIORegion(region);
    with_itk([&] { image_io.Read(to.data()); });
}

StoredType integer_type(std::size_t bytes, bool is_signed)
{
    switch (bytes)
    {
    case 1:
        return is_signed ? StoredType::kInt8 : StoredType::kUint8;
    case 2:
        return is_signed ? StoredType::kInt16 : StoredType::kUint16;
    case 4:
        return is_signed ? StoredType::kInt32 : StoredType::kUint32;
    default:
        return is_signed ? StoredType::kInt64 : StoredType::kUint64;
    }
}

} // namespace

void with_itk(const std::function<void()>& action)
{
    const QuietItk quiet;
    try
    {
        action();
    }
    catch (const itk::ExceptionObject& error)
    {
        throw InputError("cannot be read: " + last_line(error.GetDescription()));
    }
}

void read_itk_header(itk::ImageIOBase& image_io, const std::filesystem::path& path)
{
    with_itk(
        [&]
        {
            image_io.SetFileName(path.string());
            image_io.ReadImageInformation();
        });
}

StoredLattice itk_lattice(const itk::ImageIOBase& image_io)
{
    const std::vector<std::int64_t> size = dimensions(image_io);
    StoredLattice lattice{.size = {}};
    for (unsigned axis = 0; axis < 3; ++axis)
    {
        lattice.size[axis] = static_cast<std::size_t>(size[axis]);
        lattice.origin[axis] = image_io.GetOrigin(axis);

        // A negative spacing says the same as a reversed direction.
        const double spacing = image_io.GetSpacing(axis);
        const double sign = spacing < 0.0 ? -1.0 : 1.0;
        lattice.spacing[axis] = sign * spacing;
        const std::vector<double> direction = image_io.GetDirection(axis);
        lattice.direction.column[axis] = sign * Vec3{direction.at(0), direction.at(1), direction.at(2)};
    }
    return lattice;
}

StoredType itk_stored_type(const itk::ImageIOBase& image_io)
{
    if (image_io.GetNumberOfComponents() != 1)
        throw InputError("has " + std::to_string(image_io.GetNumberOfComponents()) +
                         " values in each sample (a vector or color image), expected one");
    return itk_component_type(image_io);
}

StoredType itk_component_type(const itk::ImageIOBase& image_io)
{
    using Component = itk::IOComponentEnum;
    const auto component = image_io.GetComponentType();
    switch (component)
    {
    case Component::UCHAR:
    case Component::USHORT:
    case Component::UINT:
    case Component::ULONG:
    case Component::ULONGLONG:
        return integer_type(image_io.GetComponentSize(), false);
    case Component::CHAR:
    case Component::SHORT:
    case Component::INT:
    case Component::LONG:
    case Component::LONGLONG:
        return integer_type(image_io.GetComponentSize(), true);
    case Component::FLOAT:
        return StoredType::kFloat32;
    case Component::DOUBLE:
        return StoredType::kFloat64;
    default:
        throw InputError("has samples of type " + itk::ImageIOBase::GetComponentTypeAsString(component) +
                         ", expected integers or floating-point numbers of 8 to 64 bits");
    }
}

SampleArray read_itk_component(itk::ImageIOBase& image_io, const std::optional<std::size_t>& frame,
                               std::vector<std::string>& warnings)
{
    const StoredType type = itk_component_type(image_io);
    const std::size_t components = image_io.GetNumberOfComponents();
    const std::size_t count = require_sane_size(dimensions(image_io), components * byte_size(type));
    const std::size_t chosen = choose_frame(components, frame);
    return decode_samples(
        {.type = type}, count,
        [&](std::span<std::byte> to)
        {
            const std::size_t size = byte_size(type);
            std::vector<std::byte> pixels(components * to.size());
            read_whole_image(image_io, pixels);
            for (std::size_t i = 0; i < count; ++i)
                std::copy_n(pixels.begin() + static_cast<std::ptrdiff_t>((i * components + chosen) * size),
                            size, to.begin() + static_cast<std::ptrdiff_t>(i * size));
        },
        warnings);
}

SampleArray read_itk_samples(itk::ImageIOBase& image_io, const std::optional<std::size_t>& frame,
                             std::vector<std::string>& warnings)
{
    const std::vector<std::int64_t> size = dimensions(image_io);
    const StoredType type = itk_stored_type(image_io);
    const std::size_t total = require_sane_size(size, byte_size(type));
    const std::size_t count = require_sane_size(std::span(size).first(3), byte_size(type));
    const std::size_t chosen = choose_frame(total / count, frame);
    return decode_samples(
        {.type = type}, count,
        [&](std::span<std::byte> to)
        {
            if (total == count)
                return read_whole_image(image_io, to);
            std::vector<std::byte> all_frames(total * byte_size(type));
            read_whole_image(image_io, all_frames);
            std::copy_n(all_frames.begin() + static_cast<std::ptrdiff_t>(chosen * to.size()), to.size(),
                        to.begin());
        },
        warnings);
}

} // namespace voroprobe
