#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "certificate/self_intersections.h"

namespace voroprobe
{

//! Two objects of a file whose faces meet: neighbours that touch or overlap, which is no fault of either.
struct ObjectOverlap
{
    std::size_t first; //!< numbers of the objects, the smaller first
    std::size_t second;
    std::size_t face_pairs;
};

//! Takes the pairs of faces of different objects out of `pairs` and counts them by objects, ascending.
//! `faces_in_objects`: how many faces each object has; they are numbered object by object. Cost: O(n log n)
//! in the pairs.
std::vector<ObjectOverlap> take_object_overlaps(std::vector<FacePair>& pairs,
                                                std::span<const std::size_t> faces_in_objects);

} // namespace voroprobe
