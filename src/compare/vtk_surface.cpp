#include "compare/vtk_surface.h"

#include <limits>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

namespace voroprobe
{

namespace
{

vtkSmartPointer<vtkImageData> image_of(const PeerField& field)
{
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(static_cast<int>(field.size[0]), static_cast<int>(field.size[1]),
                         static_cast<int>(field.size[2]));
    image->SetSpacing(field.spacing.x, field.spacing.y, field.spacing.z);
    image->SetOrigin(field.origin.x, field.origin.y, field.origin.z);
    const auto values = vtkSmartPointer<vtkFloatArray>::New();
    constexpr int kBorrowed = 1; // VTK neither writes nor frees
    values->SetArray(const_cast<float*>(field.samples.data()), static_cast<vtkIdType>(field.samples.size()),
                     kBorrowed);
    image->GetPointData()->SetScalars(values);
    return image;
}

} // namespace

vtkSmartPointer<vtkPolyData> flying_edges(const PeerField& field)
{
    const auto filter = vtkSmartPointer<vtkFlyingEdges3D>::New();
    filter->SetInputData(image_of(field));
    filter->SetValue(0, field.isovalue);
    filter->ComputeNormalsOff();
    filter->ComputeGradientsOff();
    filter->ComputeScalarsOff();
    filter->Update();
    return filter->GetOutput();
}

TriangleMesh to_mesh(vtkPolyData& surface)
{
    constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number_of_point(static_cast<std::size_t>(surface.GetNumberOfPoints()),
                                               kUnused);
    TriangleMesh mesh;
    const auto number = [&](vtkIdType point)
    {
        std::uint32_t& known = number_of_point[static_cast<std::size_t>(point)];
        if (known == kUnused)
        {
            known = static_cast<std::uint32_t>(mesh.vertices.size());
            double p[3];
            surface.GetPoint(point, p);
            mesh.vertices.push_back({p[0], p[1], p[2]});
        }
        return known;
    };
    const auto corners = vtkSmartPointer<vtkIdList>::New();
    vtkCellArray& polygons = *surface.GetPolys();
    for (polygons.InitTraversal(); polygons.GetNextCell(corners) != 0;)
        if (corners->GetNumberOfIds() == 3)
            mesh.faces.push_back(
                {number(corners->GetId(0)), number(corners->GetId(1)), number(corners->GetId(2))});
    return mesh;
}

vtkSmartPointer<vtkPolyData> to_polydata(const TriangleMesh& mesh)
{
    const auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.vertices.size()));
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        points->SetPoint(static_cast<vtkIdType>(i), mesh.vertices[i].x, mesh.vertices[i].y,
                         mesh.vertices[i].z);
    const auto polygons = vtkSmartPointer<vtkCellArray>::New();
    polygons->AllocateExact(static_cast<vtkIdType>(mesh.faces.size()),
                            3 * static_cast<vtkIdType>(mesh.faces.size()));
    for (const TriangleMesh::Face& face : mesh.faces)
        polygons->InsertNextCell({face[0], face[1], face[2]});
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    surface->SetPoints(points);
    surface->SetPolys(polygons);
    return surface;
}

} // namespace voroprobe
