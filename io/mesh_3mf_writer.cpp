#include "io/mesh_3mf.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string_view>

#include "io/lib3mf_handle.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

//! lib3mf writes six digits behind the point and drops the rest: half a unit of the last one makes that
//! rounding. Beyond `kLargestNudged` a float is too coarse to take it.
constexpr float kHalfLastDigit = 0.5e-6F;
constexpr float kLargestNudged = 8.0F;

//! What a reader gets back differs from what was meant by no more than half a digit and one unit in the last
//! place of a float, with something to spare.
constexpr double kAbsoluteTolerance = 1e-6;
constexpr double kRelativeTolerance = 0x1p-22;

[[noreturn]] void fail(const std::string& reason)
{
    throw OutputError("cannot write 3MF: " + reason);
}

void check(LIB3MFRESULT result, const Lib3mfHandle& object)
{
    if (result != 0)
        fail(lib3mf_reason(object));
}

// ---- Identity: 3MF names every object and item by a UUID; random ones would differ from run to run ----

//! Source: Fowler, Noll & Vo (FNV-1a), 64 bits.
class Fingerprint
{
public:
    explicit Fingerprint(std::uint64_t salt) { add(salt); }

    void add(std::uint64_t value)
    {
        for (int byte = 0; byte < 8; ++byte)
            state_ = (state_ ^ (value >> (8 * byte) & 0xFFU)) * 0x100000001B3U;
    }

    void add(const MeshPart& part)
    {
        for (const char c : part.name)
            add(static_cast<unsigned char>(c));
        for (const Point3& p : part.mesh.vertices)
            for (std::size_t axis = 0; axis < 3; ++axis)
                add(std::bit_cast<std::uint64_t>(p[axis]));
        add(part.mesh.faces.size());
    }

    [[nodiscard]] std::uint64_t value() const { return state_; }

private:
    std::uint64_t state_ = 0xCBF29CE484222325U;
};

//! 128 bits of a fingerprint and a number, as a UUID of version 8 (RFC 9562: made by the application).
std::string uuid(std::uint64_t fingerprint, std::uint64_t number)
{
    Fingerprint low(fingerprint);
    low.add(number);
    Fingerprint high(low.value());
    high.add(fingerprint);
    const std::uint64_t a = (high.value() & ~0xF000U) | 0x8000U;
    const std::uint64_t b = (low.value() & ~(3ULL << 62)) | 2ULL << 62;
    std::array<char, 37> text{};
    std::snprintf(text.data(), text.size(), "%08x-%04x-%04x-%04x-%012llx", static_cast<unsigned>(a >> 32),
                  static_cast<unsigned>(a >> 16 & 0xFFFFU), static_cast<unsigned>(a & 0xFFFFU),
                  static_cast<unsigned>(b >> 48), static_cast<unsigned long long>(b & 0xFFFFFFFFFFFFU));
    return text.data();
}

// ---- The model ----

//! XML knows no control characters.
std::string printable(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
    return text;
}

//! lib3mf writes the values of metadata as they are.
std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : printable(text))
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return result;
}

void add_description(const Lib3mfHandle& model, const std::vector<std::string>& comments)
{
    std::string description;
    for (const std::string& comment : comments)
        description += (description.empty() ? "" : "; ") + escaped(comment);
    check(NMR::lib3mf_model_addmetadatautf8(model.get(), "Application", "Voroprobe"), model);
    if (!description.empty())
        check(NMR::lib3mf_model_addmetadatautf8(model.get(), "Description", description.c_str()), model);
}

float stored(double x)
{
    const auto value = static_cast<float>(x);
    return std::abs(value) < kLargestNudged ? value + std::copysign(kHalfLastDigit, value) : value;
}

void fill(const Lib3mfHandle& object, const TriangleMesh& mesh)
{
    std::vector<NMR::MODELMESHVERTEX> vertices;
    vertices.reserve(mesh.vertices.size());
    for (const Point3& p : mesh.vertices)
        vertices.push_back({{stored(p.x), stored(p.y), stored(p.z)}});
    std::vector<NMR::MODELMESHTRIANGLE> triangles;
    triangles.reserve(mesh.faces.size());
    for (const TriangleMesh::Face& face : mesh.faces)
        triangles.push_back({{face[0], face[1], face[2]}});
    check(NMR::lib3mf_meshobject_setgeometry(object.get(), vertices.data(),
                                             static_cast<DWORD>(vertices.size()), triangles.data(),
                                             static_cast<DWORD>(triangles.size())),
          object);
}

//! One group of materials for the whole model, made when the first part with a colour comes.
class Palette
{
public:
    explicit Palette(const Lib3mfHandle& model) : model_(model) {}

    void paint(const Lib3mfHandle& object, const std::string& name, const Color& color)
    {
        if (group_.get() == nullptr)
            check(NMR::lib3mf_model_addbasematerialgroup(model_.get(), group_.receive()), model_);
        constexpr BYTE kOpaque = 255;
        DWORD group = 0;
        DWORD index = 0;
        check(NMR::lib3mf_basematerial_getresourceid(group_.get(), &group), group_);
        check(NMR::lib3mf_basematerial_addmaterialutf8(group_.get(), name.c_str(), color.red, color.green,
                                                       color.blue, &index),
              group_);
        check(NMR::lib3mf_basematerial_setdisplaycolorrgba(group_.get(), index, color.red, color.green,
                                                           color.blue, kOpaque),
              group_);
        Lib3mfHandle handler;
        check(NMR::lib3mf_object_createdefaultpropertyhandler(object.get(), handler.receive()), object);
        check(NMR::lib3mf_defaultpropertyhandler_setbasematerial(handler.get(), group, index), handler);
    }

private:
    const Lib3mfHandle& model_;
    Lib3mfHandle group_;
};

void add_part(const Lib3mfHandle& model, const MeshPart& part, std::uint64_t number, Palette& palette)
{
    Fingerprint fingerprint(number);
    fingerprint.add(part);
    Lib3mfHandle object;
    check(NMR::lib3mf_model_addmeshobject(model.get(), object.receive()), model);
    fill(object, part.mesh);
    const std::string name = printable(part.name);
    if (!name.empty())
        check(NMR::lib3mf_object_setnameutf8(object.get(), name.c_str()), object);
    check(NMR::lib3mf_object_setuuidutf8(object.get(), uuid(fingerprint.value(), 0).c_str()), object);
    if (part.color)
        palette.paint(object, name.empty() ? "part " + std::to_string(number) : name, *part.color);

    Lib3mfHandle item;
    check(NMR::lib3mf_model_addbuilditem(model.get(), object.get(), nullptr, item.receive()), model);
    check(NMR::lib3mf_builditem_setuuidutf8(item.get(), uuid(fingerprint.value(), 1).c_str()), item);
}

Lib3mfHandle model_of(std::span<const MeshPart> parts, const std::vector<std::string>& comments)
{
    Lib3mfHandle model;
    if (NMR::lib3mf_createmodel(model.receive()) != 0)
        fail("lib3mf makes no model");
    check(NMR::lib3mf_model_setunit(model.get(), NMR::MODELUNIT_MILLIMETER), model);
    add_description(model, comments);
    Palette palette(model);
    Fingerprint all(parts.size());
    for (std::uint64_t number = 0; number < parts.size(); ++number)
    {
        add_part(model, parts[number], number, palette);
        all.add(parts[number]);
    }
    check(NMR::lib3mf_model_setbuilduuidutf8(model.get(), uuid(all.value(), 2).c_str()), model);
    return model;
}

// ---- The proof ----

bool is_same(const Point3& written, const Point3& read)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (!(std::abs(written[axis] - read[axis]) <=
              kAbsoluteTolerance + kRelativeTolerance * std::abs(written[axis])))
            return false;
    return true;
}

bool is_same(const MeshPart& written, const MeshPart& read)
{
    return printable(written.name) == read.name && written.color == read.color &&
           written.mesh.faces == read.mesh.faces &&
           std::equal(written.mesh.vertices.begin(), written.mesh.vertices.end(), read.mesh.vertices.begin(),
                      read.mesh.vertices.end(),
                      [](const Point3& p, const Point3& q) { return is_same(p, q); });
}

void compare_with_package(std::span<const MeshPart> parts, std::string& package)
{
    const std::vector<MeshPart> read = parse_3mf(package, "what was written");
    if (read.size() != parts.size())
        fail("read back it holds " + std::to_string(read.size()) + " objects, and " +
             std::to_string(parts.size()) + " were written");
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (!is_same(parts[i], read[i]))
            fail("read back its object " + std::to_string(i + 1) + " ('" + printable(parts[i].name) +
                 "') is not what was written");
}

// ---- The package ----

//! Where lib3mf writes. A file of its own would do, but lib3mf ends the program where the disk is full.
struct MemoryFile
{
    std::string bytes;
    std::size_t position = 0;

    static BOOL write(const BYTE* data, const DWORD count, const void* file)
    {
        auto& self = of(file);
        const std::size_t end = self.position + count;
        self.bytes.resize(std::max(self.bytes.size(), end));
        std::copy(data, data + count, self.bytes.begin() + static_cast<std::ptrdiff_t>(self.position));
        self.position = end;
        return 0;
    }

    static BOOL seek(const ULONG64 position, const void* file)
    {
        of(file).position = position;
        return 0;
    }

private:
    static MemoryFile& of(const void* file) { return *static_cast<MemoryFile*>(const_cast<void*>(file)); }
};

std::string package_of(const Lib3mfHandle& model)
{
    Lib3mfHandle writer;
    check(NMR::lib3mf_model_querywriter(model.get(), "3mf", writer.receive()), model);
    MemoryFile file;
    check(NMR::lib3mf_writer_writetocallback(writer.get(), reinterpret_cast<void*>(&MemoryFile::write),
                                             reinterpret_cast<void*>(&MemoryFile::seek), &file),
          writer);
    return std::move(file.bytes);
}

} // namespace

void write_3mf(std::span<const MeshPart> parts, std::ostream& out, const std::vector<std::string>& comments)
{
    std::string package = package_of(model_of(parts, comments));
    compare_with_package(parts, package);
    out.write(package.data(), std::ssize(package));
}

} // namespace voroprobe
