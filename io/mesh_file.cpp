#include "io/mesh_file.h"

#include <cctype>
#include <fstream>

#include "support/error.h"

namespace voroprobe
{

namespace fs = std::filesystem;

void fail_reading(const fs::path& path, const std::string& reason)
{
    throw InputError("cannot read '" + path.string() + "': " + reason);
}

std::string read_whole_file(const fs::path& path)
{
    std::ifstream in(path, std::ios::binary);
    std::error_code error;
    std::string content(fs::file_size(path, error), '\0');
    if (error || !in.read(content.data(), std::ssize(content)))
        fail_reading(path, "the file could not be read in full");
    return content;
}

std::string in_quotes(std::string_view word)
{
    constexpr std::size_t kLongest = 32;
    std::string text(1, '\'');
    for (const unsigned char c : word.substr(0, kLongest))
        text.push_back(std::isprint(c) != 0 ? static_cast<char>(c) : '?');
    return text.append(word.size() > kLongest ? "...'" : "'");
}

void append_fan(std::vector<TriangleMesh::Face>& faces, const std::vector<std::uint32_t>& polygon)
{
    for (std::size_t i = 2; i < polygon.size(); ++i)
        faces.push_back({polygon[0], polygon[i - 1], polygon[i]});
}

} // namespace voroprobe
