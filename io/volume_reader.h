#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/vec3.h"
#include "volume/volume.h"

namespace voroprobe
{

//! How to read a volume when the file alone does not settle it.
struct ReadOptions
{
    std::optional<Vec3> spacing =
        std::nullopt; //!< --spacing: scan units, > 0; overrides or supplies the file's
    std::optional<std::size_t> frame = std::nullopt; //!< --frame: which 3D volume of a 4D file, from 0
    std::optional<std::string> series =
        std::nullopt; //!< --series: DICOM series instance UID, or a unique part of it
    std::optional<std::string> grid = std::nullopt; //!< --grid: name of the grid of a .vdb file
};

//! A volume and what there is to say about how it was read.
struct ReadVolume
{
    Volume volume;
    std::string format;      //!< "NIfTI", "NRRD", "MetaImage", "TIFF", "DICOM", "Inrimage", "VTK image data"
    std::string stored_type; //!< sample type in the file, "int16" etc., before slope and intercept
    bool has_spacing = true; //!< false where the file gives none and 1 mm was assumed
    std::vector<std::string> warnings; //!< one line each, for the user
};

//! Reads any supported volume: a file, or a folder with a DICOM series or a TIFF sequence. Format by content
//! where the name does not tell. \throw InputError with one line that names the path, what is wrong and what
//! was expected. Headers that announce more samples than this machine's memory could hold are refused before
//! anything is allocated.
ReadVolume read_volume(const std::filesystem::path& path, const ReadOptions& options = {});

} // namespace voroprobe
