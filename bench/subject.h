#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "volume/volume.h"

namespace voroprobe::bench
{

//! A volume, the isovalue that suits it and its name.
struct Subject
{
    Volume volume;
    double isovalue;
    std::string name;
    std::optional<std::filesystem::path> file; //!< that it was read from
};

//! x^2 + y^2 + z^2 + sin 4x + sin 4y + sin 4z = 0: nested and separate components (Feree & Alliez 2009, Fig.
//! 8), over [-2.5, 2.5]^3 stretched to one scan unit per sample.
Subject make_phantom(std::size_t side);

//! cranium_ct.nrrd in the folder of large volumes ($VOROPROBE_DATA, else ../shared/data) where it is there,
//! else headsq_ct.nrrd of testdata. `isovalue` in place of the one that suits it.
Subject read_default_subject(std::optional<double> isovalue = std::nullopt);

//! headsq_ct.nrrd of testdata.
Subject read_shipped_subject(std::optional<double> isovalue = std::nullopt);

Subject read_subject(const std::filesystem::path& file, double isovalue);

} // namespace voroprobe::bench
