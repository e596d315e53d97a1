#include "io/volume_reader.h"

#include <array>
#include <cmath>
#include <utility>

#include "io/dicom_outline.h"
#include "io/volume_bytes.h"
#include "io/volume_formats.h"
#include "support/error.h"
#include "support/number_text.h"
#include "support/text.h"

namespace voroprobe
{

namespace
{

using Reader = StoredVolume (*)(const std::filesystem::path&, const ReadOptions&);

constexpr const char* kKnownFormats =
    "NIfTI (.nii, .nii.gz), NRRD (.nrrd, .nhdr), MetaImage (.mha, .mhd), TIFF (.tif, "
    ".tiff), DICOM, Inrimage (.inr, .inr.gz) or VTK image data (.vti, .vtk)";

Reader reader_by_name(const std::filesystem::path& path)
{
    static constexpr std::array<std::pair<const char*, Reader>, 13> kReaders{{{".nii", read_nifti},
                                                                              {".nii.gz", read_nifti},
                                                                              {".nrrd", read_nrrd},
                                                                              {".nhdr", read_nrrd},
                                                                              {".mha", read_meta_image},
                                                                              {".mhd", read_meta_image},
                                                                              {".tif", read_tiff_pages},
                                                                              {".tiff", read_tiff_pages},
                                                                              {".inr", read_inrimage},
                                                                              {".inr.gz", read_inrimage},
                                                                              {".vti", read_vtk_image},
                                                                              {".vtk", read_vtk_image},
                                                                              {".dcm", read_dicom_file}}};
    const std::string name = lower_case(path.filename().string());
    for (const auto& [extension, reader] : kReaders)
        if (name.ends_with(extension))
            return reader;
    return nullptr;
}

Reader reader_by_content(const std::filesystem::path& path)
{
    constexpr std::size_t kHeadBytes = 512;
    const std::string head = read_head(path, kHeadBytes);
    if (head.starts_with("NRRD"))
        return read_nrrd;
    if (head.starts_with("#INRIMAGE-4#{"))
        return read_inrimage;
    if (head.starts_with("ObjectType") || head.starts_with("NDims"))
        return read_meta_image;
    if (head.starts_with("II*") || head.starts_with("II+") || head.starts_with(std::string_view("MM\0", 3)))
        return read_tiff_pages;
    if (head.starts_with("# vtk DataFile") || head.find("<VTKFile") != std::string::npos)
        return read_vtk_image;
    return has_dicom_mark(path) ? read_dicom_file : nullptr;
}

Reader folder_reader(const std::filesystem::path& folder)
{
    bool has_tiff = false;
    bool has_file = false;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
        if (!entry.is_regular_file())
            continue;
        const std::string extension = lower_case(entry.path().extension().string());
        if (extension == ".dcm" || has_dicom_mark(entry.path()))
            return read_dicom_folder;
        has_tiff = has_tiff || extension == ".tif" || extension == ".tiff";
        has_file = true;
    }
    if (has_tiff)
        return read_tiff_sequence;
    throw InputError(has_file ? "the folder holds neither DICOM nor TIFF files, expected one series of either"
                              : "the folder is empty, expected DICOM or TIFF files in it");
}

Reader choose_reader(const std::filesystem::path& path)
{
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status))
        throw InputError("no such file or folder");
    if (std::filesystem::is_directory(status))
        return folder_reader(path);
    if (!std::filesystem::is_regular_file(status))
        throw InputError(
            "is neither a file nor a folder: pipes cannot be read, for a scan is looked at in places");
    if (std::filesystem::file_size(path) == 0)
        throw InputError("the file is empty");
    if (lower_case(path.extension().string()) == ".vdb")
        throw InputError("is a sparse OpenVDB grid, expected a dense volume: " + std::string(kKnownFormats));
    if (const Reader reader = reader_by_name(path))
        return reader;
    if (const Reader reader = reader_by_content(path))
        return reader;
    throw InputError("is of no known format, expected " + std::string(kKnownFormats));
}

void apply_spacing(StoredVolume& stored, const ReadOptions& options)
{
    if (options.spacing)
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (!std::isfinite((*options.spacing)[axis]) || (*options.spacing)[axis] <= 0.0)
                throw UsageError("--spacing: " + number_text((*options.spacing)[axis]) +
                                 ", expected three positive numbers");
        stored.lattice.spacing = *options.spacing;
        stored.has_spacing = true;
        return;
    }
    if (stored.has_spacing)
        return;
    stored.lattice.spacing = {1, 1, 1};
    stored.warnings.emplace_back(
        "the file gives no voxel size: 1 x 1 x 1 mm assumed, --spacing x,y,z sets it");
}

void require_thickness(const StoredLattice& lattice)
{
    for (const std::size_t size : lattice.size)
        if (size < 2)
            throw InputError("is " + std::to_string(lattice.size[0]) + " x " +
                             std::to_string(lattice.size[1]) + " x " + std::to_string(lattice.size[2]) +
                             " samples: a single slice is not a volume, expected at least 2 along each axis");
}

ReadVolume read(const std::filesystem::path& path, const ReadOptions& options)
{
    StoredVolume stored = choose_reader(path)(path, options);
    require_thickness(stored.lattice);
    apply_spacing(stored, options);
    return {.volume = make_volume(stored.lattice, std::move(stored.samples)),
            .format = std::move(stored.format),
            .stored_type = std::move(stored.stored_type),
            .has_spacing = stored.has_spacing,
            .warnings = std::move(stored.warnings)};
}

} // namespace

ReadVolume read_volume(const std::filesystem::path& path, const ReadOptions& options)
{
    try
    {
        return read(path, options);
    }
    catch (const InputError& error)
    {
        throw InputError(path.string() + ": " + error.what());
    }
    catch (const std::filesystem::filesystem_error& error)
    {
        throw InputError(path.string() + ": " + error.code().message());
    }
}

} // namespace voroprobe
