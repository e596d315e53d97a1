// What the usual way makes of a label map, label by label: VTK's discrete marching cubes, windowed sinc
// smoothing, quadric decimation to a quarter; as nii2mesh and 3D Slicer do it, with their usual settings.
//
//     bench_label_peers LABEL_MAP
//
// Writes one JSON object: parts that are there and lost, changes of volume, faces that cross, processor time.
// A part is there where a closed piece of the mesh has most of its vertices next to its voxels.

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>

#include <nlohmann/json.hpp>

#include "certificate/self_intersections.h"
#include "compare/mask_cubes.h"
#include "io/volume_reader.h"
#include "labels/label_survey.h"
#include "labels/part_groups.h"
#include "labels/part_presence.h"
#include "mesh/measures.h"
#include "mesh/topology.h"

namespace
{

using namespace voroprobe;

double processor_seconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
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
        const TriangleMesh mesh = cubes_of_mask(mask, spacing, CubesFinish::kDecimated);
        seconds += processor_seconds() - begin;

        const std::vector<bool> present = parts_present(mesh, mask, spacing);
        parts += label.parts.size();
        there += static_cast<std::size_t>(std::count(present.begin(), present.end(), true));
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
