#include "mesher/initialization.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace voroprobe
{
namespace
{

// Each new attempt for the same vertex starts with a triangle this much smaller.
constexpr double kShrinkPerAttempt = 0.25;
// Smallest cube tried, as a fraction of the floor radius: features of the surface below the floor are not
// pursued.
constexpr double kSmallestCubeInFloors = 0.5;
// Wanted distance between the first two points, in half sides of the cube: its edges are 1.41 to 1.73 away.
constexpr double kFirstEdge = 1.5;
// Height of the equilateral triangle, in sides.
constexpr double kEquilateralHeight = 0.87;
// Largest half side of the cube, as a fraction of the largest ball radius: the first edge is then at most
// 0.87 of that radius and the ball of an equilateral triangle half of it.
constexpr double kLargeHalfSide = 0.5;
// The same for a persistent facet, whose ball must be smaller than that whatever the surface does.
constexpr double kPersistentHalfSide = 0.25;
// Half the side of the square, in distances between the first two points: its edges are then 0.75 to 1.06 of
// that distance away from the midpoint, around the height of the equilateral triangle (0.87).
constexpr double kSquareHalfSide = 0.75;
// The points added must be this far, in half sides of the cube, from every vertex: two vertices close
// together would be surrounded by a cluster of triangles of their size.
constexpr double kLeastSeparation = 0.5;

using Segments4 = std::array<Segment3, 4>;

//! The edges of the square center +- a +- b.
Segments4 square_edges(const Point3& center, const Vec3& a, const Vec3& b)
{
    const std::array<Point3, 4> corner{center - a - b, center + a - b, center + a + b, center - a + b};
    return {{{corner[0], corner[1]}, {corner[1], corner[2]}, {corner[2], corner[3]}, {corner[3], corner[0]}}};
}

//! The edges of an axis-aligned cube: those of two opposite sides and the four between them.
std::array<Segments4, 3> cube_edges(const Point3& center, double half_side)
{
    const Vec3 x{half_side, 0, 0};
    const Vec3 y{0, half_side, 0};
    const Vec3 z{0, 0, half_side};
    Segments4 between;
    for (std::size_t i = 0; i < 4; ++i)
    {
        const Point3 foot = square_edges(center - z, x, y)[i].source;
        between[i] = {foot, foot + 2.0 * z};
    }
    return {square_edges(center - z, x, y), square_edges(center + z, x, y), between};
}

//! Two unit vectors that span the plane orthogonal to the unit vector `normal`.
std::pair<Vec3, Vec3> orthonormal_basis(const Vec3& normal)
{
    const Vec3 size{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
    const Vec3 axis = size.x <= size.y && size.x <= size.z ? Vec3{1, 0, 0}
                      : size.y <= size.z                   ? Vec3{0, 1, 0}
                                                           : Vec3{0, 0, 1};
    const Vec3 a = normalized(cross(normal, axis));
    return {a, cross(normal, a)};
}

class ComponentInitialization
{
public:
    ComponentInitialization(const SurfaceOracle& oracle, MeshingStatistics& statistics)
        : oracle_(oracle), statistics_(statistics)
    {
    }

    //! Second and third point for a cube of the given size; nullopt where one of them does not show.
    std::optional<std::array<Point3, 2>> find_triangle(const Point3& first, double half_side)
    {
        std::optional<Point3> second;
        for (const Segments4& edges : cube_edges(first, half_side))
            keep_nearest(edges, first, kFirstEdge * half_side, second);
        if (!second)
            return std::nullopt;

        const double length = distance(first, *second);
        const auto [a, b] = orthonormal_basis((*second - first) / length);
        const double half_square = kSquareHalfSide * length;
        const Point3 middle = 0.5 * (first + *second);
        std::optional<Point3> third;
        keep_nearest(square_edges(middle, half_square * a, half_square * b), middle,
                     kEquilateralHeight * length, third);
        if (!third)
            return std::nullopt;
        return std::array<Point3, 2>{*second, *third};
    }

private:
    //! Among the crossings of the segments, and `best`, keeps the one whose distance from `from` is nearest
    //! to the wanted one.
    void keep_nearest(const Segments4& segments, const Point3& from, double wanted,
                      std::optional<Point3>& best)
    {
        for (const Segment3& segment : segments)
        {
            ++statistics_.queries_initialization;
            oracle_.find_crossings(segment, crossings_);
            for (const Crossing& crossing : crossings_)
            {
                const double misfit = std::abs(distance(from, crossing.point) - wanted);
                if (!best || misfit < std::abs(distance(from, *best) - wanted))
                    best = crossing.point;
            }
        }
    }

    const SurfaceOracle& oracle_;
    MeshingStatistics& statistics_;
    std::vector<Crossing> crossings_;
};

} // namespace

bool initialize_component(VertexHandle first, const RestrictedDelaunay& restricted,
                          const MeshingOptions& options, Refinement& refinement,
                          MeshingStatistics& statistics)
{
    ComponentInitialization initialization(restricted.oracle(), statistics);
    const int attempt = first->info().initializations++;
    const double half_side_of_cube = options.persistent_initialization ? kPersistentHalfSide : kLargeHalfSide;
    const double largest =
        half_side_of_cube * options.max_facet_radius * std::pow(kShrinkPerAttempt, attempt);
    const double smallest = std::min(largest, kSmallestCubeInFloors * options.floor_radius);
    for (double half_side = largest; half_side >= smallest; half_side *= 0.5)
    {
        const auto points = initialization.find_triangle(position(first), half_side);
        if (!points)
            continue;
        const double apart = kLeastSeparation * half_side;
        const auto is_apart = [&](const Point3& p) { return restricted.is_apart(p, apart, first); };
        if (!std::all_of(points->begin(), points->end(), is_apart))
            continue;
        for (const Point3& p : *points)
            refinement.insert(p, VertexOrigin::kInitialization, first);
        return true;
    }
    return false;
}

} // namespace voroprobe
