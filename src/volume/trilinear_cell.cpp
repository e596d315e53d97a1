// This file follows: G. Farin, "Curves and Surfaces for CAGD", 2002, Sec. 3.5 (blossoms) and 5.2 (variation
// diminution): the Bernstein coefficients of a multi-affine function along a segment are averages of its
// values at the corners of the box around the segment, and the cubic changes sign no more often than its
// coefficients.

#include "volume/trilinear_cell.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voroprobe
{
namespace
{

//! Step of the parameter below which a root counts as found. Newton's steps shrink quadratically: the error
//! is far smaller.
constexpr double kRootTolerance = 1e-12;

//! Bisection alone reaches the tolerance in 40 steps; Newton's takes about 4.
constexpr int kMaxRootSteps = 100;

//! Two numbers that go through the same operations side by side, each as it would alone.
using Pair __attribute__((vector_size(2 * sizeof(double)))) = double;

inline Pair both(double value)
{
    return Pair{value, value};
}

inline Pair lerp(Pair a, Pair b, Pair f)
{
    return (1.0 - f) * a + f * b;
}

//! The same cubic in powers of the parameter.
struct PowerCubic
{
    double c0, c1, c2, c3;

    explicit PowerCubic(const BernsteinCubic& b)
        : c0(b[0]), c1(3.0 * (b[1] - b[0])), c2(3.0 * ((b[2] - b[1]) - (b[1] - b[0]))),
          c3((b[3] - b[0]) - 3.0 * (b[2] - b[1]))
    {
    }

    [[nodiscard]] double value(double w) const { return c0 + w * (c1 + w * (c2 + w * c3)); }
    [[nodiscard]] double slope(double w) const { return c1 + w * (2.0 * c2 + w * 3.0 * c3); }
};

//! A parameter and the side the cubic lies on there.
struct Sided
{
    double w;
    bool inside;
};

//! The change of side between `low` and `high`, by Newton's method; where that leaves the bracket or shrinks
//! its steps by less than half, by bisection.
double root_in_bracket(const PowerCubic& cubic, Sided low, Sided high, double guess)
{
    double w = guess;
    double last_step = high.w - low.w;
    for (int i = 0; i < kMaxRootSteps; ++i)
    {
        const double value = cubic.value(w);
        ((value >= 0.0) == low.inside ? low : high).w = w;
        double next = w - value / cubic.slope(w);
        if (!(next >= low.w && next <= high.w && std::abs(next - w) <= 0.5 * last_step))
            next = 0.5 * (low.w + high.w);
        last_step = std::abs(next - w);
        w = next;
        if (last_step <= kRootTolerance)
            break;
    }
    return w;
}

//! The extrema of the cubic in (0, 1), ascending: between them it is monotone.
CubicRoots find_extrema(const PowerCubic& cubic)
{
    CubicRoots extrema;
    const double discriminant = cubic.c2 * cubic.c2 - 3.0 * cubic.c3 * cubic.c1;
    if (!(discriminant > 0.0))
        return extrema;
    const double sum = -(cubic.c2 + std::copysign(std::sqrt(discriminant), cubic.c2));
    double first = sum / (3.0 * cubic.c3);
    double second = cubic.c1 / sum;
    if (first > second)
        std::swap(first, second);
    for (const double w : {first, second})
        if (w > 0.0 && w < 1.0)
            extrema.parameter[extrema.count++] = w;
    return extrema;
}

//! Sign changes of a cubic that may have several: one per monotone piece whose ends differ.
CubicRoots search_monotone_pieces(const BernsteinCubic& coefficients)
{
    const PowerCubic cubic(coefficients);
    CubicRoots ends = find_extrema(cubic);
    CubicRoots roots;
    Sided low{0.0, coefficients[0] >= 0.0};
    for (std::size_t i = 0; i <= ends.count; ++i)
    {
        const bool last = i == ends.count;
        const double w = last ? 1.0 : ends.parameter[i];
        const Sided high{w, (last ? coefficients[3] : cubic.value(w)) >= 0.0};
        if (low.inside != high.inside)
            roots.parameter[roots.count++] = root_in_bracket(cubic, low, high, 0.5 * (low.w + high.w));
        low = high;
    }
    return roots;
}

} // namespace

double trilinear_value(const CellCorners& c, const Vec3& local)
{
    const double y0z0 = lerp(c[0], c[1], local.x);
    const double y1z0 = lerp(c[2], c[3], local.x);
    const double y0z1 = lerp(c[4], c[5], local.x);
    const double y1z1 = lerp(c[6], c[7], local.x);
    return lerp(lerp(y0z0, y1z0, local.y), lerp(y0z1, y1z1, local.y), local.z);
}

BernsteinCubic restrict_to_segment(const CellCorners& c, const Vec3& from, const Vec3& to)
{
    // The values at the corners of the box around the segment, interpolated in the order of
    // trilinear_value(). Lanes: `from` and `to` along x; letters: along y, then z.
    const Pair x{from.x, to.x};
    const Pair y0z0 = lerp(both(c[0]), both(c[1]), x);
    const Pair y1z0 = lerp(both(c[2]), both(c[3]), x);
    const Pair y0z1 = lerp(both(c[4]), both(c[5]), x);
    const Pair y1z1 = lerp(both(c[6]), both(c[7]), x);
    const Pair from_z0 = lerp(y0z0, y1z0, both(from.y));
    const Pair from_z1 = lerp(y0z1, y1z1, both(from.y));
    const Pair to_z0 = lerp(y0z0, y1z0, both(to.y));
    const Pair to_z1 = lerp(y0z1, y1z1, both(to.y));
    const Pair ff = lerp(from_z0, from_z1, both(from.z));
    const Pair ft = lerp(from_z0, from_z1, both(to.z));
    const Pair tf = lerp(to_z0, to_z1, both(from.z));
    const Pair tt = lerp(to_z0, to_z1, both(to.z));

    constexpr double kThird = 1.0 / 3.0;
    return {ff[0], (ff[1] + tf[0] + ft[0]) * kThird, (tf[1] + ft[1] + tt[0]) * kThird, tt[1]};
}

CubicRoots find_sign_changes(const BernsteinCubic& cubic)
{
    const bool from_inside = cubic[0] >= 0.0;
    const bool to_inside = cubic[3] >= 0.0;
    if (from_inside == to_inside)
    {
        if ((cubic[1] >= 0.0) == from_inside && (cubic[2] >= 0.0) == from_inside)
            return {};
        return search_monotone_pieces(cubic);
    }
    if ((cubic[1] >= 0.0) != from_inside && (cubic[2] >= 0.0) == from_inside)
        return search_monotone_pieces(cubic); // three changes among the coefficients: up to three roots

    const double secant = cubic[0] / (cubic[0] - cubic[3]);
    return {1, {root_in_bracket(PowerCubic(cubic), {0.0, from_inside}, {1.0, to_inside}, secant)}};
}

} // namespace voroprobe
