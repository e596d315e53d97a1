#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace voroprobe
{

enum class Packing
{
    kPlain,       //!< the file as it is
    kPlainOrGzip, //!< the file as it is or, where it is a gzip file, its content
    kZlib         //!< a zlib or gzip stream that starts at the offset
};

//! A run of bytes cut into equal parts, one in each file.
struct ByteSource
{
    std::vector<std::filesystem::path> files;
    std::uint64_t offset =
        0; //!< of the first byte of each part: in the content, or in the file of a kZlib stream
    std::uint64_t skip = 0; //!< bytes of each part's content to pass over after the offset
    Packing packing = Packing::kPlain;
};

//! Refuses a source that is too short for `byte_count` bytes whatever it holds, before anything is allocated.
//! \throw InputError that says how many there are and how many were expected.
void require_bytes(const ByteSource& source, std::uint64_t byte_count);

//! Fills `to`. \throw InputError where the content is shorter or damaged.
void read_bytes(const ByteSource& source, std::span<std::byte> to);

//! Up to `count` bytes from the start of a file, the content where it is a gzip file. \throw InputError.
std::string read_head(const std::filesystem::path& path, std::size_t count);

} // namespace voroprobe
