#include "io/volume_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "support/error.h"
#include "support/memory.h"

namespace voroprobe
{

namespace
{

template <class To, class From, class Function>
std::vector<To> transformed(const std::vector<From>& from, const Function& function)
{
    std::vector<To> to;
    to.reserve(from.size());
    for (const From value : from)
        to.push_back(static_cast<To>(function(value)));
    return to;
}

template <class Sample>
Sample byte_swapped(Sample value)
{
    auto bytes = std::bit_cast<std::array<std::byte, sizeof(Sample)>>(value);
    std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<Sample>(bytes);
}

template <class Stored>
std::vector<Stored> read_stored(const SampleEncoding& encoding, std::size_t count,
                                const std::function<void(std::span<std::byte>)>& fill)
{
    std::vector<Stored> stored(count);
    fill(std::as_writable_bytes(std::span(stored)));
    if (encoding.order != std::endian::native && sizeof(Stored) > 1)
        for (Stored& value : stored)
            value = byte_swapped(value);
    return stored;
}

//! Whether every value times `slope` plus `intercept` is a whole number that fits `To`.
template <class To, class Stored>
bool all_fit(const std::vector<Stored>& stored, double slope, double intercept)
{
    if (std::trunc(slope) != slope || std::trunc(intercept) != intercept)
        return false;
    const auto [min, max] = std::minmax_element(stored.begin(), stored.end());
    const double a = slope * static_cast<double>(*min) + intercept;
    const double b = slope * static_cast<double>(*max) + intercept;
    return std::min(a, b) >= static_cast<double>(std::numeric_limits<To>::min()) &&
           std::max(a, b) <= static_cast<double>(std::numeric_limits<To>::max());
}

template <class Stored>
SampleArray rescaled(const std::vector<Stored>& stored, double slope, double intercept)
{
    const auto rescale = [=](Stored value) { return slope * static_cast<double>(value) + intercept; };
    if constexpr (std::is_integral_v<Stored>)
    {
        if (all_fit<std::int16_t>(stored, slope, intercept))
            return transformed<std::int16_t>(stored, rescale);
        if (all_fit<std::int32_t>(stored, slope, intercept))
            return transformed<std::int32_t>(stored, rescale);
    }
    if constexpr (sizeof(Stored) <= 2 || std::is_same_v<Stored, float>)
        return transformed<float>(stored, rescale);
    else
        return transformed<double>(stored, rescale);
}

//! Types that a Volume keeps as they are.
template <class Stored>
constexpr bool kIsKept = std::is_floating_point_v<Stored> ||
                         sizeof(Stored) <= 2 || std::is_same_v<Stored, std::int32_t>;

//! Whether a double holds the number exactly: at most 53 bits from its first to its last that is set.
template <class Integer>
bool fits_double(Integer value)
{
    using Bits = std::make_unsigned_t<Integer>;
    const Bits magnitude = value < 0 ? Bits{0} - static_cast<Bits>(value) : static_cast<Bits>(value);
    const int last = std::countr_zero(magnitude);
    const int end = std::numeric_limits<Bits>::digits - std::countl_zero(magnitude);
    return end - last <= std::numeric_limits<double>::digits;
}

template <class Stored>
void warn_of_rounding(const std::vector<Stored>& stored, std::vector<std::string>& warnings)
{
    if constexpr (std::is_integral_v<Stored> && sizeof(Stored) > sizeof(std::int32_t))
        if (const auto rounded = stored.size() - static_cast<std::size_t>(std::count_if(
                                                     stored.begin(), stored.end(), fits_double<Stored>));
            rounded > 0)
            warnings.push_back("samples that are whole numbers beyond 2^53 and lose their last digits: " +
                               std::to_string(rounded) + " (kept as 64-bit floating-point numbers)");
}

template <class Stored>
SampleArray decode(const SampleEncoding& encoding, std::size_t count,
                   const std::function<void(std::span<std::byte>)>& fill, std::vector<std::string>& warnings)
{
    std::vector<Stored> stored = read_stored<Stored>(encoding, count, fill);
    warn_of_rounding(stored, warnings);
    if (encoding.slope != 1.0 || encoding.intercept != 0.0)
        return rescaled(stored, encoding.slope, encoding.intercept);
    if constexpr (kIsKept<Stored>)
        return stored;
    else if (all_fit<std::int32_t>(stored, 1.0, 0.0))
        return transformed<std::int32_t>(stored, [](Stored value) { return value; });
    else
        return transformed<double>(stored, [](Stored value) { return value; });
}

std::string dimensions_text(std::span<const std::int64_t> size)
{
    std::string text;
    for (const std::int64_t n : size)
        text += (text.empty() ? "" : " x ") + std::to_string(n);
    return text;
}

} // namespace

std::string_view stored_type_name(StoredType type)
{
    static constexpr std::array<std::string_view, 10> kNames{
        "uint8", "int8", "uint16", "int16", "uint32", "int32", "uint64", "int64", "float32", "float64"};
    return kNames[static_cast<std::size_t>(type)];
}

std::size_t byte_size(StoredType type)
{
    static constexpr std::array<std::size_t, 10> kSizes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
    return kSizes[static_cast<std::size_t>(type)];
}

std::size_t require_sane_size(std::span<const std::int64_t> size, std::size_t bytes_per_sample)
{
    const std::size_t memory = total_memory_bytes();
    const std::size_t limit =
        (memory > 0 ? memory : std::numeric_limits<std::size_t>::max()) / bytes_per_sample;
    std::size_t count = 1;
    bool fits = true;
    for (const std::int64_t n : size)
    {
        if (n < 1)
            throw InputError("the header gives the size " + dimensions_text(size) +
                             ", expected numbers of at least 1");
        fits = fits && !__builtin_mul_overflow(count, static_cast<std::size_t>(n), &count) && count <= limit;
    }
    if (!fits)
        throw InputError("the header announces " + dimensions_text(size) + " samples of " +
                         std::to_string(bytes_per_sample) + " bytes, more than the memory of this machine, " +
                         std::to_string(memory) + " bytes");
    return count;
}

std::size_t choose_frame(std::size_t frame_count, const std::optional<std::size_t>& chosen)
{
    if (!chosen && frame_count > 1)
        throw InputError("holds " + std::to_string(frame_count) +
                         " volumes, expected one: choose with --frame 0 to " +
                         std::to_string(frame_count - 1));
    if (chosen && *chosen >= frame_count)
        throw InputError("has no frame " + std::to_string(*chosen) + ", expected 0 to " +
                         std::to_string(frame_count - 1));
    return chosen.value_or(0);
}

SampleArray decode_samples(const SampleEncoding& encoding, std::size_t count,
                           const std::function<void(std::span<std::byte>)>& fill,
                           std::vector<std::string>& warnings)
{
    switch (encoding.type)
    {
    case StoredType::kUint8:
        return decode<std::uint8_t>(encoding, count, fill, warnings);
    case StoredType::kInt8:
        return decode<std::int8_t>(encoding, count, fill, warnings);
    case StoredType::kUint16:
        return decode<std::uint16_t>(encoding, count, fill, warnings);
    case StoredType::kInt16:
        return decode<std::int16_t>(encoding, count, fill, warnings);
    case StoredType::kUint32:
        return decode<std::uint32_t>(encoding, count, fill, warnings);
    case StoredType::kInt32:
        return decode<std::int32_t>(encoding, count, fill, warnings);
    case StoredType::kUint64:
        return decode<std::uint64_t>(encoding, count, fill, warnings);
    case StoredType::kInt64:
        return decode<std::int64_t>(encoding, count, fill, warnings);
    case StoredType::kFloat32:
        return decode<float>(encoding, count, fill, warnings);
    case StoredType::kFloat64:
        return decode<double>(encoding, count, fill, warnings);
    }
    throw InputError("unknown sample type");
}

} // namespace voroprobe
