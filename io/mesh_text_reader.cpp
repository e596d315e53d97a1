#include "io/mesh_text_reader.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/mesh_file.h"

namespace voroprobe
{

namespace fs = std::filesystem;

namespace
{

//! Words of a line, and numbers as their programs wrote them whatever the locale.
class Line
{
public:
    explicit Line(std::string_view text) : text_(text) {}

    //! Next word, empty at the end of the line.
    std::string_view word()
    {
        constexpr std::string_view kBlanks = " \t\r\v\f";
        text_.remove_prefix(std::min(text_.find_first_not_of(kBlanks), text_.size()));
        const std::string_view result = text_.substr(0, text_.find_first_of(kBlanks));
        text_.remove_prefix(result.size());
        return result;
    }

    //! Next word as a number; nullopt when it is none.
    template <typename Number>
    std::optional<Number> number()
    {
        return parse_number<Number>(word());
    }

private:
    std::string_view text_;
};

//! The file line by line, with the line number for messages.
class LineReader
{
public:
    LineReader(const fs::path& path, std::string_view text) : path_(path), rest_(text) {}

    //! Next line; nullopt at the end of the file.
    std::optional<std::string_view> next()
    {
        if (rest_.empty())
            return std::nullopt;
        ++number_;
        const std::string_view line = rest_.substr(0, rest_.find('\n'));
        rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
        return line;
    }

    //! Next line that holds more than blanks and a comment.
    std::string_view next_with_content(const std::string& expected)
    {
        while (const auto line = next())
        {
            const std::string_view content = line->substr(0, line->find('#'));
            if (!Line(content).word().empty())
                return content;
        }
        fail("ends where " + expected + " is expected");
    }

    [[noreturn]] void fail(const std::string& reason) const
    {
        fail_reading(path_, "line " + std::to_string(number_) + " " + reason);
    }

    //! A file of n bytes holds fewer than n vertices or faces: what its header says need not be believed.
    [[nodiscard]] std::size_t bytes_left() const { return rest_.size(); }

private:
    const fs::path& path_;
    std::string_view rest_;
    std::size_t number_ = 0;
};

Point3 read_point(Line& line, const LineReader& file)
{
    const auto x = line.number<double>();
    const auto y = line.number<double>();
    const auto z = line.number<double>();
    if (!x || !y || !z)
        file.fail("does not hold the three coordinates of a vertex");
    return {*x, *y, *z};
}

// ---- OFF ----

struct OffCounts
{
    std::size_t vertices;
    std::size_t faces;
};

OffCounts read_off_header(LineReader& file)
{
    Line first(file.next_with_content("the word OFF"));
    const std::string_view keyword = first.word();
    if (!keyword.ends_with("OFF") || keyword.size() > 5)
        file.fail("does not begin with the word OFF");
    if (keyword.find('4') != std::string_view::npos || keyword.find('n') != std::string_view::npos)
        file.fail("announces vertices that are not three-dimensional");

    std::string_view word = first.word(); // the counts follow in this line or in the next
    if (word == "BINARY")
        file.fail("announces binary OFF; only text is read");
    std::optional<Line> second;
    if (word.empty())
        word = second.emplace(file.next_with_content("the number of vertices")).word();
    const auto vertices = parse_number<std::size_t>(word);
    const auto faces = (second ? *second : first).number<std::size_t>();
    if (!vertices || !faces)
        file.fail("does not hold the numbers of vertices and faces");
    if (*vertices > file.bytes_left() || *faces > file.bytes_left())
        file.fail("announces more vertices or faces than the file can hold");
    return {*vertices, *faces};
}

std::vector<std::uint32_t> read_off_polygon(LineReader& file, std::size_t vertex_count)
{
    Line line(file.next_with_content("a face"));
    const auto corners = line.number<std::size_t>();
    if (!corners || *corners > file.bytes_left() + vertex_count)
        file.fail("does not hold the number of corners of a face");
    std::vector<std::uint32_t> polygon;
    for (std::size_t i = 0; i < *corners; ++i)
    {
        const auto v = line.number<std::uint32_t>();
        if (!v || *v >= vertex_count)
            file.fail("does not name " + std::to_string(*corners) + " vertices from 0 to " +
                      std::to_string(vertex_count - 1));
        polygon.push_back(*v);
    }
    return polygon;
}

// ---- OBJ ----

//! "7", "7/1", "7//2", "7/1/2", or counted back from the newest vertex: "-1".
std::uint32_t obj_vertex(std::string_view word, std::size_t vertex_count, const LineReader& file)
{
    const auto number = parse_number<long long>(word.substr(0, word.find('/')));
    const auto count = static_cast<long long>(vertex_count);
    if (!number || *number == 0 || *number > count || *number < -count)
        file.fail("names the vertex " + in_quotes(word) + "; 1 to " + std::to_string(count) +
                  " are defined so far");
    return static_cast<std::uint32_t>(*number > 0 ? *number - 1 : count + *number);
}

std::vector<std::uint32_t> read_obj_polygon(Line& line, std::size_t vertex_count, const LineReader& file)
{
    std::vector<std::uint32_t> polygon;
    for (std::string_view word = line.word(); !word.empty() && word[0] != '#'; word = line.word())
        polygon.push_back(obj_vertex(word, vertex_count, file));
    if (polygon.size() < 3)
        file.fail("holds a face with fewer than three corners");
    return polygon;
}

} // namespace

TriangleMesh read_off(const fs::path& path)
{
    const std::string text = read_whole_file(path);
    LineReader file(path, text);
    const OffCounts counts = read_off_header(file);

    TriangleMesh mesh;
    mesh.vertices.reserve(counts.vertices);
    for (std::size_t v = 0; v < counts.vertices; ++v)
    {
        Line line(file.next_with_content("a vertex"));
        mesh.vertices.push_back(read_point(line, file));
    }
    mesh.faces.reserve(counts.faces);
    for (std::size_t f = 0; f < counts.faces; ++f)
        append_fan(mesh.faces, read_off_polygon(file, counts.vertices));
    return mesh;
}

TriangleMesh read_obj(const fs::path& path)
{
    const std::string text = read_whole_file(path);
    LineReader file(path, text);
    TriangleMesh mesh;
    while (const auto content = file.next())
    {
        Line line(*content);
        const std::string_view keyword = line.word();
        if (keyword == "v")
            mesh.vertices.push_back(read_point(line, file));
        else if (keyword == "f")
            append_fan(mesh.faces, read_obj_polygon(line, mesh.vertices.size(), file));
    }
    return mesh;
}

} // namespace voroprobe
