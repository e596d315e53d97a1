#include "certificate/object_overlaps.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace voroprobe
{

std::vector<ObjectOverlap> take_object_overlaps(std::vector<FacePair>& pairs,
                                                std::span<const std::size_t> faces_in_objects)
{
    std::vector<std::size_t> ends(faces_in_objects.size());
    std::partial_sum(faces_in_objects.begin(), faces_in_objects.end(), ends.begin());
    const auto object_of = [&](std::size_t face)
    { return static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), face) - ends.begin()); };

    std::map<std::pair<std::size_t, std::size_t>, std::size_t> count;
    std::erase_if(pairs,
                  [&](const FacePair& pair)
                  {
                      const std::pair objects{object_of(pair.first), object_of(pair.second)};
                      const bool is_overlap = objects.first != objects.second;
                      if (is_overlap)
                          ++count[objects];
                      return is_overlap;
                  });
    std::vector<ObjectOverlap> overlaps;
    for (const auto& [objects, face_pairs] : count)
        overlaps.push_back({objects.first, objects.second, face_pairs});
    return overlaps;
}

} // namespace voroprobe
