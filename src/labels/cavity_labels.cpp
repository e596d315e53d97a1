#include "labels/cavity_labels.h"

#include <array>
#include <cstddef>
#include <map>
#include <utility>

#include "labels/label_cavities.h"

namespace voroprobe
{
namespace
{

//! What is known of a value.
struct Named
{
    PartitionLabel stands_for = 0;
    std::map<PartitionLabel, std::uint32_t> cavities_around = {};
};

class CavityLabelling
{
public:
    CavityLabelling(const LabelSurvey& survey, std::span<const std::uint32_t> labels)
        : survey_(survey), labels_(labels), size_(survey.size())
    {
        std::vector<std::int32_t> value_of(survey.labels().size(), 0);
        for (const std::uint32_t place : labels)
        {
            value_of[place] = static_cast<std::int32_t>(named_.size());
            named_.push_back({place + 1});
        }
        values_.resize(static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]) *
                       static_cast<std::size_t>(size_[2]));
        for (int k = 0; k < size_[2]; ++k)
            for (int j = 0; j < size_[1]; ++j)
                for (const LabelRun& run : survey.row(j, k))
                    for (int i = run.first; i < run.end; ++i)
                        values_[at(i, j, k)] = value_of[survey.parts()[run.part].label];
    }

    CavityLabels run()
    {
        for (const std::uint32_t place : labels_)
            rename_cavities_of(place);
        const auto count = [&](std::size_t axis) { return static_cast<std::size_t>(size_[axis]); };
        CavityLabels result{
            LabelSurvey(make_volume(
                {.size = {count(0), count(1), count(2)}, .spacing = {1, 1, 1}, .direction = {}, .origin = {}},
                std::move(values_))),
            {0},
            {{}}};
        for (const SurveyedLabel& label : result.survey.labels())
        {
            const Named& named = named_[static_cast<std::size_t>(label.value)];
            result.stands_for.push_back(named.stands_for);
            result.cavities_around.push_back(named.cavities_around);
        }
        return result;
    }

private:
    [[nodiscard]] std::size_t at(int i, int j, int k) const
    {
        return static_cast<std::size_t>(i) +
               static_cast<std::size_t>(size_[0]) *
                   (static_cast<std::size_t>(j) +
                    static_cast<std::size_t>(size_[1]) * static_cast<std::size_t>(k));
    }

    //! What lies in cavities of several labels is named anew by each of them.
    void rename_cavities_of(std::uint32_t place)
    {
        std::map<std::pair<std::uint32_t, std::int32_t>, std::int32_t> new_value; // by cavity and value
        for (const CavityRun& run : find_cavities(survey_, place))
            for (int i = run.first; i < run.end; ++i)
            {
                std::int32_t& value = values_[at(i, run.j, run.k)];
                const auto [known, is_new] =
                    new_value.emplace(std::pair{run.cavity, value}, static_cast<std::int32_t>(named_.size()));
                if (is_new)
                {
                    Named named = named_[static_cast<std::size_t>(value)];
                    named.cavities_around.emplace(place + 1, run.cavity);
                    named_.push_back(std::move(named));
                }
                value = known->second;
            }
    }

    const LabelSurvey& survey_;
    std::span<const std::uint32_t> labels_;
    std::array<int, 3> size_;
    std::vector<std::int32_t> values_; //!< by sample, 0 for the background outside of all cavities
    std::vector<Named> named_{{}};     //!< by value
};

} // namespace

CavityLabels label_cavities_apart(const LabelSurvey& survey, std::span<const std::uint32_t> labels)
{
    return CavityLabelling(survey, labels).run();
}

} // namespace voroprobe
