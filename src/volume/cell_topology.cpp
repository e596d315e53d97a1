// This file follows: G. M. Nielson & B. Hamann, "The asymptotic decider: resolving the ambiguity in marching
// cubes", 1991, and G. M. Nielson, "On marching cubes", 2003 (body saddles). From a saddle the parts that
// meet there are found by walking: the interpolant is constant along the three axis-parallel lines through a
// body saddle, which begin in all of the directions that rise, or fall, from it.

#include "volume/cell_topology.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace voroprobe
{
namespace
{

constexpr std::array<CornerPair, 12> kEdges{
    {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

//! The corners of a face: the first and the last are opposite, as are the two others.
using Face = std::array<std::uint8_t, 4>;
constexpr std::array<Face, 6> kFaces{
    {{0, 2, 4, 6}, {1, 3, 5, 7}, {0, 1, 4, 5}, {2, 3, 6, 7}, {0, 1, 2, 3}, {4, 5, 6, 7}}};

//! A body saddle's value, of heights up to 1, that counts as 0: some roundings. Integer samples often meet
//! it.
constexpr double kSaddleRounding = 1e-14;

constexpr CornerParts kAllApart{0, 1, 2, 3, 4, 5, 6, 7};

//! Eight names are replaced faster than a forest of them is walked.
constexpr void join(CornerParts& parts, std::size_t a, std::size_t b)
{
    const std::uint8_t kept = std::min(parts[a], parts[b]);
    const std::uint8_t gone = std::max(parts[a], parts[b]);
    for (std::uint8_t& part : parts)
        part = part == gone ? kept : part;
}

constexpr bool is_inside_corner(CornerCode code, std::size_t corner)
{
    return (code >> corner & 1U) != 0;
}

struct CodeTable
{
    std::array<CodeTopology, 256> topology{};
    std::array<CornerParts, 256> along_edges{};

    constexpr CodeTable()
    {
        for (std::size_t code = 0; code < 256; ++code)
            describe(static_cast<CornerCode>(code));
    }

private:
    constexpr void describe(CornerCode code)
    {
        CornerParts parts = kAllApart;
        std::uint8_t crossed = 0;
        for (const CornerPair& edge : kEdges)
            if (is_inside_corner(code, edge[0]) == is_inside_corner(code, edge[1]))
                join(parts, edge[0], edge[1]);
            else
                ++crossed;
        int count = 0;
        for (std::size_t corner = 0; corner < 8; ++corner)
            count += parts[corner] == corner ? 1 : 0;
        const auto outside = static_cast<CornerCode>(~code);
        topology[code] = {count <= 2, static_cast<std::uint8_t>(std::countr_zero(code) & 7),
                          static_cast<std::uint8_t>(std::countr_zero(outside) & 7), crossed};
        along_edges[code] = parts;
    }
};

constexpr CodeTable kCodes;

CornerCode code_of(const CellCorners& corners)
{
    unsigned code = 0;
    for (std::size_t corner = 0; corner < 8; ++corner)
        code |= (corners[corner] >= 0.0 ? 1U : 0U) << corner;
    return static_cast<CornerCode>(code);
}

//! In the order of trilinear_value(), to compare exactly what it interpolates between.
template <class IsBetter>
std::size_t corner_reached(const CellCorners& c, const Vec3& local, IsBetter is_better)
{
    const std::array<double, 4> along_x{lerp(c[0], c[1], local.x), lerp(c[2], c[3], local.x),
                                        lerp(c[4], c[5], local.x), lerp(c[6], c[7], local.x)};
    const double z0 = lerp(along_x[0], along_x[1], local.y);
    const double z1 = lerp(along_x[2], along_x[3], local.y);
    const std::size_t z = is_better(z1, z0) ? 2 : 0;
    const std::size_t yz = is_better(along_x[z + 1], along_x[z]) ? z + 1 : z;
    return is_better(c[2 * yz + 1], c[2 * yz]) ? 2 * yz + 1 : 2 * yz;
}

//! The face's saddle is (ad - bc) / (a + d - b - c).
void join_across_face(const CellCorners& h, CornerCode code, const Face& face, CornerParts& parts)
{
    const auto [a, b, c, d] = face;
    const bool ad_inside = is_inside_corner(code, a);
    const bool bc_inside = is_inside_corner(code, b);
    if (is_inside_corner(code, d) != ad_inside || is_inside_corner(code, c) != bc_inside ||
        ad_inside == bc_inside)
        return;
    const double ad = h[a] * h[d];
    const double bc = h[b] * h[c];
    const bool saddle_inside = ad_inside ? ad >= bc : bc >= ad;
    if (saddle_inside == ad_inside)
        join(parts, a, d);
    else
        join(parts, b, c);
}

//! The interpolant as a polynomial: constant + x.x X + x.y Y + x.z Z + xy XY + xz XZ + yz YZ + xyz XYZ.
struct Polynomial
{
    Vec3 first;
    double xy, xz, yz, xyz;

    explicit Polynomial(const CellCorners& c)
        : first{c[1] - c[0], c[2] - c[0], c[4] - c[0]}, xy((c[3] - c[2]) - (c[1] - c[0])),
          xz((c[5] - c[4]) - (c[1] - c[0])), yz((c[6] - c[4]) - (c[2] - c[0])),
          xyz(((c[7] - c[6]) - (c[5] - c[4])) - ((c[3] - c[2]) - (c[1] - c[0])))
    {
    }
};

struct BodySaddles
{
    std::size_t count = 0;
    std::array<Vec3, 2> at;

    void add_if_within(const Vec3& p)
    {
        if (p.x > 0.0 && p.x < 1.0 && p.y > 0.0 && p.y < 1.0 && p.z > 0.0 && p.z < 1.0)
            at[count++] = p;
    }
};

//! Where the gradient is zero. Its y and z components give z and y in terms of x, its x component then a
//! quadratic equation, solved without cancellation; one root lies at infinity where xyz is 0.
BodySaddles find_body_saddles(const CellCorners& corners)
{
    const Polynomial f(corners);
    const double q = f.first.x * f.xyz - f.xy * f.xz;
    const double r = f.first.y * f.xyz - f.xy * f.yz;
    const double s = f.first.z * f.xyz - f.xz * f.yz;
    const double discriminant = -(q * r * s);
    BodySaddles saddles;
    if (!(discriminant > 0.0))
        return saddles;
    const double half = f.yz * q;
    const double root = std::copysign(std::sqrt(discriminant), half);
    const double constant =
        f.yz * (f.first.x * f.yz - f.xy * f.first.z - f.xz * f.first.y) + f.xyz * f.first.y * f.first.z;
    const auto saddle_at = [&](double x, double yz_slope) -> Vec3 {
        return {x, -(f.first.z + f.xz * x) / yz_slope, -(f.first.y + f.xy * x) / yz_slope};
    };
    saddles.add_if_within(saddle_at(-(half + root) / (f.xyz * q), -root / q));
    saddles.add_if_within(saddle_at(-constant / (half + root), root / q));
    return saddles;
}

//! \pre The heights are at most 1. Joins the corners in the parts that touch the lines of constant value
//! through a body saddle.
void join_through_saddle(const CellCorners& corners, CornerCode code, const Vec3& saddle, CornerParts& parts)
{
    const bool inside = trilinear_value(corners, saddle) >= -kSaddleRounding;
    std::size_t joined = 8;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double end : {0.0, 1.0})
        {
            Vec3 on_face = saddle;
            on_face[axis] = end;
            const std::size_t corner =
                inside ? corner_uphill(corners, on_face) : corner_downhill(corners, on_face);
            if (is_inside_corner(code, corner) != inside)
                continue; // a saddle of value 0 but for rounding
            if (joined != 8)
                join(parts, joined, corner);
            joined = corner;
        }
}

bool more_than_two(const CornerParts& parts)
{
    int count = 0;
    for (std::size_t corner = 0; corner < 8; ++corner)
        count += parts[corner] == corner ? 1 : 0;
    return count > 2;
}

CornerParts join_on_faces(const CellCorners& corners, CornerCode code)
{
    CornerParts parts = kCodes.along_edges[code];
    for (const Face& face : kFaces)
        join_across_face(corners, code, face, parts);
    return parts;
}

} // namespace

const CodeTopology& topology_of(CornerCode code)
{
    return kCodes.topology[code];
}

const std::array<CornerPair, 12>& cell_edges()
{
    return kEdges;
}

std::size_t corner_uphill(const CellCorners& corners, const Vec3& local)
{
    return corner_reached(corners, local, [](double a, double b) { return a > b; });
}

std::size_t corner_downhill(const CellCorners& corners, const Vec3& local)
{
    return corner_reached(corners, local, [](double a, double b) { return a < b; });
}

CornersBeside corners_beside(const CellCorners& corners, const Vec3& on_surface)
{
    Vec3 high;
    Vec3 low;
    double steepest = -1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        Vec3 first = on_surface;
        Vec3 second = on_surface;
        first[axis] = 0.0;
        second[axis] = 1.0;
        const double rise = trilinear_value(corners, second) - trilinear_value(corners, first);
        if (std::abs(rise) <= steepest)
            continue;
        steepest = std::abs(rise);
        high = rise > 0.0 ? second : first;
        low = rise > 0.0 ? first : second;
    }
    return {corner_uphill(corners, high), corner_downhill(corners, low)};
}

CellTopology connect_corners_on_faces(const CellCorners& corners)
{
    const CornerParts parts = join_on_faces(corners, code_of(corners));
    return {parts, parts};
}

CellTopology connect_corners(const CellCorners& corners)
{
    const CornerCode code = code_of(corners);
    CellTopology topology;
    topology.on_faces = join_on_faces(corners, code);
    topology.in_cell = topology.on_faces;
    if (!more_than_two(topology.in_cell))
        return topology;

    // Products of six values follow.
    double largest = 0.0;
    for (const double height : corners)
        largest = std::max(largest, std::abs(height));
    CellCorners scaled;
    for (std::size_t corner = 0; corner < 8; ++corner)
        scaled[corner] = corners[corner] / largest;
    const BodySaddles saddles = find_body_saddles(scaled);
    for (std::size_t i = 0; i < saddles.count; ++i)
        join_through_saddle(scaled, code, saddles.at[i], topology.in_cell);
    return topology;
}

} // namespace voroprobe
