#include "compare/peer_field.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "mesh/measures.h"
#include "mesh/topology.h"

namespace voroprobe
{

namespace
{

using GridIndex = std::array<std::size_t, 3>;

//! Flood fill over the inside samples, one region after the other.
class RegionScan
{
public:
    explicit RegionScan(const PeerField& field) : field_(field), visited_(field.samples.size(), false) {}

    //! Crossings of the surface with grid edges around each region.
    std::vector<std::vector<Point3>> crossings_by_region()
    {
        std::vector<std::vector<Point3>> regions;
        for (std::size_t at = 0; at < field_.samples.size(); ++at)
            if (is_inside(at) && !visited_[at])
                regions.push_back(flood(at));
        return regions;
    }

private:
    [[nodiscard]] bool is_inside(std::size_t at) const { return field_.samples[at] >= field_.isovalue; }

    [[nodiscard]] GridIndex index_of(std::size_t at) const
    {
        const auto& n = field_.size;
        return {at % n[0], at / n[0] % n[1], at / (n[0] * n[1])};
    }

    std::vector<Point3> flood(std::size_t start)
    {
        std::vector<Point3> crossings;
        std::vector<std::size_t> front{start};
        visited_[start] = true;
        while (!front.empty())
        {
            const std::size_t at = front.back();
            front.pop_back();
            visit_neighbours(at, front, crossings);
        }
        return crossings;
    }

    void visit_neighbours(std::size_t at, std::vector<std::size_t>& front, std::vector<Point3>& crossings)
    {
        const GridIndex index = index_of(at);
        std::size_t stride = 1;
        for (std::size_t axis = 0; axis < 3; stride *= field_.size[axis], ++axis)
            for (const int step : {-1, 1})
            {
                if (index[axis] == (step < 0 ? 0 : field_.size[axis] - 1))
                    continue;
                const std::size_t next = step < 0 ? at - stride : at + stride;
                if (!is_inside(next))
                    crossings.push_back(crossing(index, axis, step, at, next));
                else if (!visited_[next])
                {
                    visited_[next] = true;
                    front.push_back(next);
                }
            }
    }

    [[nodiscard]] Point3 crossing(const GridIndex& index, std::size_t axis, int step, std::size_t inside,
                                  std::size_t outside) const
    {
        const double height = field_.samples[inside] - field_.isovalue;
        Vec3 position{static_cast<double>(index[0]), static_cast<double>(index[1]),
                      static_cast<double>(index[2])};
        position[axis] += step * height / (double{field_.samples[inside]} - double{field_.samples[outside]});
        return field_.origin + Vec3{position.x * field_.spacing.x, position.y * field_.spacing.y,
                                    position.z * field_.spacing.z};
    }

    const PeerField& field_;
    std::vector<bool> visited_;
};

LevelSurvey survey(const MeshingTask& task)
{
    LevelSurvey survey(task.isovalue, task.inside);
    std::visit(
        [&survey](const auto& stored)
        {
            for (const auto value : stored)
                survey.include(static_cast<double>(value));
        },
        task.volume->samples);
    return survey;
}

} // namespace

PeerField make_peer_field(const MeshingTask& task)
{
    const LevelSurvey surveyed = survey(task);
    const Level level = surveyed.level();
    const GridGeometry& geometry = task.volume->geometry;
    PeerField field{.size = geometry.size,
                    .spacing = geometry.spacing,
                    .samples = {},
                    .isovalue = level.sign * level.isovalue,
                    .border = geometry.grid_box()};
    field.samples.reserve(geometry.sample_count());
    const auto append = [&](const auto& stored)
    {
        for (const auto stored_value : stored)
        {
            const auto value = static_cast<double>(stored_value);
            field.samples.push_back(
                static_cast<float>(level.sign * (std::isfinite(value) ? value : surveyed.outside())));
        }
    };
    std::visit(append, task.volume->samples);
    return field;
}

PeerField padded(const PeerField& field)
{
    const auto& n = field.size;
    const float lowest = *std::min_element(field.samples.begin(), field.samples.end());
    const auto outside = static_cast<float>(std::min<double>(lowest, field.isovalue - 1.0));
    PeerField result{.size = {n[0] + 2, n[1] + 2, n[2] + 2},
                     .spacing = field.spacing,
                     .origin = field.origin - field.spacing,
                     .samples = {},
                     .isovalue = field.isovalue,
                     .border = field.border};
    result.samples.assign(result.size[0] * result.size[1] * result.size[2], outside);
    for (std::size_t k = 0; k < n[2]; ++k)
        for (std::size_t j = 0; j < n[1]; ++j)
        {
            const auto row = field.samples.begin() + static_cast<std::ptrdiff_t>(n[0] * (j + n[1] * k));
            const std::size_t to = 1 + result.size[0] * (j + 1 + result.size[1] * (k + 1));
            std::copy(row, row + static_cast<std::ptrdiff_t>(n[0]),
                      result.samples.begin() + static_cast<std::ptrdiff_t>(to));
        }
    return result;
}

void close_on_border(TriangleMesh& mesh, const Box3& border)
{
    for (Point3& p : mesh.vertices)
        for (std::size_t axis = 0; axis < 3; ++axis)
            p[axis] = std::clamp(p[axis], border.min[axis], border.max[axis]);
    mesh = weld(mesh);
    std::vector<bool> kept;
    kept.reserve(mesh.faces.size());
    for (const auto& [a, b, c] : mesh.faces)
        kept.push_back(a != b && b != c && c != a);
    mesh = with_faces(mesh, kept);
}

void wind_outward(TriangleMesh& mesh)
{
    if (enclosed_volume(mesh) >= 0.0)
        return;
    for (TriangleMesh::Face& face : mesh.faces)
        std::swap(face[1], face[2]);
}

std::vector<Point3> seeds_on_every_region(const PeerField& field, std::size_t per_region)
{
    std::vector<Point3> seeds;
    for (const auto& crossings : RegionScan(field).crossings_by_region())
    {
        const std::size_t count = std::min(per_region, crossings.size());
        for (std::size_t i = 0; i < count; ++i)
            seeds.push_back(crossings[i * crossings.size() / count]);
    }
    return seeds;
}

} // namespace voroprobe
