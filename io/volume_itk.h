#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <itkImageIOBase.h>

#include "io/volume_formats.h"
#include "io/volume_samples.h"

//! Inside of io/: the use of ITK's image readers without their factories and filters.
namespace voroprobe
{

//! Runs ITK code with its own printing switched off. \throw InputError with the last line of what ITK threw,
//! which is where the reason stands.
void with_itk(const std::function<void()>& action);

//! Opens `path` and reads its header. \throw InputError.
void read_itk_header(itk::ImageIOBase& image_io, const std::filesystem::path& path);

//! The first three axes of an image. \throw InputError where it has fewer.
StoredLattice itk_lattice(const itk::ImageIOBase& image_io);

//! \throw InputError where the pixels are not single real numbers.
StoredType itk_stored_type(const itk::ImageIOBase& image_io);

//! The type of each of the numbers of a pixel. \throw InputError where they are not real.
StoredType itk_component_type(const itk::ImageIOBase& image_io);

//! Of pixels of several numbers, those at the place that `frame` chooses: layers of a segmentation. Refuses
//! and warns as below. \throw InputError.
SampleArray read_itk_component(itk::ImageIOBase& image_io, const std::optional<std::size_t>& frame,
                               std::vector<std::string>& warnings);

//! The samples of the volume that `frame` chooses. Refuses sizes beyond memory before allocating; warns as
//! decode_samples. \throw InputError.
SampleArray read_itk_samples(itk::ImageIOBase& image_io, const std::optional<std::size_t>& frame,
                             std::vector<std::string>& warnings);

} // namespace voroprobe
