#include "compare/decimation.h"

#include <vtkQuadricDecimation.h>

#include "compare/vtk_surface.h"

namespace voroprobe
{

TriangleMesh decimate_faces(const TriangleMesh& mesh, std::size_t faces)
{
    if (faces >= mesh.faces.size())
        return mesh;
    const auto filter = vtkSmartPointer<vtkQuadricDecimation>::New();
    filter->SetInputData(to_polydata(mesh));
    filter->SetTargetReduction(1.0 - static_cast<double>(faces) / static_cast<double>(mesh.faces.size()));
    filter->Update();
    return to_mesh(*filter->GetOutput());
}

} // namespace voroprobe
