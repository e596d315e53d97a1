#include "volume/grid_geometry.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "support/error.h"

namespace voroprobe
{

namespace
{

//! How far from orthonormal direction cosines may be: headers store them as floats or with few decimals.
constexpr double kOrthonormalityTolerance = 1e-3;

//! Sums of direction cosines closer than this are a tie, so that rounding never decides the order of the axes
//! (an image turned by 45 degrees has two equally good orders).
constexpr double kTieTolerance = 1e-6;

Matrix3 reorder(const Matrix3& direction, const AxisOrder& order)
{
    Matrix3 result;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const Vec3& column = direction.column[order.stored_axis[axis]];
        result.column[axis] = order.reversed[axis] ? -column : column;
    }
    return result;
}

double trace(const Matrix3& m)
{
    return m.column[0].x + m.column[1].y + m.column[2].z;
}

//! Whether `a` is the better canonical matrix: nearer to the identity, and among equals the first one in a
//! fixed order of matrices, which does not depend on how the file stored the axes.
bool is_preferred(const Matrix3& a, const Matrix3& b)
{
    const double nearer = trace(a) - trace(b);
    if (std::abs(nearer) > kTieTolerance)
        return nearer > 0.0;
    for (std::size_t column = 0; column < 3; ++column)
        for (std::size_t row = 0; row < 3; ++row)
            if (const double larger = a.column[column][row] - b.column[column][row];
                std::abs(larger) > kTieTolerance)
                return larger > 0.0;
    return false;
}

void require_positive_sizes(const StoredLattice& lattice)
{
    for (const std::size_t size : lattice.size)
        if (size == 0)
            throw InputError("size " + std::to_string(lattice.size[0]) + " x " +
                             std::to_string(lattice.size[1]) + " x " + std::to_string(lattice.size[2]) +
                             " holds no sample, expected at least 1 x 1 x 1");
}

void require_positive_spacing(const Vec3& spacing)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (!std::isfinite(spacing[axis]) || spacing[axis] <= 0.0)
            throw InputError("spacing " + std::to_string(spacing[axis]) + " along axis " +
                             std::to_string(axis) + ", expected a positive, finite number");
}

void require_orthonormal(const Matrix3& direction)
{
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = a; b < 3; ++b)
        {
            const double found = dot(direction.column[a], direction.column[b]);
            const double expected = a == b ? 1.0 : 0.0;
            if (!(std::abs(found - expected) <= kOrthonormalityTolerance)) // also refuses NaN
                throw InputError("direction cosines are not orthonormal: axes " + std::to_string(a) +
                                 " and " + std::to_string(b) + " have the product " + std::to_string(found) +
                                 ", expected " + std::to_string(expected));
        }
}

//! Gram-Schmidt on the first two columns; the third is their cross product, so that the determinant is +1.
Matrix3 make_rotation(const Matrix3& nearly)
{
    const Vec3 x = normalized(nearly.column[0]);
    const Vec3 y = normalized(nearly.column[1] - dot(nearly.column[1], x) * x);
    return {{x, y, cross(x, y)}};
}

} // namespace

AxisOrder canonical_axis_order(const Matrix3& direction)
{
    AxisOrder best;
    Matrix3 best_matrix;
    bool found = false;
    AxisOrder order;
    do
    {
        for (unsigned flips = 0; flips < 8; ++flips)
        {
            order.reversed = {(flips & 1U) != 0, (flips & 2U) != 0, (flips & 4U) != 0};
            const Matrix3 matrix = reorder(direction, order);
            if (determinant(matrix) <= 0.0 || (found && !is_preferred(matrix, best_matrix)))
                continue;
            best = order;
            best_matrix = matrix;
            found = true;
        }
    } while (std::next_permutation(order.stored_axis.begin(), order.stored_axis.end()));
    return best;
}

GridGeometry make_grid_geometry(const StoredLattice& lattice, const AxisOrder& order)
{
    require_positive_sizes(lattice);
    require_positive_spacing(lattice.spacing);
    require_orthonormal(lattice.direction);
    if (!is_finite(lattice.origin))
        throw InputError("the origin is not finite");

    GridGeometry geometry;
    geometry.world_from_grid = {make_rotation(reorder(lattice.direction, order)), lattice.origin};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const std::size_t stored = order.stored_axis[axis];
        const double sign = order.reversed[axis] ? -1.0 : 1.0;
        geometry.size[axis] = lattice.size[stored];
        geometry.spacing[axis] = lattice.spacing[stored];

        // The first canonical sample along this axis, in the file's index coordinates.
        const std::size_t steps = order.reversed[axis] ? lattice.size[stored] - 1 : 0;
        const double first_index = static_cast<double>(lattice.start[stored]) + static_cast<double>(steps);
        geometry.world_from_grid.translation +=
            sign * first_index * lattice.spacing[stored] * geometry.world_from_grid.linear.column[axis];

        Vec3 source_step{0, 0, 0};
        source_step[stored] = sign / lattice.spacing[stored];
        geometry.source_index_from_grid.linear.column[axis] = source_step;
        geometry.source_index_from_grid.translation[stored] = first_index;
    }
    return geometry;
}

} // namespace voroprobe
