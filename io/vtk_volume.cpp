// VTK image data: the XML format (.vti) and the legacy one (.vtk, STRUCTURED_POINTS), read with VTK.

#include <algorithm>
#include <array>
#include <cstring>
#include <map>

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStructuredPoints.h>
#include <vtkStructuredPointsReader.h>
#include <vtkXMLImageDataReader.h>

#include "io/volume_bytes.h"
#include "io/volume_formats.h"
#include "io/volume_samples.h"
#include "io/vtk_messages.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

//! \throw InputError where VTK has reported an error.
void rethrow(const VtkMessages& messages)
{
    if (const std::string error = messages.first_error(); !error.empty())
        throw InputError("cannot be read: " + error);
}

StoredType stored_type(vtkDataArray& array)
{
    if (array.GetNumberOfComponents() != 1)
        throw InputError("has " + std::to_string(array.GetNumberOfComponents()) +
                         " values in each sample (a vector or color image), expected one");
    static const std::map<int, StoredType> kTypes{
        {VTK_UNSIGNED_CHAR, StoredType::kUint8}, {VTK_SIGNED_CHAR, StoredType::kInt8},
        {VTK_CHAR, StoredType::kInt8},           {VTK_UNSIGNED_SHORT, StoredType::kUint16},
        {VTK_SHORT, StoredType::kInt16},         {VTK_UNSIGNED_INT, StoredType::kUint32},
        {VTK_INT, StoredType::kInt32},           {VTK_UNSIGNED_LONG, StoredType::kUint64},
        {VTK_LONG, StoredType::kInt64},          {VTK_UNSIGNED_LONG_LONG, StoredType::kUint64},
        {VTK_LONG_LONG, StoredType::kInt64},     {VTK_ID_TYPE, StoredType::kInt64},
        {VTK_FLOAT, StoredType::kFloat32},       {VTK_DOUBLE, StoredType::kFloat64}};
    if (const auto found = kTypes.find(array.GetDataType()); found != kTypes.end())
        return found->second;
    throw InputError(std::string("has samples of type ") + array.GetDataTypeAsString() +
                     ", expected integers or floating-point numbers of 8 to 64 bits");
}

//! The point data that a viewer would show: the active scalars, else the first array.
vtkDataArray& point_samples(vtkImageData& image)
{
    vtkPointData* points = image.GetPointData();
    vtkDataArray* array = points->GetScalars();
    if (array == nullptr && points->GetNumberOfArrays() > 0)
        array = points->GetArray(0);
    if (array == nullptr)
        throw InputError("has no values at its points, expected a point data array of numbers");
    return *array;
}

StoredLattice lattice(vtkImageData& image)
{
    StoredLattice lattice{.size = {}};
    const int* extent = image.GetExtent();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        lattice.size[axis] = static_cast<std::size_t>(extent[2 * axis + 1] - extent[2 * axis] + 1);
        lattice.start[axis] = extent[2 * axis];
        lattice.spacing[axis] = image.GetSpacing()[axis];
        lattice.origin[axis] = image.GetOrigin()[axis];
        for (std::size_t row = 0; row < 3; ++row)
            lattice.direction.column[axis][row] =
                image.GetDirectionMatrix()->GetElement(static_cast<int>(row), static_cast<int>(axis));
    }
    return lattice;
}

//! Refuses what the header announces before anything is allocated.
void require_sane_extent(vtkAlgorithm& reader)
{
    vtkInformation* information = reader.GetOutputInformation(0);
    if (information == nullptr || information->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()) == 0)
        throw InputError("is not a VTK image: no extent in the header");
    std::array<int, 6> extent{};
    information->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent.data());
    std::array<std::int64_t, 3> size{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        size[axis] = std::int64_t{extent[2 * axis + 1]} - extent[2 * axis] + 1;
    require_sane_size(size, 1);
}

template <class Reader>
StoredVolume read_with(Reader& reader, const std::filesystem::path& path)
{
    const VtkMessages messages;
    reader.SetFileName(path.c_str());
    reader.UpdateInformation();
    rethrow(messages);
    require_sane_extent(reader);
    reader.Update();
    rethrow(messages);
    if (messages.first_warning().find("Error reading") != std::string::npos)
        throw InputError("truncated or damaged: the samples end early");

    auto& image = static_cast<vtkImageData&>(*reader.GetOutput());
    vtkDataArray& array = point_samples(image);
    StoredVolume volume{.lattice = lattice(image), .format = "VTK image data"};
    const StoredType type = stored_type(array);
    volume.stored_type = stored_type_name(type);
    const auto count = static_cast<std::size_t>(image.GetNumberOfPoints());
    if (static_cast<std::size_t>(array.GetNumberOfTuples()) != count)
        throw InputError("truncated: holds " + std::to_string(array.GetNumberOfTuples()) +
                         " samples, expected " + std::to_string(count));
    volume.samples = decode_samples(
        {.type = type}, count,
        [&](std::span<std::byte> to) { std::memcpy(to.data(), array.GetVoidPointer(0), to.size()); },
        volume.warnings);
    return volume;
}

//! VTK does not look for the end of a file with raw appended data, nor mind if the data end early.
void require_end_tag(const std::filesystem::path& path)
{
    constexpr std::uint64_t kTailBytes = 256;
    const std::uint64_t size = std::filesystem::file_size(path);
    std::string tail(std::min(size, kTailBytes), '\0');
    read_bytes({.files = {path}, .offset = size - tail.size()}, std::as_writable_bytes(std::span(tail)));
    if (tail.find("</VTKFile>") == std::string::npos)
        throw InputError("truncated: expected \"</VTKFile>\" at the end of the file");
}

} // namespace

StoredVolume read_vtk_image(const std::filesystem::path& path, const ReadOptions& options)
{
    choose_frame(1, options.frame);
    constexpr std::size_t kLongestFirstLine = 256;
    const std::string head = read_head(path, kLongestFirstLine);
    if (head.starts_with("# vtk DataFile"))
    {
        vtkNew<vtkStructuredPointsReader> reader;
        return read_with(*reader, path);
    }
    if (head.find("<VTKFile") == std::string::npos || head.find("ImageData") == std::string::npos)
        throw InputError("is not a VTK image: expected an XML file of type ImageData or a legacy file of "
                         "STRUCTURED_POINTS");
    require_end_tag(path);
    vtkNew<vtkXMLImageDataReader> reader;
    return read_with(*reader, path);
}

} // namespace voroprobe
