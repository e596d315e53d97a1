#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace voroprobe
{

//! Whether a file carries DICOM's mark at byte 128. False where it cannot be read.
bool has_dicom_mark(const std::filesystem::path& path);

//! What a look at the top-level data elements of a DICOM file tells.
struct DicomOutline
{
    std::optional<std::string> series_uid =
        std::nullopt;       //!< Series Instance UID; unset where it was not found
    bool has_pixels = true; //!< false where all elements were seen and none was Pixel Data
};

//! Walks the data elements up to the pixel data, checking that each lies within the file. GDCM is given only
//! files that passed: it fills up short pixel data, and as Debian builds it, it aborts on files that end
//! within an element. Where a file is written in a way not known here, the walk ends early and the outline
//! has what was found. \throw InputError where the file has no DICOM mark or ends within an element. Cost:
//! reads the file.
DicomOutline read_dicom_outline(const std::filesystem::path& path);

} // namespace voroprobe
