#include "io/mesh_vtk.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include "io/mesh_file.h"
#include "io/vtk_messages.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

// ---- Writing ----

//! Vectors as VTK sees them: the same memory, not a copy. VTK's array could write to it, and its writer does
//! not.
vtkSmartPointer<vtkDoubleArray> array_over(const std::vector<Vec3>& vectors)
{
    static_assert(sizeof(Point3) == 3 * sizeof(double));
    constexpr int kVtkDoesNotFreeIt = 1;
    const auto count = static_cast<vtkIdType>(vectors.size());
    auto* values = const_cast<double*>(reinterpret_cast<const double*>(vectors.data()));
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetNumberOfComponents(3);
    array->SetArray(values, 3 * count, kVtkDoesNotFreeIt);
    return array;
}

vtkSmartPointer<vtkCellArray> triangles_of(const std::vector<TriangleMesh::Face>& faces)
{
    const auto count = static_cast<vtkIdType>(faces.size());
    const vtkNew<vtkIdTypeArray> offsets;
    const vtkNew<vtkIdTypeArray> connectivity;
    offsets->SetNumberOfValues(count + 1);
    connectivity->SetNumberOfValues(3 * count);
    for (vtkIdType f = 0; f <= count; ++f)
        offsets->SetValue(f, 3 * f);
    vtkIdType next = 0;
    for (const TriangleMesh::Face& face : faces)
        for (const std::uint32_t v : face)
            connectivity->SetValue(next++, v);

    auto triangles = vtkSmartPointer<vtkCellArray>::New();
    triangles->SetData(offsets, connectivity);
    return triangles;
}

vtkSmartPointer<vtkStringArray> string_array(const std::vector<std::string>& comments)
{
    auto array = vtkSmartPointer<vtkStringArray>::New();
    array->SetName("comments");
    for (const std::string& comment : comments)
        array->InsertNextValue(comment);
    return array;
}

// ---- Reading ----

bool indices_are_valid(vtkPolyData& data)
{
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    for (vtkCellArray* cells : {data.GetPolys(), data.GetStrips()})
        for (cells->InitTraversal(); cells->GetNextCell(count, ids) != 0;)
            if (!std::all_of(ids, ids + count,
                             [&](vtkIdType id) { return id >= 0 && id < data.GetNumberOfPoints(); }))
                return false;
    return true;
}

std::vector<Point3> vertices_of(vtkPolyData& data)
{
    std::vector<Point3> vertices(static_cast<std::size_t>(data.GetNumberOfPoints()));
    for (std::size_t v = 0; v < vertices.size(); ++v)
    {
        double p[3];
        data.GetPoint(static_cast<vtkIdType>(v), p);
        vertices[v] = {p[0], p[1], p[2]};
    }
    return vertices;
}

TriangleMesh::Face face_of(vtkIdType a, vtkIdType b, vtkIdType c)
{
    return {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)};
}

//! \pre indices are valid
TriangleMesh mesh_of(vtkPolyData& data)
{
    TriangleMesh mesh{.vertices = vertices_of(data), .faces = {}};
    mesh.faces.reserve(static_cast<std::size_t>(data.GetNumberOfPolys()));

    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    vtkCellArray* polygons = data.GetPolys();
    for (polygons->InitTraversal(); polygons->GetNextCell(count, ids) != 0;)
        for (vtkIdType i = 2; i < count; ++i)
            mesh.faces.push_back(face_of(ids[0], ids[i - 1], ids[i]));

    // Every other triangle of a strip is named the other way round.
    vtkCellArray* strips = data.GetStrips();
    for (strips->InitTraversal(); strips->GetNextCell(count, ids) != 0;)
        for (vtkIdType i = 2; i < count; ++i)
            mesh.faces.push_back(i % 2 == 0 ? face_of(ids[i - 2], ids[i - 1], ids[i])
                                            : face_of(ids[i - 1], ids[i - 2], ids[i]));
    return mesh;
}

//! Runs a reader of VTK's that has no file name yet.
template <typename Reader>
TriangleMesh read_with(Reader& reader, const std::filesystem::path& path)
{
    const VtkMessages messages;
    reader.SetFileName(path.c_str());
    reader.Update();
    if (!messages.first_error().empty())
        fail_reading(path, messages.first_error());

    vtkPolyData* data = reader.GetOutput();
    if (data == nullptr || data->GetNumberOfPolys() + data->GetNumberOfStrips() == 0)
        fail_reading(path, "it holds no faces");
    if (data->GetNumberOfPoints() > std::numeric_limits<std::uint32_t>::max())
        fail_reading(path, "it holds too many vertices");
    if (!indices_are_valid(*data))
        fail_reading(path, "a face names a vertex that is not in the file");
    return mesh_of(*data);
}

//! Of a binary STL file, the number of its faces included.
constexpr std::uintmax_t kStlHeaderBytes = 84;

//! Blanks, empty lines and capitals before and in the first word are met with, and read by VTK.
bool begins_like_text(std::string_view header)
{
    constexpr std::string_view kFirstWord = "solid";
    header.remove_prefix(std::min(header.find_first_not_of(" \t\r\n"), header.size()));
    return header.size() >= kFirstWord.size() &&
           std::equal(kFirstWord.begin(), kFirstWord.end(), header.begin(),
                      [](char expected, char c)
                      { return expected == std::tolower(static_cast<unsigned char>(c)); });
}

//! The number of faces a binary STL file announces; nullopt for text, which begins with "solid" and, unlike
//! some binary files that do too, is not exactly as long as the number there would make it.
std::optional<std::uint32_t> announced_faces(const std::filesystem::path& path)
{
    constexpr std::uintmax_t kFaceBytes = 50;
    std::array<unsigned char, kStlHeaderBytes> header{};
    std::ifstream in(path, std::ios::binary);
    in.read(reinterpret_cast<char*>(header.data()), std::ssize(header));
    const std::uint32_t count = header[80] | header[81] << 8U | header[82] << 16U |
                                static_cast<std::uint32_t>(header[83]) << 24U; // little endian
    const bool may_be_text = begins_like_text({reinterpret_cast<const char*>(header.data()), header.size()});
    const bool has_that_length = std::filesystem::file_size(path) == kStlHeaderBytes + kFaceBytes * count;
    return may_be_text && !has_that_length ? std::nullopt : std::optional(count);
}

} // namespace

void write_vtp(const TriangleMesh& mesh, const std::vector<Vec3>& normals, std::ostream& out,
               const std::vector<std::string>& comments)
{
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPoints> points;
    points->SetData(array_over(mesh.vertices));
    data->SetPoints(points);
    data->SetPolys(triangles_of(mesh.faces));
    if (!normals.empty())
    {
        const auto array = array_over(normals);
        array->SetName("Normals");
        data->GetPointData()->SetNormals(array);
    }
    if (!comments.empty())
        data->GetFieldData()->AddArray(string_array(comments));

    // Into memory first: VTK's own file output cannot be trusted to say why it failed.
    const VtkMessages messages;
    const vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(data);
    writer->WriteToOutputStringOn();
    writer->SetHeaderTypeToUInt64();
    if (writer->Write() != 1)
        throw OutputError("VTK cannot write the mesh: " + messages.first_error());
    const std::string content = writer->GetOutputString();
    out.write(content.data(), std::ssize(content));
}

TriangleMesh read_stl(const std::filesystem::path& path)
{
    const std::optional<std::uint32_t> announced = announced_faces(path);
    if (announced == 0U && std::filesystem::file_size(path) >= kStlHeaderBytes)
        fail_reading(path, "it holds no faces");
    const vtkNew<vtkSTLReader> reader;
    reader->MergingOff(); // VTK would drop the faces that collapse
    TriangleMesh mesh = read_with(*reader, path);

    // VTK takes whatever faces there are, including bytes behind the last one announced.
    if (announced)
    {
        if (mesh.faces.size() < *announced)
            fail_reading(path, "it is shorter than its header says: " + std::to_string(mesh.faces.size()) +
                                   " of " + std::to_string(*announced) + " faces");
        mesh.faces.resize(*announced);
        mesh.vertices.resize(3 * std::size_t{*announced});
    }
    return mesh;
}

TriangleMesh read_vtp(const std::filesystem::path& path)
{
    const vtkNew<vtkXMLPolyDataReader> reader;
    return read_with(*reader, path);
}

} // namespace voroprobe
