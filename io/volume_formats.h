#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "io/volume_reader.h"
#include "volume/volume.h"

//! Inside of io/: what the reader of each format hands to read_volume. Messages of what these functions throw
//! do not name the path; read_volume puts it in front.
namespace voroprobe
{

//! A scalar 3D image as its file stores it.
struct StoredVolume
{
    StoredLattice lattice;
    SampleArray samples = {};
    std::string format;                     //!< as ReadVolume::format
    std::string stored_type = {};           //!< as ReadVolume::stored_type
    bool has_spacing = true;                //!< false where the file gives none
    std::vector<std::string> warnings = {}; //!< one line each
};

StoredVolume read_nifti(const std::filesystem::path& path, const ReadOptions& options);
StoredVolume read_nrrd(const std::filesystem::path& path, const ReadOptions& options);
StoredVolume read_meta_image(const std::filesystem::path& path, const ReadOptions& options);
StoredVolume read_inrimage(const std::filesystem::path& path, const ReadOptions& options);
StoredVolume read_vtk_image(const std::filesystem::path& path, const ReadOptions& options);

//! All pages of one TIFF file.
StoredVolume read_tiff_pages(const std::filesystem::path& path, const ReadOptions& options);

//! The single-page TIFF files of a folder in natural order of their names (2 before 10).
StoredVolume read_tiff_sequence(const std::filesystem::path& folder, const ReadOptions& options);

//! One DICOM file that holds a whole volume.
StoredVolume read_dicom_file(const std::filesystem::path& path, const ReadOptions& options);

//! One series of a folder, slices ordered by their position.
StoredVolume read_dicom_folder(const std::filesystem::path& folder, const ReadOptions& options);

} // namespace voroprobe
