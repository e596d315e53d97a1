// Marching cubes as VTK does it, and what users do to its surface next.
#include <vtkQuadricDecimation.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include "compare/contestant.h"
#include "compare/marching_cubes.h"
#include "compare/vtk_surface.h"

namespace voroprobe
{

namespace
{

//! 3D Slicer's conversion of a segmentation to a closed surface: factor 0.5, so many rounds, this pass band.
constexpr int kSmoothingRounds = 20;
constexpr double kPassBand = 0.01;

class MarchingCubes final : public Contestant
{
public:
    explicit MarchingCubes(const MeshingTask& task) : field_(padded(make_peer_field(task))) {}

    void mesh(StageClock& clock) override { mesh_ = marching_cubes(field_, clock); }

    [[nodiscard]] TriangleMesh result() const override { return mesh_; }

private:
    PeerField field_;
    TriangleMesh mesh_;
};

class Decimated final : public Contestant
{
public:
    explicit Decimated(const MeshingTask& task)
        : target_(task.target_vertices), field_(padded(make_peer_field(task)))
    {
    }

    void mesh(StageClock& clock) override
    {
        const TriangleMesh fine = marching_cubes(field_, clock);
        clock.begin("decimation");
        const double kept = static_cast<double>(target_) / static_cast<double>(fine.vertices.size());
        const auto filter = vtkSmartPointer<vtkQuadricDecimation>::New();
        filter->SetInputData(to_polydata(fine));
        filter->SetTargetReduction(1.0 - std::min(kept, 1.0));
        filter->Update();
        mesh_ = to_mesh(*filter->GetOutput());
    }

    [[nodiscard]] TriangleMesh result() const override { return mesh_; }

private:
    std::size_t target_;
    PeerField field_;
    TriangleMesh mesh_;
};

class Smoothed final : public Contestant
{
public:
    explicit Smoothed(const MeshingTask& task) : field_(padded(make_peer_field(task))) {}

    void mesh(StageClock& clock) override
    {
        const TriangleMesh rough = marching_cubes(field_, clock);
        clock.begin("smoothing");
        const auto filter = vtkSmartPointer<vtkWindowedSincPolyDataFilter>::New();
        filter->SetInputData(to_polydata(rough));
        filter->SetNumberOfIterations(kSmoothingRounds);
        filter->SetPassBand(kPassBand);
        filter->BoundarySmoothingOff();
        filter->FeatureEdgeSmoothingOff();
        filter->NonManifoldSmoothingOn();
        filter->NormalizeCoordinatesOn();
        filter->Update();
        mesh_ = to_mesh(*filter->GetOutput());
    }

    [[nodiscard]] TriangleMesh result() const override { return mesh_; }

private:
    PeerField field_;
    TriangleMesh mesh_;
};

} // namespace

TriangleMesh marching_cubes(const PeerField& padded_field, StageClock& clock)
{
    clock.begin("marching cubes");
    TriangleMesh mesh = to_mesh(*flying_edges(padded_field));
    close_on_border(mesh, padded_field.border);
    wind_outward(mesh);
    return mesh;
}

std::unique_ptr<Contestant> make_marching_cubes(const MeshingTask& task)
{
    return std::make_unique<MarchingCubes>(task);
}

std::unique_ptr<Contestant> make_decimated(const MeshingTask& task)
{
    return std::make_unique<Decimated>(task);
}

std::unique_ptr<Contestant> make_smoothed(const MeshingTask& task)
{
    return std::make_unique<Smoothed>(task);
}

} // namespace voroprobe
