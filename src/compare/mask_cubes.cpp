#include "compare/mask_cubes.h"

#include <vtkDiscreteMarchingCubes.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkQuadricDecimation.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include "compare/vtk_surface.h"
#include "mesh/topology.h"

namespace voroprobe
{

namespace
{

constexpr double kKeptShare = 0.25; // nii2mesh -r 0.25
constexpr int kSincRounds = 20;
constexpr double kPassBand = 0.1;

vtkNew<vtkImageData> image_of(const PartMask& mask, const Vec3& spacing)
{
    vtkNew<vtkImageData> image;
    image->SetDimensions(static_cast<int>(mask.size[0]), static_cast<int>(mask.size[1]),
                         static_cast<int>(mask.size[2]));
    image->SetSpacing(spacing.x, spacing.y, spacing.z);
    vtkNew<vtkUnsignedCharArray> samples;
    samples->SetNumberOfTuples(static_cast<vtkIdType>(mask.part.size()));
    for (std::size_t i = 0; i < mask.part.size(); ++i)
        samples->SetValue(static_cast<vtkIdType>(i), mask.part[i] != 0 ? 1 : 0);
    image->GetPointData()->SetScalars(samples);
    return image;
}

vtkSmartPointer<vtkPolyData> staircase(const PartMask& mask, const Vec3& spacing)
{
    vtkNew<vtkDiscreteMarchingCubes> cubes;
    cubes->SetInputData(image_of(mask, spacing));
    cubes->SetValue(0, 1.0);
    cubes->ComputeNormalsOff();
    cubes->ComputeScalarsOff();
    cubes->Update();
    return cubes->GetOutput();
}

vtkSmartPointer<vtkPolyData> smoothed(vtkPolyData* surface)
{
    vtkNew<vtkWindowedSincPolyDataFilter> smoothing;
    smoothing->SetInputData(surface);
    smoothing->SetNumberOfIterations(kSincRounds);
    smoothing->SetPassBand(kPassBand);
    smoothing->BoundarySmoothingOff();
    smoothing->FeatureEdgeSmoothingOff();
    smoothing->NonManifoldSmoothingOn();
    smoothing->NormalizeCoordinatesOn();
    smoothing->Update();
    return smoothing->GetOutput();
}

vtkSmartPointer<vtkPolyData> decimated(vtkPolyData* surface)
{
    vtkNew<vtkQuadricDecimation> decimation;
    decimation->SetInputData(surface);
    decimation->SetTargetReduction(1.0 - kKeptShare);
    decimation->Update();
    return decimation->GetOutput();
}

} // namespace

TriangleMesh cubes_of_mask(const PartMask& mask, const Vec3& spacing, CubesFinish finish)
{
    vtkSmartPointer<vtkPolyData> surface = staircase(mask, spacing);
    if (finish != CubesFinish::kRough)
        surface = smoothed(surface);
    if (finish == CubesFinish::kDecimated)
        surface = decimated(surface);
    return weld(to_mesh(*surface));
}

} // namespace voroprobe
