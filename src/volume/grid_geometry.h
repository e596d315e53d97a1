#pragma once

#include <array>
#include <cstddef>

#include "geometry/affine_transform.h"
#include "geometry/box3.h"

namespace voroprobe
{

//! Where the samples of a file say they are: ITK's convention. p_world = origin + direction * (spacing .*
//! index), the index of the first stored sample being `start`. Axis 0 varies fastest in memory.
struct StoredLattice
{
    std::array<std::size_t, 3> size; //!< samples along each axis, > 0
    Vec3 spacing{1, 1, 1};           //!< scan units, > 0
    Matrix3 direction{};             //!< direction cosines by columns, orthonormal, either handedness
    Point3 origin{};                 //!< world (LPS, mm) position of index (0, 0, 0)
    std::array<std::ptrdiff_t, 3> start{0, 0, 0}; //!< index of the first stored sample
};

//! The grid a Volume is sampled on, described in one canonical way, and the only place that knows axis order.
//!
//! Frames:
//! - *index*: sample (i, j, k) of the canonical array is at (i, j, k);
//! - *grid*: `spacing .* index`; scan units, axes along the lattice, first sample at the origin. The mesher
//! works here;
//! - *world*: ITK's LPS, mm. Rigid and orientation-preserving with respect to the grid frame, so that
//! distances, angles and
//!   windings carry over;
//! - *source index*: the index coordinates of the file, which may be permuted, flipped (left-handed) and
//! offset.
//!
//! The axes are those of the file permuted and reversed so that the grid frame lies as near to the world
//! frame as it can and is right-handed. Files that store the same lattice in different orders therefore give
//! the same canonical array.
struct GridGeometry
{
    std::array<std::size_t, 3> size{};      //!< samples along each axis
    Vec3 spacing{1, 1, 1};                  //!< scan units, > 0
    AffineTransform world_from_grid;        //!< rotation (determinant +1) and translation
    AffineTransform source_index_from_grid; //!< to the file's own index coordinates; may reverse orientation

    [[nodiscard]] std::size_t sample_count() const { return size[0] * size[1] * size[2]; }

    //! The box of the samples in the grid frame: from the origin to the last sample.
    [[nodiscard]] Box3 grid_box() const
    {
        return {{0, 0, 0},
                {spacing.x * static_cast<double>(size[0] - 1), spacing.y * static_cast<double>(size[1] - 1),
                 spacing.z * static_cast<double>(size[2] - 1)}};
    }

    //! The shortest side of a voxel, scan units: the unit of all default lengths.
    [[nodiscard]] double min_spacing() const { return std::min({spacing.x, spacing.y, spacing.z}); }
};

//! How the canonical array is taken from the stored one: canonical axis a runs along stored axis
//! `stored_axis[a]`, backwards where `reversed[a]`.
struct AxisOrder
{
    std::array<std::size_t, 3> stored_axis{0, 1, 2};
    std::array<bool, 3> reversed{false, false, false};

    [[nodiscard]] bool is_identity() const
    {
        return stored_axis == std::array<std::size_t, 3>{0, 1, 2} && reversed == std::array<bool, 3>{};
    }
};

//! The permutation and reversal of the axes after which the direction cosines are nearest to the identity and
//! right-handed.
AxisOrder canonical_axis_order(const Matrix3& direction);

//! The grid of a lattice whose axes were put in `order`. \throw InputError where a size is 0, a spacing is
//! not positive and finite, or the direction cosines are not orthonormal (to 1e-3; they are then made exactly
//! so by Gram-Schmidt).
GridGeometry make_grid_geometry(const StoredLattice& lattice, const AxisOrder& order);

} // namespace voroprobe
