#pragma once

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/triangle_mesh.h"

//! What the readers of mesh files share.
namespace voroprobe
{

//! \throw InputError "cannot read 'PATH': REASON", always.
[[noreturn]] void fail_reading(const std::filesystem::path& path, const std::string& reason);

//! All bytes of a file. \throw InputError
std::string read_whole_file(const std::filesystem::path& path);

//! A word from a file, fit for a message: 'word', short, and without bytes a terminal could take for
//! commands.
std::string in_quotes(std::string_view word);

//! Cuts a polygon into triangles around its first corner. A polygon with fewer than three corners gives none.
void append_fan(std::vector<TriangleMesh::Face>& faces, const std::vector<std::uint32_t>& polygon);

//! The number a word is, whatever the locale; nullopt when it is none.
template <typename Number>
std::optional<Number> parse_number(std::string_view word)
{
    word.remove_prefix(word.starts_with('+') ? 1 : 0); // from_chars takes none
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = error == std::errc{} && end == word.data() + word.size();
    return whole ? std::optional(value) : std::nullopt;
}

} // namespace voroprobe
