#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "volume/volume.h"

namespace voroprobe
{

//! Types that files store samples in.
enum class StoredType
{
    kUint8,
    kInt8,
    kUint16,
    kInt16,
    kUint32,
    kInt32,
    kUint64,
    kInt64,
    kFloat32,
    kFloat64
};

//! "uint8" etc.
std::string_view stored_type_name(StoredType type);
std::size_t byte_size(StoredType type);

//! How bytes become sample values.
struct SampleEncoding
{
    StoredType type;
    std::endian order = std::endian::native;
    double slope = 1.0; //!< value = slope * stored + intercept
    double intercept = 0.0;
};

//! Number of samples of an image of this size, from the numbers of its header. \throw InputError where a
//! number is below 1, or the samples would need more bytes than this machine has memory. Nothing is
//! allocated.
std::size_t require_sane_size(std::span<const std::int64_t> size, std::size_t bytes_per_sample);

//! Which of the `frame_count` volumes of a file to read. \throw InputError where there are several and none
//! was chosen, or the chosen one is not there.
std::size_t choose_frame(std::size_t frame_count, const std::optional<std::size_t>& chosen);

//! Lets `fill` write `count` samples as stored and turns them into values: byte order, wide integers to int32
//! where all of them fit and to double otherwise, slope and intercept (whole ones keep integers, others make
//! float32 of types up to 16 bits and float64 of wider ones). Appends a warning where samples need more than
//! the 53 bits of a double.
SampleArray decode_samples(const SampleEncoding& encoding, std::size_t count,
                           const std::function<void(std::span<std::byte>)>& fill,
                           std::vector<std::string>& warnings);

} // namespace voroprobe
