#include "compare/picture.h"

#include <vtkActor.h>
#include <vtkAutoInit.h>
#include <vtkCamera.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include "compare/vtk_surface.h"

VTK_MODULE_INIT(vtkRenderingOpenGL2)

namespace voroprobe
{

namespace
{

constexpr int kWidth = 1600; // pixels
constexpr int kHeight = 800;

//! The part of the box that is shown close by.
constexpr double kCloseUpShare = 0.2;

//! From the front (LPS: y runs to the back), to one side, a little above.
const Vec3 kDirection = normalized({0.5, -1.0, 0.35});

enum class Edges
{
    kHidden,
    kShown
};

vtkSmartPointer<vtkActor> actor_of(vtkPolyData* surface, Edges edges)
{
    const auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(surface);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    vtkProperty& look = *actor->GetProperty();
    look.SetColor(0.80, 0.79, 0.76);
    look.SetInterpolationToFlat();
    look.SetAmbient(0.15);
    look.SetSpecular(0.0);
    if (edges == Edges::kShown)
    {
        look.EdgeVisibilityOn();
        look.SetEdgeColor(0.12, 0.16, 0.22);
        look.SetLineWidth(1.0F);
    }
    return actor;
}

//! What is at `target`, `height` from top to bottom, mm.
vtkSmartPointer<vtkRenderer> view_of(vtkActor* actor, const Point3& target, double height, double distance)
{
    auto renderer = vtkSmartPointer<vtkRenderer>::New();
    renderer->SetBackground(1, 1, 1);
    renderer->AddActor(actor);
    vtkCamera& camera = *renderer->GetActiveCamera();
    const Point3 eye = target + distance * kDirection;
    camera.ParallelProjectionOn();
    camera.SetParallelScale(0.5 * height);
    camera.SetViewUp(0, 0, 1);
    camera.SetFocalPoint(target.x, target.y, target.z);
    camera.SetPosition(eye.x, eye.y, eye.z);
    renderer->ResetCameraClippingRange();
    return renderer;
}

//! The point of the mesh that is seen in the middle of the picture.
Point3 nearest_to_eye(const TriangleMesh& mesh, const Box3& box)
{
    const double near = kCloseUpShare * 0.25 * box.diagonal();
    Point3 best = box.center();
    double depth = -box.diagonal();
    for (const Point3& p : mesh.vertices)
    {
        const Vec3 from_center = p - box.center();
        const double along = dot(from_center, kDirection);
        if (along > depth && norm(from_center - along * kDirection) < near)
        {
            depth = along;
            best = p;
        }
    }
    return best;
}

//! The faces that the close-up may show, from front to back.
TriangleMesh near_line(const TriangleMesh& mesh, const Point3& target, double radius)
{
    std::vector<bool> kept;
    kept.reserve(mesh.faces.size());
    for (const TriangleMesh::Face& face : mesh.faces)
    {
        const Vec3 from_target = mesh.corner(face, 0) - target;
        kept.push_back(norm(from_target - dot(from_target, kDirection) * kDirection) < radius);
    }
    return with_faces(mesh, kept);
}

std::string png_of(vtkRenderWindow* window)
{
    const auto pixels = vtkSmartPointer<vtkWindowToImageFilter>::New();
    pixels->SetInput(window);
    pixels->SetInputBufferTypeToRGB();
    pixels->ReadFrontBufferOff();
    pixels->ShouldRerenderOff(); // it is there
    const auto writer = vtkSmartPointer<vtkPNGWriter>::New();
    writer->SetInputConnection(pixels->GetOutputPort());
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray& bytes = *writer->GetResult();
    return {reinterpret_cast<const char*>(bytes.GetPointer(0)),
            static_cast<std::size_t>(bytes.GetDataSize())};
}

} // namespace

std::string draw_picture(const TriangleMesh& mesh, const Box3& box)
{
    const double diagonal = box.diagonal();
    const Point3 target = nearest_to_eye(mesh, box);
    const auto window = vtkSmartPointer<vtkRenderWindow>::New();
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(4);
    window->SetSize(kWidth, kHeight);
    const auto whole = actor_of(to_polydata(mesh), Edges::kHidden);
    const auto close =
        actor_of(to_polydata(near_line(mesh, target, kCloseUpShare * diagonal)), Edges::kShown);
    const auto left = view_of(whole, box.center(), 0.85 * diagonal, diagonal);
    const auto right = view_of(close, target, kCloseUpShare * diagonal, diagonal);
    left->SetViewport(0.0, 0.0, 0.5, 1.0);
    right->SetViewport(0.5, 0.0, 1.0, 1.0);
    window->AddRenderer(left);
    window->AddRenderer(right);
    window->Render();
    return png_of(window);
}

} // namespace voroprobe
