#include "certificate/flat_stars.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "support/grouping.h"

namespace voroprobe
{
namespace
{

//! Bound on the error of a sum of products of three numbers, two of them differences of coordinates, as a
//! share of the sum of their magnitudes: eight roundings of half an epsilon each at most.
constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();

//! Below this much the products may have been rounded to nothing.
constexpr double kUnderflow = 1e-280;

//! More faces around a vertex are not worth it.
constexpr std::size_t kMostFaces = 32;

//! The corners of a face after the one at the vertex it is grouped under.
struct Wedge
{
    std::uint32_t next;
    std::uint32_t last;
};

Grouping<Wedge> wedges_at_vertices(const TriangleMesh& mesh)
{
    return Grouping<Wedge>(mesh.vertices.size(),
                           [&](auto&& visit)
                           {
                               for (const TriangleMesh::Face& face : mesh.faces)
                                   for (std::size_t i = 0; i < 3; ++i)
                                       visit(face[i], Wedge{face[(i + 1) % 3], face[(i + 2) % 3]});
                           });
}

//! Puts the wedges in such an order that each ends where the next begins; false where they are not one round.
bool put_in_round(std::span<Wedge> wedges)
{
    for (std::size_t i = 1; i < wedges.size(); ++i)
    {
        const auto follows = [&](const Wedge& wedge) { return wedge.next == wedges[i - 1].last; };
        const auto next =
            std::find_if(wedges.begin() + static_cast<std::ptrdiff_t>(i), wedges.end(), follows);
        if (next == wedges.end() || wedges[i - 1].last == wedges.front().next)
            return false;
        std::swap(wedges[i], *next);
    }
    return wedges.back().last == wedges.front().next;
}

double sum_of_magnitudes(const Vec3& u, const Vec3& v, const Vec3& direction)
{
    return (std::abs(u.y * v.z) + std::abs(u.z * v.y)) * std::abs(direction.x) +
           (std::abs(u.z * v.x) + std::abs(u.x * v.z)) * std::abs(direction.y) +
           (std::abs(u.x * v.y) + std::abs(u.y * v.x)) * std::abs(direction.z);
}

//! Whether u, v and the direction are for certain a right-handed system.
bool turns_left(const Vec3& u, const Vec3& v, const Vec3& direction)
{
    return dot(cross(u, v), direction) > kRounding * sum_of_magnitudes(u, v, direction) + kUnderflow;
}

//! A plane that holds the direction, and on which side of it edges lie.
class Divide
{
public:
    enum class Side
    {
        kBelow,
        kAbove, //!< or on the plane
        kUncertain
    };

    explicit Divide(const Vec3& direction) : direction_(direction)
    {
        for (std::size_t axis = 1; axis < 3; ++axis)
            if (std::abs(direction[axis]) > std::abs(direction[a_]))
                a_ = axis;
        const std::size_t first = (a_ + 1) % 3;
        const std::size_t second = (a_ + 2) % 3;
        b_ = std::abs(direction[first]) > std::abs(direction[second]) ? first : second;
    }

    [[nodiscard]] Side side(const Vec3& edge) const
    {
        if ((edge[a_] == 0.0 || direction_[b_] == 0.0) && edge[b_] == 0.0)
            return Side::kAbove; // on the plane: what is in line with the grid often is
        const double first = edge[a_] * direction_[b_];
        const double second = edge[b_] * direction_[a_];
        const double height = first - second;
        if (std::abs(height) <= kRounding * (std::abs(first) + std::abs(second)) + kUnderflow)
            return Side::kUncertain;
        return height < 0.0 ? Side::kBelow : Side::kAbove;
    }

private:
    Vec3 direction_;
    std::size_t a_ = 0; //!< axes of the two largest components
    std::size_t b_ = 0;
};

//! Where all wedges turn left seen along a direction, they go round as often as they pass from below a plane
//! that holds it to above.
bool goes_round_once(const Point3& vertex, std::span<const Wedge> round, const TriangleMesh& mesh)
{
    Vec3 direction;
    for (const Wedge& wedge : round)
        direction += cross(mesh.vertices[wedge.next] - vertex, mesh.vertices[wedge.last] - vertex);
    const Divide divide(direction);
    std::size_t rounds = 0;
    Vec3 edge = mesh.vertices[round.front().next] - vertex;
    Divide::Side side = divide.side(edge);
    for (const Wedge& wedge : round)
    {
        const Vec3 next_edge = mesh.vertices[wedge.last] - vertex;
        const Divide::Side next_side = divide.side(next_edge);
        if (side == Divide::Side::kUncertain || !turns_left(edge, next_edge, direction))
            return false;
        rounds += side == Divide::Side::kBelow && next_side == Divide::Side::kAbove ? 1 : 0;
        edge = next_edge;
        side = next_side;
    }
    return rounds == 1;
}

} // namespace

std::vector<std::uint8_t> find_flat_stars(const TriangleMesh& mesh)
{
    Grouping<Wedge> wedges = wedges_at_vertices(mesh);
    std::vector<std::uint8_t> flat(mesh.vertices.size(), 0);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, flat.size()),
                      [&](const tbb::blocked_range<std::size_t>& range)
                      {
                          for (std::size_t v = range.begin(); v < range.end(); ++v)
                          {
                              const std::span<Wedge> round = wedges.of(v);
                              const bool may_be = round.size() >= 3 && round.size() <= kMostFaces;
                              flat[v] = may_be && put_in_round(round) &&
                                        goes_round_once(mesh.vertices[v], round, mesh);
                          }
                      });
    return flat;
}

} // namespace voroprobe
