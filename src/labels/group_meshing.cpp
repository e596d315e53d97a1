#include "labels/group_meshing.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <span>
#include <utility>

#include "certificate/certificate.h"
#include "certificate/self_intersections.h"
#include "labels/mesh_fitting.h"
#include "labels/part_field.h"
#include "mesh/measures.h"
#include "oracles/trilinear_oracle.h"
#include "support/check.h"
#include "support/number_text.h"
#include "volume/height_field.h"
#include "volume/inventory.h"

namespace voroprobe
{
namespace
{

//! A field as the mesher takes it.
struct FieldSurface
{
    std::shared_ptr<const Inventory> inventory;
    std::shared_ptr<const SurfaceOracle> oracle;
};

FieldSurface surface_of(const PartField& field)
{
    const LevelledVolume levelled = level_volume(std::make_shared<const Volume>(field.volume()), 0.0);
    FieldSurface surface;
    surface.inventory = std::make_shared<const Inventory>(*make_height_field(levelled), 1);
    surface.oracle = make_trilinear_oracle(levelled, surface.inventory);
    return surface;
}

//! A mesh, the field it is of, and how good it is.
struct Attempt
{
    FieldSurface surface;
    std::vector<std::uint32_t> part_of_surface = {}; //!< place in the group
    TriangleMesh mesh;
    std::vector<SurfaceId> surface_of_face;
    MeshingStatus status = MeshingStatus::kDone;
    bool moved = false; //!< vertices followed the field after refinement
    Certificate certificate = {};
    std::optional<std::string> broken_promise = std::nullopt;
    double volume_error = 0.0; //!< of the part whose volume is farthest from that wanted, as a fraction of it

    [[nodiscard]] bool better_than(const Attempt& other) const
    {
        if (broken_promise.has_value() != other.broken_promise.has_value())
            return !broken_promise;
        return volume_error < other.volume_error;
    }
};

//! One run of mesh_group().
class GroupMeshing
{
public:
    GroupMeshing(const LabelSurvey& survey, const PartGroup& group, const Vec3& spacing,
                 const LabelMeshingOptions& options, ProgressSink* progress)
        : survey_(survey), group_(group), spacing_(spacing), options_(options), progress_(progress),
          field_(make_field())
    {
        const double voxel = spacing.x * spacing.y * spacing.z;
        for (const std::uint32_t part : group.parts)
            wanted_.push_back(voxel * static_cast<double>(survey.parts()[part].voxels));
    }

    GroupMesh run()
    {
        field_.fit_volumes(wanted_);
        std::optional<Attempt> best;
        const auto keep_better = [&best](Attempt attempt)
        {
            if (!best || attempt.better_than(*best))
                best = std::move(attempt);
        };
        NeckRule neck_rule = NeckRule::kRaiseOutside;
        for (std::size_t seeds = kFirstSeeds; seeds <= kMostSeeds; seeds *= kMoreSeeds)
        {
            field_.set_neck_rule(std::exchange(neck_rule, NeckRule::kLiftInside));
            Attempt attempt = mesh_field(seeds);
            if (attempt.status != MeshingStatus::kDone)
                return result_of(std::move(attempt));
            Attempt fitted = fitted_mesh(attempt);
            judge(fitted);
            if (fitted.moved && fitted.certificate.self_intersections.value_or(0) > 0)
            {
                take_back_crossings(fitted.mesh, attempt.mesh);
                judge(fitted);
            }
            if (fitted.moved && fitted.broken_promise)
            {
                judge(attempt);
                keep_better(std::move(attempt));
            }
            keep_better(std::move(fitted));
            if (!best->broken_promise && best->volume_error <= options_.volume_tolerance)
                break;
        }
        return result_of(std::move(*best));
    }

private:
    [[nodiscard]] PartField make_field() const
    {
        PartMask mask = cut_mask(survey_, group_);
        const std::vector<float> smoothed = smoothed_heights(mask, spacing_, options_.smoothing);
        return {std::move(mask), spacing_, smoothed};
    }

    //! Begins with points spread over every surface: from a single one refinement may end with a few facets
    //! on a bump.
    Attempt mesh_field(std::size_t seeds_per_surface)
    {
        Attempt attempt{.surface = surface_of(field_), .mesh = {}, .surface_of_face = {}};
        const SurfaceOracle& oracle = *attempt.surface.oracle;
        std::vector<SurfaceId> surfaces(oracle.surface_count());
        std::iota(surfaces.begin(), surfaces.end(), 0);
        MeshingOptions criteria = options_.criteria;
        for (const std::vector<Point3>& points : oracle.points_on(surfaces, seeds_per_surface))
            criteria.seeds.insert(criteria.seeds.end(), points.begin(), points.end());
        MeshingResult result = mesh_surface(oracle, criteria, progress_);
        attempt.mesh = std::move(result.mesh);
        attempt.surface_of_face = std::move(result.surface_of_face);
        attempt.status = result.status;
        attempt.part_of_surface = parts_of_surfaces(*attempt.surface.inventory);
        return attempt;
    }

    //! Shifts the field until a mesh whose vertices follow it has the volumes wanted.
    Attempt fitted_mesh(const Attempt& attempt)
    {
        const double reach = std::min({spacing_.x, spacing_.y, spacing_.z});
        Attempt fitted = attempt;
        for (int round = 0; round < kMostFits; ++round)
        {
            const std::vector<double> volumes = part_volumes(fitted);
            if (largest_error(volumes) <= options_.volume_tolerance)
                break;
            std::vector<double> field_wanted = field_.volumes();
            for (std::size_t part = 0; part < volumes.size(); ++part)
                field_wanted[part] *=
                    std::clamp(wanted_[part] / volumes[part], 1.0 / kMostGrowth, kMostGrowth);
            field_.fit_volumes(field_wanted);
            fitted.surface = surface_of(field_);
            fitted.part_of_surface = parts_of_surfaces(*fitted.surface.inventory);
            move_onto_surface(fitted.mesh, *fitted.surface.oracle, reach);
            fitted.moved = true;
        }
        return fitted;
    }

    //! Puts the corners of faces that cross back to where they were before they were moved, until no two
    //! cross, or all corners that matter are back.
    static void take_back_crossings(TriangleMesh& moved, const TriangleMesh& before)
    {
        for (bool any = true; std::exchange(any, false);)
            for (const auto& [a, b] : self_intersections(moved))
                for (const std::uint32_t face : {a, b})
                    for (const std::uint32_t v : moved.faces[face])
                    {
                        any = any || !(moved.vertices[v] == before.vertices[v]);
                        moved.vertices[v] = before.vertices[v];
                    }
    }

    void judge(Attempt& attempt) const
    {
        const double voxel = std::max({spacing_.x, spacing_.y, spacing_.z});
        attempt.certificate =
            certify(attempt.mesh, *attempt.surface.oracle, attempt.surface.inventory->surfaces(),
                    {.reach = voxel,
                     .criteria = {.min_angle_deg = options_.criteria.min_facet_angle_deg},
                     .sampling = {.mesh_samples = kDistanceSamples, .surface_samples = kDistanceSamples}},
                    std::span<const SurfaceId>(attempt.surface_of_face));
        attempt.broken_promise = broken_promise(attempt.certificate);
        const double farthest = attempt.certificate.distance.from_surface.max;
        if (!attempt.broken_promise && farthest > kMostDistanceInVoxels * voxel)
            attempt.broken_promise = "a place of the surface " + number_text(farthest) + " mm from the mesh";
        attempt.volume_error = largest_error(part_volumes(attempt));
    }

    //! Of each surface of the field the part whose outer surface or cavity it is, as a place in the group.
    [[nodiscard]] std::vector<std::uint32_t> parts_of_surfaces(const Inventory& inventory) const
    {
        CHECK_EQ(inventory.inside_region_count(), group_.parts.size());
        std::vector<std::uint32_t> part_of_region(inventory.inside_region_count() + 1);
        for (std::uint32_t place = 0; place < group_.parts.size(); ++place)
        {
            const SampleIndex& voxel = survey_.parts()[group_.parts[place]].first_voxel;
            const SampleIndex& first = field_.mask().first;
            const Region region =
                inventory.region(voxel[0] - first[0], voxel[1] - first[1], voxel[2] - first[2]);
            CHECK(is_inside(region));
            part_of_region[static_cast<std::size_t>(region)] = place;
        }
        std::vector<std::uint32_t> parts;
        for (const ScanSurface& surface : inventory.surfaces())
            parts.push_back(part_of_region[static_cast<std::size_t>(surface.inside)]);
        return parts;
    }

    [[nodiscard]] std::vector<double> part_volumes(const Attempt& attempt) const
    {
        std::vector<double> volumes(group_.parts.size(), 0.0);
        for (std::size_t f = 0; f < attempt.mesh.faces.size(); ++f)
        {
            if (attempt.surface_of_face[f] == kNoSurface)
                continue;
            const TriangleMesh::Face& face = attempt.mesh.faces[f];
            volumes[attempt.part_of_surface[static_cast<std::size_t>(attempt.surface_of_face[f])]] +=
                dot(attempt.mesh.corner(face, 0),
                    cross(attempt.mesh.corner(face, 1), attempt.mesh.corner(face, 2))) /
                6.0;
        }
        return volumes;
    }

    [[nodiscard]] double largest_error(const std::vector<double>& volumes) const
    {
        double error = 0.0;
        for (std::size_t part = 0; part < volumes.size(); ++part)
            error = std::max(error, std::abs(volumes[part] / wanted_[part] - 1.0));
        return error;
    }

    GroupMesh result_of(Attempt attempt) const
    {
        GroupMesh result{.mesh = {},
                         .faults = {},
                         .parts_restored = field_.parts_restored(),
                         .vertices_moved = attempt.moved ? attempt.mesh.vertices.size() : 0,
                         .faces_below_angle =
                             count_faces_below_angle(attempt.mesh, options_.criteria.min_facet_angle_deg),
                         .broken_promise = attempt.broken_promise,
                         .status = attempt.status};
        if (attempt.status == MeshingStatus::kDone)
            list_faults(attempt, result);
        result.mesh = std::move(attempt.mesh);
        const SampleIndex& first = field_.mask().first;
        const Vec3 offset{spacing_.x * first[0], spacing_.y * first[1], spacing_.z * first[2]};
        for (Point3& p : result.mesh.vertices)
            p = p + offset;
        return result;
    }

    void list_faults(const Attempt& attempt, GroupMesh& result) const
    {
        const std::vector<ScanSurface>& surfaces = attempt.surface.inventory->surfaces();
        result.cavities_expected = static_cast<std::size_t>(
            std::count_if(surfaces.begin(), surfaces.end(), [](const ScanSurface& s) { return s.cavity; }));
        result.cavities_meshed = result.cavities_expected;
        const auto blame = [&](SurfaceId id, const std::string& reason)
        {
            const auto at = static_cast<std::size_t>(id);
            if (surfaces[at].cavity)
                --result.cavities_meshed;
            else
                result.faults.push_back({group_.parts[attempt.part_of_surface[at]], reason});
        };
        for (const MissingSurface& missing : attempt.certificate.missing)
            blame(missing.id, missing.reason);
        for (const SplitSurface& split : attempt.certificate.split)
            blame(split.id, "in " + std::to_string(split.pieces) + " pieces");
    }

    //! Points on each surface to begin with, and at most after attempts that failed.
    static constexpr std::size_t kFirstSeeds = 16;
    static constexpr std::size_t kMoreSeeds = 8;
    static constexpr std::size_t kMostSeeds = 1024;

    //! Shifts of the field between two runs of the mesher, and the most they ask of a volume each.
    static constexpr int kMostFits = 5;
    static constexpr double kMostGrowth = 2.0;

    //! Farther from the mesh no place of the surface may be: it would not be meshed at all.
    static constexpr double kMostDistanceInVoxels = 3.0;

    //! Distances are not told part by part: enough that the certificate's look at them costs nothing.
    static constexpr std::size_t kDistanceSamples = 64;

    const LabelSurvey& survey_;
    const PartGroup& group_;
    Vec3 spacing_;
    const LabelMeshingOptions& options_;
    ProgressSink* progress_;
    PartField field_;
    std::vector<double> wanted_; //!< volumes of the voxels of each part
};

} // namespace

GroupMesh mesh_group(const LabelSurvey& survey, const PartGroup& group, const Vec3& spacing,
                     const LabelMeshingOptions& options, ProgressSink* progress)
{
    return GroupMeshing(survey, group, spacing, options, progress).run();
}

} // namespace voroprobe
