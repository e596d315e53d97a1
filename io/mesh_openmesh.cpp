#include "io/mesh_openmesh.h"

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/exporter/BaseExporter.hh>
#include <OpenMesh/Core/Mesh/BaseKernel.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <algorithm>
#include <bit>
#include <cctype>
#include <cstring>
#include <locale>
#include <streambuf>

#include "support/error.h"

namespace voroprobe
{

namespace
{

namespace om = OpenMesh;

//! Decimal digits that give back the very float also where a reader parses them as double.
constexpr std::streamsize kDigits = 17;

constexpr std::size_t kStlHeaderBytes = 80;

const std::vector<Vec3> kNoNormals;

//! Lets OpenMesh's writers read our mesh in place. Filling one of OpenMesh's own meshes instead would cost
//! about 100 bytes a face, and leave out, without failing, every face that its half-edges cannot represent.
class MeshExporter final : public om::IO::BaseExporter
{
public:
    MeshExporter(const TriangleMesh& mesh, const std::vector<Vec3>& normals) : mesh_(mesh), normals_(normals)
    {
    }

    om::Vec3f point(om::VertexHandle v) const override
    {
        const Point3& p = mesh_.vertices[static_cast<std::size_t>(v.idx())];
        return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    }
    om::Vec3d pointd(om::VertexHandle v) const override
    {
        const Point3& p = mesh_.vertices[static_cast<std::size_t>(v.idx())];
        return {p.x, p.y, p.z};
    }
    bool is_point_double() const override { return false; }
    unsigned int get_vhandles(om::FaceHandle f, std::vector<om::VertexHandle>& handles) const override
    {
        handles.clear();
        for (const std::uint32_t v : mesh_.faces[static_cast<std::size_t>(f.idx())])
            handles.emplace_back(static_cast<int>(v));
        return 3;
    }
    std::size_t n_vertices() const override { return mesh_.vertices.size(); }
    std::size_t n_faces() const override { return mesh_.faces.size(); }
    std::size_t n_edges() const override { return 0; }
    bool is_triangle_mesh() const override { return true; }
    const om::BaseKernel* kernel() override { return &no_properties_; }

    bool has_vertex_normals() const override { return !normals_.empty(); }
    om::Vec3d normald(om::VertexHandle v) const override
    {
        if (normals_.empty()) // asked all the same, for OBJ
            return {};
        const Vec3& n = normals_[static_cast<std::size_t>(v.idx())];
        return {n.x, n.y, n.z};
    }
    om::Vec3f normal(om::VertexHandle v) const override { return om::Vec3f(normald(v)); }

    // The mesh has nothing else; the has_...() of the base class say so, and no writer asks for the
    // following.
    bool is_normal_double() const override { return false; }
    om::Vec3uc color(om::VertexHandle) const override { return om::Vec3uc(0, 0, 0); }
    om::Vec4uc colorA(om::VertexHandle) const override { return om::Vec4uc(0, 0, 0, 0); }
    om::Vec3ui colori(om::VertexHandle) const override { return {}; }
    om::Vec4ui colorAi(om::VertexHandle) const override { return {}; }
    om::Vec3f colorf(om::VertexHandle) const override { return {}; }
    om::Vec4f colorAf(om::VertexHandle) const override { return {}; }
    om::Vec2f texcoord(om::VertexHandle) const override { return {}; }
    om::Vec2f texcoord(om::HalfedgeHandle) const override { return {}; }
    om::Attributes::StatusInfo status(om::VertexHandle) const override { return {}; }
    om::HalfedgeHandle getHeh(om::FaceHandle, om::VertexHandle) const override
    {
        return om::HalfedgeHandle();
    }
    unsigned int get_face_texcoords(std::vector<om::Vec2f>&) const override { return 0; }
    om::Vec3f normal(om::FaceHandle) const override { return {}; }
    om::Vec3d normald(om::FaceHandle) const override { return {}; }
    om::Vec3uc color(om::FaceHandle) const override { return om::Vec3uc(0, 0, 0); }
    om::Vec4uc colorA(om::FaceHandle) const override { return om::Vec4uc(0, 0, 0, 0); }
    om::Vec3ui colori(om::FaceHandle) const override { return {}; }
    om::Vec4ui colorAi(om::FaceHandle) const override { return {}; }
    om::Vec3f colorf(om::FaceHandle) const override { return {}; }
    om::Vec4f colorAf(om::FaceHandle) const override { return {}; }
    om::Attributes::StatusInfo status(om::FaceHandle) const override { return {}; }
    om::Vec3uc color(om::EdgeHandle) const override { return om::Vec3uc(0, 0, 0); }
    om::Vec4uc colorA(om::EdgeHandle) const override { return om::Vec4uc(0, 0, 0, 0); }
    om::Vec3ui colori(om::EdgeHandle) const override { return {}; }
    om::Vec4ui colorAi(om::EdgeHandle) const override { return {}; }
    om::Vec3f colorf(om::EdgeHandle) const override { return {}; }
    om::Vec4f colorAf(om::EdgeHandle) const override { return {}; }
    om::Attributes::StatusInfo status(om::EdgeHandle) const override { return {}; }
    om::Attributes::StatusInfo status(om::HalfedgeHandle) const override { return {}; }
    int get_halfedge_id(om::VertexHandle) override { return -1; }
    int get_halfedge_id(om::FaceHandle) override { return -1; }
    int get_next_halfedge_id(om::HalfedgeHandle) override { return -1; }
    int get_to_vertex_id(om::HalfedgeHandle) override { return -1; }
    int get_face_id(om::HalfedgeHandle) override { return -1; }

private:
    const TriangleMesh& mesh_;
    const std::vector<Vec3>& normals_; //!< one for each vertex, or none
    om::BaseKernel no_properties_;
};

//! OpenMesh tells the user what it writes; a library should not. Process-wide while an object of this kind
//! lives.
class OpenMeshSilence
{
public:
    OpenMeshSilence()
    {
        ::omlog().disable();
        ::omerr().disable();
    }
    OpenMeshSilence(const OpenMeshSilence&) = delete;
    OpenMeshSilence& operator=(const OpenMeshSilence&) = delete;
    ~OpenMeshSilence()
    {
        if (log_was_enabled_)
            ::omlog().enable();
        if (errors_were_enabled_)
            ::omerr().enable();
    }

private:
    bool log_was_enabled_ = ::omlog().is_enabled();
    bool errors_were_enabled_ = ::omerr().is_enabled();
};

//! Passes bytes on and puts `text` after the `count`-th `mark`. OpenMesh's writers leave no room for
//! comments.
class InsertingBuffer final : public std::streambuf
{
public:
    InsertingBuffer(std::streambuf& sink, char mark, int count, std::string text)
        : sink_(sink), mark_(mark), marks_left_(count), text_(std::move(text))
    {
    }

protected:
    int_type overflow(int_type c) override
    {
        const char byte = traits_type::to_char_type(c);
        return xsputn(&byte, 1) == 1 ? c : traits_type::eof();
    }

    std::streamsize xsputn(const char* bytes, std::streamsize count) override
    {
        std::streamsize done = 0;
        while (marks_left_ > 0 && done < count)
        {
            if (traits_type::eq_int_type(sink_.sputc(bytes[done]), traits_type::eof()))
                return done;
            const bool now = bytes[done] == mark_ && --marks_left_ == 0;
            if (now && sink_.sputn(text_.data(), std::ssize(text_)) != std::ssize(text_))
                return done;
            ++done;
        }
        return done + sink_.sputn(bytes + done, count - done);
    }

private:
    std::streambuf& sink_;
    char mark_;
    int marks_left_;
    std::string text_;
};

//! One printable line: a line end or a stray byte inside a comment would break the file.
std::string one_line(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
    return text;
}

std::string lines_with_prefix(const std::string& prefix, const std::vector<std::string>& comments)
{
    std::string lines;
    for (const std::string& comment : comments)
        lines += prefix + one_line(comment) + "\n";
    return lines;
}

//! The comments as name of a solid. It starts with our name: a binary file that starts with "solid" is taken
//! for text.
std::string solid_name(const std::vector<std::string>& comments)
{
    std::string name;
    for (const std::string& comment : comments)
        name += (name.empty() ? "" : "; ") + one_line(comment);
    if (!name.starts_with("voroprobe"))
        name = name.empty() ? "voroprobe" : "voroprobe; " + name;
    return name.substr(0, kStlHeaderBytes);
}

void run_openmesh(MeshExporter exporter, std::ostream& out, const std::string& extension,
                  om::IO::Options options)
{
    const OpenMeshSilence silence;
    if (exporter.has_vertex_normals())
        options += om::IO::Options::VertexNormal;
    out.imbue(std::locale::classic());
    if (!om::IO::IOManager().write(out, extension, exporter, options, kDigits))
        throw OutputError("OpenMesh cannot write '" + extension + "'");
}

void run_openmesh_inserting(InsertingBuffer& buffer, const MeshExporter& exporter, std::ostream& out,
                            const std::string& extension, const om::IO::Options& options)
{
    std::ostream inserting(&buffer);
    inserting.exceptions(out.exceptions());
    run_openmesh(exporter, inserting, extension, options);
}

//! One face of a binary STL file: its normal, its corners, and no attributes.
constexpr std::size_t kStlFaceBytes = 50;

char* put(const om::Vec3f& v, char* to)
{
    std::memcpy(to, v.data(), 3 * sizeof(float));
    return to + 3 * sizeof(float);
}

//! OpenMesh's own writer calls the stream for every number: eight times as long.
void write_stl_binary(const TriangleMesh& mesh, std::ostream& out, const std::vector<std::string>& comments)
{
    static_assert(std::endian::native == std::endian::little);
    constexpr std::size_t kFacesAtOnce = 4096;
    std::string header = solid_name(comments);
    header.resize(kStlHeaderBytes, ' ');
    out.write(header.data(), std::ssize(header));
    const auto count = static_cast<std::uint32_t>(mesh.faces.size());
    out.write(reinterpret_cast<const char*>(&count), sizeof count);

    const MeshExporter exporter(mesh, kNoNormals);
    const auto point = [&](std::uint32_t v) { return exporter.point(om::VertexHandle(static_cast<int>(v))); };
    std::vector<char> bytes(kFacesAtOnce * kStlFaceBytes, 0);
    for (std::size_t first = 0; first < mesh.faces.size(); first += kFacesAtOnce)
    {
        const std::size_t end = std::min(mesh.faces.size(), first + kFacesAtOnce);
        for (std::size_t f = first; f < end; ++f)
        {
            const om::Vec3f a = point(mesh.faces[f][0]);
            const om::Vec3f b = point(mesh.faces[f][1]);
            const om::Vec3f c = point(mesh.faces[f][2]);
            const om::Vec3f normal = ((c - b) % (a - b)).normalize_cond(); // 0 0 0 without area
            char* to = bytes.data() + (f - first) * kStlFaceBytes;
            for (const om::Vec3f& v : {normal, a, b, c})
                to = put(v, to);
        }
        out.write(bytes.data(), static_cast<std::streamsize>((end - first) * kStlFaceBytes));
    }
}

} // namespace

void write_with_openmesh(const TriangleMesh& mesh, const std::vector<Vec3>& normals, std::ostream& out,
                         MeshFormat format, const std::vector<std::string>& comments)
{
    switch (format)
    {
    case MeshFormat::kStlBinary:
        return write_stl_binary(mesh, out, comments);
    case MeshFormat::kStlAscii:
    {
        InsertingBuffer named(*out.rdbuf(), ' ', 1, solid_name(comments)); // "solid NAME"
        return run_openmesh_inserting(named, {mesh, kNoNormals}, out, ".stla", om::IO::Options::Default);
    }
    case MeshFormat::kPly:
    {
        InsertingBuffer commented(*out.rdbuf(), '\n', 2,
                                  lines_with_prefix("comment ", comments)); // ply, format
        return run_openmesh_inserting(commented, {mesh, normals}, out, ".ply", om::IO::Options::Binary);
    }
    case MeshFormat::kObj:
        out << lines_with_prefix("# ", comments);
        return run_openmesh({mesh, normals}, out, ".obj", om::IO::Options::Default);
    case MeshFormat::kOff: // many readers of OFF, OpenMesh's among them, know no comments
        return run_openmesh({mesh, kNoNormals}, out, ".off", om::IO::Options::Default);
    case MeshFormat::kVtp:
    case MeshFormat::k3mf:
        break;
    }
    throw OutputError("OpenMesh does not write this format");
}

} // namespace voroprobe
