// What the usual way makes of a label map, label by label: VTK's discrete marching cubes, windowed sinc
// smoothing, quadric decimation to a quarter; as nii2mesh and 3D Slicer do it, with their usual settings.
//
//     bench_label_peers LABEL_MAP
//
// Writes one JSON object: parts that are there and lost, changes of volume, faces that cross, processor time.
// A part is there where a closed piece of the mesh has most of its vertices next to its voxels.

#include <array>
#include <cmath>
#include <ctime>
#include <iostream>
#include <map>
#include <set>

#include <nlohmann/json.hpp>
#include <vtkDiscreteMarchingCubes.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include "certificate/mesh_pieces.h"
#include "certificate/self_intersections.h"
#include "io/volume_reader.h"
#include "labels/label_survey.h"
#include "labels/part_groups.h"
#include "mesh/measures.h"
#include "mesh/topology.h"

namespace
{

using namespace voroprobe;

constexpr double kKeptShare = 0.25; // nii2mesh -r 0.25
constexpr int kSincIterations = 20;
constexpr double kPassBand = 0.1;

double processor_seconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

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

TriangleMesh mesh_of(vtkPolyData& data)
{
    TriangleMesh mesh;
    for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i)
    {
        const double* p = data.GetPoint(i);
        mesh.vertices.push_back({p[0], p[1], p[2]});
    }
    vtkNew<vtkIdList> corners;
    for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i)
    {
        data.GetCellPoints(i, corners);
        mesh.faces.push_back({static_cast<std::uint32_t>(corners->GetId(0)),
                              static_cast<std::uint32_t>(corners->GetId(1)),
                              static_cast<std::uint32_t>(corners->GetId(2))});
    }
    return mesh;
}

TriangleMesh mesh_as_usual(const PartMask& mask, const Vec3& spacing)
{
    vtkNew<vtkDiscreteMarchingCubes> cubes;
    cubes->SetInputData(image_of(mask, spacing));
    cubes->SetValue(0, 1.0);
    cubes->ComputeNormalsOff();
    cubes->ComputeScalarsOff();
    vtkNew<vtkWindowedSincPolyDataFilter> smoothing;
    smoothing->SetInputConnection(cubes->GetOutputPort());
    smoothing->SetNumberOfIterations(kSincIterations);
    smoothing->SetPassBand(kPassBand);
    smoothing->BoundarySmoothingOff();
    smoothing->FeatureEdgeSmoothingOff();
    smoothing->NonManifoldSmoothingOn();
    smoothing->NormalizeCoordinatesOn();
    vtkNew<vtkQuadricDecimation> decimation;
    decimation->SetInputConnection(smoothing->GetOutputPort());
    decimation->SetTargetReduction(1.0 - kKeptShare);
    decimation->Update();
    return mesh_of(*decimation->GetOutput());
}

//! The part of the nearest of the samples around a point that belong to one; 0 for none.
std::uint32_t part_at(const PartMask& mask, const Vec3& spacing, const Point3& p)
{
    std::uint32_t part = 0;
    double nearest = 1e300;
    for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
            {
                const std::array<long, 3> index{std::lround(p.x / spacing.x) + dx,
                                                std::lround(p.y / spacing.y) + dy,
                                                std::lround(p.z / spacing.z) + dz};
                bool within = true;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    within = within && index[axis] >= 0 && index[axis] < static_cast<long>(mask.size[axis]);
                if (!within)
                    continue;
                const std::size_t at = static_cast<std::size_t>(index[0]) +
                                       mask.size[0] * (static_cast<std::size_t>(index[1]) +
                                                       mask.size[1] * static_cast<std::size_t>(index[2]));
                const Point3 sample{spacing.x * static_cast<double>(index[0]),
                                    spacing.y * static_cast<double>(index[1]),
                                    spacing.z * static_cast<double>(index[2])};
                if (mask.part[at] != 0 && squared_distance(sample, p) < nearest)
                {
                    nearest = squared_distance(sample, p);
                    part = mask.part[at];
                }
            }
    return part;
}

//! Parts that a closed piece of the mesh stands for.
std::size_t parts_there(const TriangleMesh& mesh, const MeshPieces& pieces, const PartMask& mask,
                        const Vec3& spacing)
{
    std::vector<std::map<std::uint32_t, std::size_t>> votes(pieces.pieces.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        for (const std::uint32_t v : mesh.faces[f])
            ++votes[pieces.piece_of_face[f]][part_at(mask, spacing, mesh.vertices[v])];
    std::set<std::uint32_t> there;
    for (std::size_t piece = 0; piece < votes.size(); ++piece)
    {
        std::uint32_t winner = 0;
        std::size_t most = 0;
        for (const auto& [part, count] : votes[piece])
            if (count > most)
            {
                most = count;
                winner = part;
            }
        if (winner != 0 && pieces.pieces[piece].closed() && pieces.pieces[piece].enclosed_volume > 0.0)
            there.insert(winner);
    }
    return there.size();
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2)
    {
        std::cerr << "usage: bench_label_peers LABEL_MAP\n";
        return 2;
    }
    const Volume volume = read_volume(argv[1]).volume;
    const Vec3 spacing = volume.geometry.spacing;
    const LabelSurvey survey(volume);
    std::size_t parts = 0;
    std::size_t there = 0;
    std::size_t crossings = 0;
    std::size_t open_labels = 0;
    std::size_t vertices = 0;
    std::size_t beyond_2_percent = 0;
    double largest_change = 0.0;
    double sum_of_changes = 0.0;
    double seconds = 0.0;
    for (const SurveyedLabel& label : survey.labels())
    {
        const double begin = processor_seconds();
        const PartMask mask = cut_mask(survey, {label.parts, label.box});
        const TriangleMesh mesh = weld(mesh_as_usual(mask, spacing));
        seconds += processor_seconds() - begin;

        const MeshPieces pieces = split_into_pieces(mesh);
        parts += label.parts.size();
        there += parts_there(mesh, pieces, mask, spacing);
        crossings += self_intersections(mesh).size();
        open_labels += is_closed_manifold(mesh) ? 0 : 1;
        vertices += mesh.vertices.size();
        const double voxels = spacing.x * spacing.y * spacing.z * static_cast<double>(label.voxels);
        const double change = std::abs(enclosed_volume(mesh) / voxels - 1.0);
        largest_change = std::max(largest_change, change);
        sum_of_changes += change;
        beyond_2_percent += change > 0.02 ? 1 : 0;
    }
    const auto labels = static_cast<double>(survey.labels().size());
    std::cout << nlohmann::ordered_json{{"labels", survey.labels().size()},
                                        {"parts_expected", parts},
                                        {"parts_meshed", there},
                                        {"largest_volume_change_percent", 100.0 * largest_change},
                                        {"mean_volume_change_percent", 100.0 * sum_of_changes / labels},
                                        {"labels_beyond_2_percent", beyond_2_percent},
                                        {"labels_not_closed_manifold", open_labels},
                                        {"pairs_of_crossing_faces", crossings},
                                        {"vertices", vertices},
                                        {"processor_seconds", seconds}}
                     .dump(2)
              << '\n';
    return 0;
}
