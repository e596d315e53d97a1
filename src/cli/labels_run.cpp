#include "cli/labels_run.h"

#include <algorithm>
#include <numeric>

#include "cli/number_text.h"
#include "support/error.h"

namespace voroprobe
{
namespace
{

std::string fault_text(const LabelOutcome& label)
{
    std::string text = "label " + std::to_string(label.value) + " (" + label.name + "): ";
    if (!label.done)
        return text + "not meshed";
    if (!label.mesh.faults.empty())
        return text + count_text(label.mesh.faults.size()) + " of " + count_text(label.parts_expected) +
               " parts not whole, the first " + label.mesh.faults.front().reason;
    return text + label.mesh.broken_promises.front();
}

} // namespace

std::size_t LabelMap::label_count() const
{
    return std::accumulate(layers.begin(), layers.end(), std::size_t{0},
                           [](std::size_t sum, const LabelSurvey& layer)
                           { return sum + layer.labels().size(); });
}

std::size_t LabelMap::part_count() const
{
    return std::accumulate(layers.begin(), layers.end(), std::size_t{0},
                           [](std::size_t sum, const LabelSurvey& layer)
                           { return sum + layer.parts().size(); });
}

bool LabelsRun::complete() const
{
    return std::all_of(labels.begin(), labels.end(),
                       [](const LabelOutcome& label) { return label.done && label.mesh.complete(); });
}

void check_promises(const LabelsRun& run)
{
    constexpr std::size_t kMostNamed = 5;
    std::string text;
    std::size_t count = 0;
    for (const LabelOutcome& label : run.labels)
        if (!(label.done && label.mesh.complete()) && count++ < kMostNamed)
            text += "; " + fault_text(label);
    if (count > kMostNamed)
        text += "; and " + count_text(count - kMostNamed) + " more";
    if (count > 0)
        throw Error(ExitStatus::kIncomplete, "the meshes were written, but " + count_text(count) + " of " +
                                                 count_text(run.labels.size()) +
                                                 " labels are not as promised" + text);
}

} // namespace voroprobe
