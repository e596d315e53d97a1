#include "labels/label_meshing.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <utility>

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include "mesh/measures.h"
#include "support/error.h"
#include "support/number_text.h"

namespace voroprobe
{
namespace
{

//! Gathers what the threads report, for a sink that takes one report at a time.
class SharedProgress
{
public:
    SharedProgress(ProgressSink* sink, std::size_t labels) : sink_(sink), labels_(labels) {}

    void add(std::size_t vertices, std::size_t bad_facets_left)
    {
        vertices_ += vertices;
        const std::unique_lock lock(mutex_, std::try_to_lock);
        if (lock && sink_ != nullptr)
            sink_->report({.phase = phase(), .vertices = vertices_, .bad_facets_left = bad_facets_left});
    }

    void label_done() { ++labels_done_; }

    [[nodiscard]] bool stop_requested() const
    {
        return failed_ || (sink_ != nullptr && sink_->stop_requested());
    }

    void fail() { failed_ = true; }

private:
    std::string phase() const
    {
        return std::to_string(labels_done_) + " of " + std::to_string(labels_) + " labels";
    }

    ProgressSink* sink_;
    std::size_t labels_;
    std::atomic<std::size_t> labels_done_ = 0;
    std::atomic<std::size_t> vertices_ = 0;
    std::atomic<bool> failed_ = false;
    std::mutex mutex_;
};

//! What one meshing run reports, added to the common count.
class GroupProgress final : public ProgressSink
{
public:
    explicit GroupProgress(SharedProgress& shared) : shared_(shared) {}

    void report(const ProgressReport& report) override
    {
        const std::size_t more = report.vertices > reported_ ? report.vertices - reported_ : 0;
        reported_ += more;
        shared_.add(more, report.bad_facets_left);
    }

    [[nodiscard]] bool stop_requested() const override { return shared_.stop_requested(); }

private:
    SharedProgress& shared_;
    std::size_t reported_ = 0;
};

//! A label whose groups are being meshed.
struct LabelInWork
{
    std::uint32_t label;
    std::vector<PartGroup> groups;
    std::vector<std::optional<GroupMesh>> meshes;
    std::atomic<std::size_t> groups_left;

    LabelInWork(std::uint32_t place, std::vector<PartGroup> of_label)
        : label(place), groups(std::move(of_label)), meshes(groups.size()), groups_left(groups.size())
    {
    }
};

void append(TriangleMesh& mesh, const TriangleMesh& more)
{
    const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
    for (const TriangleMesh::Face& face : more.faces)
        mesh.faces.push_back({face[0] + offset, face[1] + offset, face[2] + offset});
}

LabelMesh gather(const LabelSurvey& survey, const LabelInWork& work, const Vec3& spacing)
{
    const SurveyedLabel& label = survey.labels()[work.label];
    LabelMesh result{.label = work.label, .mesh = {}, .faults = {}, .broken_promises = {}};
    for (const std::optional<GroupMesh>& group : work.meshes)
    {
        append(result.mesh, group->mesh);
        result.faults.insert(result.faults.end(), group->faults.begin(), group->faults.end());
        result.parts_restored += group->parts_restored;
        result.cavities_expected += group->cavities_expected;
        result.cavities_meshed += group->cavities_meshed;
        result.faces_below_angle += group->faces_below_angle;
        result.mesh_volume += enclosed_volume(group->mesh);
        if (group->broken_promise)
            result.broken_promises.push_back(*group->broken_promise);
    }
    result.parts_meshed = label.parts.size() - result.faults.size();
    result.voxel_volume = spacing.x * spacing.y * spacing.z * static_cast<double>(label.voxels);
    return result;
}

//! The labels of one call of mesh_labels() and the threads that work on them.
class LabelQueue
{
public:
    LabelQueue(const LabelSurvey& survey, std::span<const std::uint32_t> labels, const Vec3& spacing,
               const LabelMeshingOptions& options, ProgressSink* progress,
               const std::function<void(LabelMesh)>& done)
        : survey_(survey), spacing_(spacing), options_(options), done_(done),
          progress_(progress, labels.size()), labels_(labels.begin(), labels.end())
    {
        std::stable_sort(labels_.begin(), labels_.end(),
                         [&](std::uint32_t a, std::uint32_t b)
                         { return survey.labels()[a].voxels > survey.labels()[b].voxels; });
    }

    //! Works until nothing is left. To be called by each thread.
    void work()
    {
        try
        {
            while (const std::optional<Task> task = next_task())
                // Not to take up another group while waiting for the threads that help with this one.
                tbb::this_task_arena::isolate([&] { run(*task); });
        }
        catch (...)
        {
            progress_.fail(); // lest the others work on in vain
            throw;
        }
    }

private:
    struct Task
    {
        std::shared_ptr<LabelInWork> label;
        std::size_t group;
    };

    //! The next group of the label at hand, or the first of the next label.
    std::optional<Task> next_task()
    {
        const std::scoped_lock lock(queue_mutex_);
        if (progress_.stop_requested())
            return std::nullopt;
        if (!current_ || next_group_ == current_->groups.size())
        {
            if (next_label_ == labels_.size())
                return std::nullopt;
            const std::uint32_t label = labels_[next_label_++];
            current_ = std::make_shared<LabelInWork>(label, group_parts(survey_, survey_.labels()[label]));
            next_group_ = 0;
        }
        return Task{current_, next_group_++};
    }

    void run(const Task& task)
    {
        LabelInWork& label = *task.label;
        GroupProgress progress(progress_);
        GroupMesh mesh = mesh_group(survey_, label.groups[task.group], spacing_, options_, &progress);
        if (mesh.status == MeshingStatus::kBudgetExhausted)
            throw Error(ExitStatus::kBudget,
                        "label " + std::to_string(survey_.labels()[label.label].value) + " takes more than " +
                            count_text(options_.criteria.max_vertices.value_or(0)) +
                            " vertices at this size, distance and floor; it was not meshed");
        if (mesh.status != MeshingStatus::kDone)
            return; // stopped: the label is never done
        label.meshes[task.group] = std::move(mesh);
        if (--label.groups_left > 0)
            return;
        LabelMesh result = gather(survey_, label, spacing_);
        label.meshes.clear();
        progress_.label_done();
        const std::scoped_lock lock(done_mutex_);
        done_(std::move(result));
    }

    const LabelSurvey& survey_;
    Vec3 spacing_;
    const LabelMeshingOptions& options_;
    const std::function<void(LabelMesh)>& done_;
    SharedProgress progress_;
    std::vector<std::uint32_t> labels_; //!< largest first

    std::mutex queue_mutex_; //!< of the next three
    std::size_t next_label_ = 0;
    std::shared_ptr<LabelInWork> current_;
    std::size_t next_group_ = 0;

    std::mutex done_mutex_;
};

} // namespace

void mesh_labels(const LabelSurvey& survey, std::span<const std::uint32_t> labels, const Vec3& spacing,
                 const LabelMeshingOptions& options, std::size_t threads, ProgressSink* progress,
                 const std::function<void(LabelMesh)>& done)
{
    check_smoothing(options.smoothing, spacing);
    const std::size_t count =
        threads > 0 ? threads : static_cast<std::size_t>(tbb::info::default_concurrency());
    // More threads than cores are had for the asking only.
    const tbb::global_control allowed(
        tbb::global_control::max_allowed_parallelism,
        std::max(count, tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism)));
    LabelQueue queue(survey, labels, spacing, options, progress, done);
    tbb::task_arena arena(static_cast<int>(count));
    arena.execute(
        [&]
        {
            tbb::task_group workers;
            for (std::size_t i = 0; i < count; ++i)
                workers.run([&] { queue.work(); });
            workers.wait();
        });
}

} // namespace voroprobe
