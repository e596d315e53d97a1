#include "labels/enclosed_background.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace voroprobe
{
namespace
{

//! Values of a label map and of what is enclosed in it.
class Enclosures
{
public:
    Enclosures(const LabelSurvey& survey, std::span<const std::uint32_t> labels)
        : size_(survey.size()), next_value_(static_cast<std::int32_t>(labels.size()) + 1)
    {
        std::vector<std::int32_t> value_of(survey.labels().size(), 0);
        for (std::size_t n = 0; n < labels.size(); ++n)
            value_of[labels[n]] = static_cast<std::int32_t>(n) + 1;
        values_.resize(static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]) *
                       static_cast<std::size_t>(size_[2]));
        for (int k = 0; k < size_[2]; ++k)
            for (int j = 0; j < size_[1]; ++j)
                for (const LabelRun& run : survey.row(j, k))
                    for (int i = run.first; i < run.end; ++i)
                        values_[at({i, j, k})] = value_of[survey.parts()[run.part].label];
    }

    std::vector<std::int32_t> name_all()
    {
        visited_.assign(values_.size(), false);
        for (int k = 0; k < size_[2]; ++k)
            for (int j = 0; j < size_[1]; ++j)
                for (int i = 0; i < size_[0]; ++i)
                    if (const std::size_t sample = at({i, j, k}); values_[sample] == 0 && !visited_[sample])
                        if (flood({i, j, k}))
                            name_flooded();
        return std::move(values_);
    }

private:
    [[nodiscard]] std::size_t at(const SampleIndex& index) const
    {
        return static_cast<std::size_t>(index[0]) +
               static_cast<std::size_t>(size_[0]) *
                   (static_cast<std::size_t>(index[1]) +
                    static_cast<std::size_t>(size_[1]) * static_cast<std::size_t>(index[2]));
    }

    [[nodiscard]] bool is_in_volume(const SampleIndex& index) const
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (index[axis] < 0 || index[axis] >= size_[axis])
                return false;
        return true;
    }

    //! Gathers the background that is joined with a sample. \return whether a single label encloses it.
    bool flood(const SampleIndex& from)
    {
        std::int32_t label = 0;
        bool is_enclosed = true;
        flooded_ = {from};
        visited_[at(from)] = true;
        for (std::size_t n = 0; n < flooded_.size(); ++n)
            for (std::size_t axis = 0; axis < 3; ++axis)
                for (const int step : {-1, 1})
                {
                    SampleIndex next = flooded_[n];
                    next[axis] += step;
                    if (!is_in_volume(next))
                    {
                        is_enclosed = false;
                        continue;
                    }
                    const std::size_t sample = at(next);
                    if (values_[sample] > 0)
                    {
                        is_enclosed = is_enclosed && (label == 0 || label == values_[sample]);
                        label = values_[sample];
                    }
                    else if (!visited_[sample])
                    {
                        visited_[sample] = true;
                        flooded_.push_back(next);
                    }
                }
        return is_enclosed;
    }

    void name_flooded()
    {
        for (const SampleIndex& index : flooded_)
            values_[at(index)] = next_value_;
        ++next_value_;
    }

    std::array<int, 3> size_;
    std::int32_t next_value_;
    std::vector<std::int32_t> values_; //!< by sample, 0 for background
    std::vector<bool> visited_;        //!< by sample
    std::vector<SampleIndex> flooded_; //!< scratch
};

} // namespace

LabelSurvey with_enclosed_background(const LabelSurvey& survey, std::span<const std::uint32_t> labels)
{
    const auto count = [&](std::size_t axis) { return static_cast<std::size_t>(survey.size()[axis]); };
    return LabelSurvey(make_volume(
        {.size = {count(0), count(1), count(2)}, .spacing = {1, 1, 1}, .direction = {}, .origin = {}},
        Enclosures(survey, labels).name_all()));
}

} // namespace voroprobe
