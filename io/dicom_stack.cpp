#include "io/dicom_stack.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "support/error.h"

namespace voroprobe
{

namespace
{

//! How far the distance between neighbours may be from the usual one, as a part of it, before it is worth a
//! warning and before the volume is refused. A gap of half a slice more than usual means that a slice is
//! missing.
constexpr double kUnequalSpacingWarning = 0.01;
constexpr double kUnequalSpacingError = 0.1;
constexpr double kMissingSlice = 0.5;

//! How far the last slice may be shifted sideways against the first, as a part of a pixel: warning and error.
constexpr double kSidewaysWarning = 0.1;
constexpr double kSidewaysError = 1.0;

Vec3 slice_normal(const Slice& slice)
{
    return cross(slice.lattice.direction.column[0], slice.lattice.direction.column[1]);
}

std::string names_text(const Slice& a, const Slice& b)
{
    return std::filesystem::path(a.file).filename().string() + " and " +
           std::filesystem::path(b.file).filename().string();
}

//! Distances between neighbouring slices along their normal. \throw InputError where two slices are at one
//! place.
std::vector<double> slice_distances(const std::vector<Slice>& slices, const Vec3& normal)
{
    std::vector<double> distances;
    for (std::size_t i = 0; i + 1 < slices.size(); ++i)
    {
        distances.push_back(dot(slices[i + 1].lattice.origin - slices[i].lattice.origin, normal));
        constexpr double kSamePlace = 1e-4; // mm
        if (distances.back() < kSamePlace)
            throw InputError("slices " + names_text(slices[i], slices[i + 1]) +
                             " are at the same position, expected one slice at each");
    }
    return distances;
}

//! \throw InputError where a slice is missing or the distances differ too much; a warning where they differ a
//! little.
void require_equal_distances(const std::vector<Slice>& slices, const std::vector<double>& distances,
                             std::vector<std::string>& warnings)
{
    std::vector<double> sorted = distances;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                     sorted.end());
    const double usual = sorted[sorted.size() / 2];

    const auto deviation = [usual](double distance) { return std::abs(distance / usual - 1.0); };
    const auto worst = std::max_element(distances.begin(), distances.end(),
                                        [&](double a, double b) { return deviation(a) < deviation(b); });
    const auto at = static_cast<std::size_t>(worst - distances.begin());
    const std::string text = names_text(slices[at], slices[at + 1]) + " are " + std::to_string(*worst) +
                             " mm apart, expected " + std::to_string(usual) + " mm as between the others";
    if (*worst > (1.0 + kMissingSlice) * usual)
        throw InputError("a slice is missing: " + text);
    if (deviation(*worst) > kUnequalSpacingError)
        throw InputError("unequal spacing: slices " + text);
    if (deviation(*worst) > kUnequalSpacingWarning)
        warnings.push_back("unequal spacing, taken as equal: slices " + text);
}

//! Slices of a tilted gantry are shifted sideways one against the next; that is a sheared grid.
void require_straight_stack(const std::vector<Slice>& slices, const Vec3& normal,
                            std::vector<std::string>& warnings)
{
    const StoredLattice& first = slices.front().lattice;
    const Vec3 whole = slices.back().lattice.origin - first.origin;
    const double sideways =
        norm(whole - dot(whole, normal) * normal) / std::min(first.spacing.x, first.spacing.y);
    const std::string text = "the slices are shifted sideways by " + std::to_string(sideways) +
                             " pixels from first to last (tilted gantry)";
    if (sideways > kSidewaysError)
        throw InputError(text + ", expected them straight above each other");
    if (sideways > kSidewaysWarning)
        warnings.push_back(text + "; taken as straight");
}

} // namespace

void order_by_position(std::vector<Slice>& slices)
{
    const Vec3 normal = slice_normal(slices.front());
    std::stable_sort(slices.begin(), slices.end(),
                     [&](const Slice& a, const Slice& b)
                     { return dot(a.lattice.origin, normal) < dot(b.lattice.origin, normal); });
}

StoredLattice stack_lattice(const std::vector<Slice>& slices, std::vector<std::string>& warnings)
{
    StoredLattice lattice = slices.front().lattice;
    if (slices.size() == 1)
        return lattice; // one sample thick: read_volume refuses it
    const Vec3 normal = slice_normal(slices.front());
    const std::vector<double> distances = slice_distances(slices, normal);
    require_equal_distances(slices, distances, warnings);
    require_straight_stack(slices, normal, warnings);
    lattice.direction.column[2] = normal;
    lattice.size[2] = slices.size();
    lattice.spacing.z =
        dot(slices.back().lattice.origin - lattice.origin, normal) / static_cast<double>(slices.size() - 1);
    return lattice;
}

} // namespace voroprobe
