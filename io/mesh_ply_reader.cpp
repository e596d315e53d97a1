#include "io/mesh_ply_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "io/mesh_file.h"

namespace voroprobe
{

// This file follows: Greg Turk, "The PLY Polygon File Format", 1994.

namespace fs = std::filesystem;

namespace
{

enum class Type
{
    kInt8,
    kUint8,
    kInt16,
    kUint16,
    kInt32,
    kUint32,
    kFloat32,
    kFloat64
};

std::optional<Type> type_named(std::string_view name)
{
    struct NamedType
    {
        std::string_view old_name;
        std::string_view name;
        Type type;
    };
    constexpr std::array<NamedType, 8> kTypes{{{"char", "int8", Type::kInt8},
                                               {"uchar", "uint8", Type::kUint8},
                                               {"short", "int16", Type::kInt16},
                                               {"ushort", "uint16", Type::kUint16},
                                               {"int", "int32", Type::kInt32},
                                               {"uint", "uint32", Type::kUint32},
                                               {"float", "float32", Type::kFloat32},
                                               {"double", "float64", Type::kFloat64}}};
    for (const NamedType& type : kTypes)
        if (name == type.old_name || name == type.name)
            return type.type;
    return std::nullopt;
}

struct Property
{
    std::string name;
    Type type = Type::kFloat32;
    std::optional<Type> count_type; //!< set: a list, whose length comes first
};

struct Element
{
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
};

enum class Encoding
{
    kText,
    kLittleEndian,
    kBigEndian
};

struct Header
{
    Encoding encoding = Encoding::kText;
    std::vector<Element> elements;
    std::size_t size = 0; //!< bytes
};

// ---- Header ----

class HeaderParser
{
public:
    HeaderParser(const fs::path& path, std::string_view content) : path_(path), content_(content) {}

    Header parse()
    {
        if (next_line() != "ply")
            fail("does not begin with the word ply");
        for (std::string line = next_line(); line != "end_header"; line = next_line())
            parse_line(line);
        return std::move(header_);
    }

private:
    std::string next_line()
    {
        const std::size_t end = content_.find('\n', header_.size);
        if (end == std::string_view::npos)
            fail("is the last; the header has no end");
        std::string line(content_.substr(header_.size, end - header_.size));
        header_.size = end + 1;
        ++line_number_;
        line.erase(line.find_last_not_of(" \t\r") + 1);
        return line;
    }

    void parse_line(const std::string& line)
    {
        std::istringstream words(line);
        std::string keyword;
        words >> keyword;
        if (keyword == "format")
            parse_format(words);
        else if (keyword == "element")
            parse_element(words);
        else if (keyword == "property")
            parse_property(words);
        else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty())
            fail("holds the unknown keyword " + in_quotes(keyword));
    }

    void parse_format(std::istream& words)
    {
        std::string name;
        words >> name;
        if (name == "ascii")
            header_.encoding = Encoding::kText;
        else if (name == "binary_little_endian")
            header_.encoding = Encoding::kLittleEndian;
        else if (name == "binary_big_endian")
            header_.encoding = Encoding::kBigEndian;
        else
            fail("names the unknown format " + in_quotes(name));
    }

    void parse_element(std::istream& words)
    {
        Element element;
        if (!(words >> element.name >> element.count))
            fail("does not hold the name and number of an element");
        if (element.count > content_.size())
            fail("announces " + std::to_string(element.count) + " times " + in_quotes(element.name) +
                 ", more than the file can hold");
        header_.elements.push_back(std::move(element));
    }

    void parse_property(std::istream& words)
    {
        if (header_.elements.empty())
            fail("holds a property of no element");
        Property property;
        std::string type;
        words >> type;
        if (type == "list")
        {
            words >> type;
            property.count_type = known_type(type);
            words >> type;
        }
        property.type = known_type(type);
        if (!(words >> property.name))
            fail("holds a property without a name");
        header_.elements.back().properties.push_back(std::move(property));
    }

    [[nodiscard]] Type known_type(const std::string& name) const
    {
        if (const auto type = type_named(name))
            return *type;
        fail("names the unknown type " + in_quotes(name));
    }

    [[noreturn]] void fail(const std::string& reason) const
    {
        fail_reading(path_, "line " + std::to_string(line_number_) + " " + reason);
    }

    const fs::path& path_;
    std::string_view content_;
    std::size_t line_number_ = 0;
    Header header_;
};

// ---- Values ----

//! The values behind the header, one after the other. Every type fits a double exactly.
class Values
{
public:
    Values(const fs::path& path, std::string_view content, Encoding encoding)
        : path_(path), rest_(content), encoding_(encoding)
    {
    }

    double next(Type type) { return encoding_ == Encoding::kText ? next_in_text() : next_in_binary(type); }

    //! A number of things that each take at least one byte, so that a wrong one is noticed before memory is
    //! asked for.
    std::size_t next_count(Type type)
    {
        const double value = next(type);
        if (!(value >= 0.0 && value <= static_cast<double>(rest_.size())) || value != std::floor(value))
            fail_reading(path_, "a list announces " + std::to_string(value) +
                                    " values, more than the file can hold");
        return static_cast<std::size_t>(value);
    }

private:
    double next_in_text()
    {
        constexpr std::string_view kBlanks = " \t\r\n\v\f";
        rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
        const std::string_view word = rest_.substr(0, rest_.find_first_of(kBlanks));
        rest_.remove_prefix(word.size());
        if (word.empty())
            fail_reading(path_, "it ends where a number is expected");
        if (const auto value = parse_number<double>(word))
            return *value;
        fail_reading(path_, in_quotes(word) + " stands where a number is expected");
    }

    double next_in_binary(Type type)
    {
        switch (type)
        {
        case Type::kInt8:
            return take<std::int8_t>();
        case Type::kUint8:
            return take<std::uint8_t>();
        case Type::kInt16:
            return take<std::int16_t>();
        case Type::kUint16:
            return take<std::uint16_t>();
        case Type::kInt32:
            return take<std::int32_t>();
        case Type::kUint32:
            return take<std::uint32_t>();
        case Type::kFloat32:
            return static_cast<double>(take<float>());
        case Type::kFloat64:
            return take<double>();
        }
        return 0.0;
    }

    template <typename Number>
    Number take()
    {
        if (rest_.size() < sizeof(Number))
            fail_reading(path_, "it is shorter than its header says");
        std::array<char, sizeof(Number)> bytes;
        std::copy_n(rest_.begin(), bytes.size(), bytes.begin());
        rest_.remove_prefix(bytes.size());
        const bool file_is_little = encoding_ == Encoding::kLittleEndian;
        if (file_is_little != (std::endian::native == std::endian::little))
            std::reverse(bytes.begin(), bytes.end());
        return std::bit_cast<Number>(bytes);
    }

    const fs::path& path_;
    std::string_view rest_;
    Encoding encoding_;
};

// ---- Elements ----

//! The values of one property of one element: one, or those of a list.
void read_property(const Property& property, Values& values, std::vector<double>& result)
{
    result.resize(property.count_type ? values.next_count(*property.count_type) : 1);
    for (double& value : result)
        value = values.next(property.type);
}

void skip_element(const Element& element, Values& values)
{
    std::vector<double> ignored;
    for (std::size_t i = 0; !element.properties.empty() && i < element.count; ++i)
        for (const Property& property : element.properties)
            read_property(property, values, ignored);
}

//! For each property 0, 1 or 2 where it is x, y or z.
std::vector<std::optional<std::size_t>> axes_of(const Element& element, const fs::path& path)
{
    std::vector<std::optional<std::size_t>> axes;
    std::size_t found = 0;
    for (const Property& property : element.properties)
    {
        constexpr std::string_view kNames = "xyz";
        const std::size_t axis =
            property.name.size() == 1 ? kNames.find(property.name[0]) : std::string_view::npos;
        const bool is_coordinate = axis != std::string_view::npos && !property.count_type;
        axes.push_back(is_coordinate ? std::optional(axis) : std::nullopt);
        found += is_coordinate ? 1 : 0;
    }
    if (found != 3)
        fail_reading(path, "its vertices do not have the properties x, y and z");
    return axes;
}

void read_vertices(const Element& element, Values& values, const fs::path& path,
                   std::vector<Point3>& vertices)
{
    const auto axes = axes_of(element, path);
    std::vector<double> property_values;
    vertices.resize(element.count);
    for (Point3& p : vertices)
        for (std::size_t i = 0; i < axes.size(); ++i)
        {
            read_property(element.properties[i], values, property_values);
            if (axes[i])
                p[*axes[i]] = property_values[0];
        }
}

bool names_the_corners(const Property& property)
{
    return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
}

std::vector<std::uint32_t> polygon_of(const std::vector<double>& corners, const fs::path& path)
{
    std::vector<std::uint32_t> polygon;
    for (const double corner : corners)
    {
        if (!(corner >= 0.0 && corner < 0x1.0p32))
            fail_reading(path, "a face names the vertex " + std::to_string(corner));
        polygon.push_back(static_cast<std::uint32_t>(corner));
    }
    return polygon;
}

void read_faces(const Element& element, Values& values, const fs::path& path,
                std::vector<TriangleMesh::Face>& faces)
{
    std::vector<double> property_values;
    for (std::size_t f = 0; f < element.count; ++f)
        for (const Property& property : element.properties)
        {
            read_property(property, values, property_values);
            if (names_the_corners(property))
                append_fan(faces, polygon_of(property_values, path));
        }
}

} // namespace

TriangleMesh read_ply(const fs::path& path)
{
    const std::string content = read_whole_file(path);
    const Header header = HeaderParser(path, content).parse();
    Values values(path, std::string_view(content).substr(header.size), header.encoding);

    TriangleMesh mesh;
    for (const Element& element : header.elements)
    {
        if (element.name == "vertex")
            read_vertices(element, values, path, mesh.vertices);
        else if (element.name == "face")
            read_faces(element, values, path, mesh.faces);
        else
            skip_element(element, values);
    }
    return mesh;
}

} // namespace voroprobe
