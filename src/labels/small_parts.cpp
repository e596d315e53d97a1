#include "labels/small_parts.h"

#include <algorithm>
#include <cstddef>

namespace voroprobe
{
namespace
{

//! The volume of larger ones hardly depends on how they are smoothed.
constexpr std::size_t kMostVoxels = 1000;

class Neighbourhood
{
public:
    explicit Neighbourhood(const CavityLabels& apart) : apart_(apart), survey_(apart.survey) {}

    //! Whether a voxel next to the run, through a face, an edge or a corner, stands for the same and is not
    //! of its part.
    [[nodiscard]] bool is_crowded(const LabelRun& run, int j, int k) const
    {
        for (int z = k - 1; z <= k + 1; ++z)
            for (int y = j - 1; y <= j + 1; ++y)
                if (row_has_same(run, y, z))
                    return true;
        return false;
    }

private:
    [[nodiscard]] PartitionLabel stands_for(const LabelRun& run) const
    {
        return apart_.stands_for[survey_.parts()[run.part].label + 1];
    }

    [[nodiscard]] bool row_has_same(const LabelRun& run, int j, int k) const
    {
        std::int32_t begin = run.first - 1; // of what is not looked at yet
        for (const LabelRun& other : survey_.row(j, k))
        {
            if (other.end <= begin)
                continue;
            if (other.first > run.end)
                break;
            if (stands_for(run) == 0 && begin < other.first)
                return true;
            if (other.part != run.part && stands_for(other) == stands_for(run))
                return true;
            begin = other.end;
        }
        return stands_for(run) == 0 && begin <= run.end;
    }

    const CavityLabels& apart_;
    const LabelSurvey& survey_;
};

} // namespace

std::vector<std::uint32_t> small_parts_alone(const CavityLabels& apart)
{
    const LabelSurvey& survey = apart.survey;
    const Neighbourhood neighbourhood(apart);
    std::vector<bool> may_grow;
    for (const LabelPart& part : survey.parts())
        may_grow.push_back(part.voxels <= kMostVoxels);
    for (int k = 0; k < survey.size()[2]; ++k)
        for (int j = 0; j < survey.size()[1]; ++j)
            for (const LabelRun& run : survey.row(j, k))
                may_grow[run.part] = may_grow[run.part] && !neighbourhood.is_crowded(run, j, k);
    std::vector<std::uint32_t> alone;
    for (std::uint32_t part = 0; part < may_grow.size(); ++part)
        if (may_grow[part])
            alone.push_back(part);
    return alone;
}

} // namespace voroprobe
