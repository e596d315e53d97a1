#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/box3.h"
#include "volume/height_field.h"
#include "volume/region.h"
#include "volume/region_runs.h"

namespace voroprobe
{

//! One closed surface of a scan.
struct ScanSurface
{
    Region inside;                //!< the region on its inner side
    Region outside;               //!< the region on its outer side
    SurfaceId parent;             //!< the surface next around it; kNoSurface where there is none
    bool cavity;                  //!< it bounds a hole: what it encloses next to it is outside the object
    Box3 box;                     //!< of its crossings with grid edges, and of its caps on the border
    std::size_t enclosed_samples; //!< samples it encloses, nested regions included: its voxel volume
    Point3 point;             //!< one of its crossings with a grid edge, or of its caps where there is none
    bool touches_border;      //!< it is closed by caps on the border of the volume
    int euler_characteristic; //!< of the surface itself, caps included: 2 - 2 genus
};

//! The exact list of the closed surfaces {interpolant = isovalue} of a scan, and the regions they separate.
//!
//! The regions of {height >= 0} and of {height < 0}, with the interpolant's own connectivity, and the outside
//! padded into one of them, form a tree by adjacency; each edge of it is one closed surface: surfaces =
//! inside regions + outside regions - 1. Every bounded region holds a sample, so that nothing is invisible.
//! Source: van Kreveld et al. 1997; Nielson, On Marching Cubes, 2003 (face and body saddles); Carr, Snoeyink
//! & Axen, Computing contour trees in all dimensions, 2003.
//!
//! Frame: that of the height field. Immutable: may be asked from several threads at once.
class Inventory
{
public:
    //! Cost: linear in the samples, plus near-linear in the runs. Memory: that of RegionRuns, and about 100
    //! bytes per surface. `threads`: 0 for all there are; the result is the same for any. \throw InputError
    //! as RegionRuns.
    explicit Inventory(const HeightField& field, std::size_t threads = 0);

    //! Ordered by the first sample (k, j, i) they enclose; a surface comes after its parent.
    [[nodiscard]] const std::vector<ScanSurface>& surfaces() const { return surfaces_; }

    [[nodiscard]] std::size_t inside_region_count() const { return around_inside_.size() - 1; }
    [[nodiscard]] std::size_t outside_region_count() const { return around_outside_.size() - 1; }

    //! The region of sample (i, j, k); kOuterRegion beyond the border. Cost: O(log runs of the row).
    [[nodiscard]] Region region(int i, int j, int k) const { return runs_.region(i, j, k); }

    //! The regions of all samples.
    [[nodiscard]] const RegionRuns& runs() const { return runs_; }

    //! The surface that separates two regions; kNoSurface where they are no neighbours. Cost: O(1).
    [[nodiscard]] SurfaceId surface_between(Region a, Region b) const;

    //! The surface that bounds a region from outside: the one towards the root of the tree; kNoSurface for
    //! the outer region.
    [[nodiscard]] SurfaceId surface_around(Region region) const
    {
        return is_inside(region) ? around_inside_[static_cast<std::size_t>(region)]
                                 : around_outside_[static_cast<std::size_t>(-region)];
    }

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    void build_tree();
    void add_surface(Region region, Region around);
    void count_enclosed_samples();
    void measure_surfaces(const HeightField& field, std::size_t threads);

    RegionRuns runs_;
    std::vector<ScanSurface> surfaces_;
    std::vector<SurfaceId> around_inside_;  //!< of region id: surface_around
    std::vector<SurfaceId> around_outside_; //!< of region -id
};

//! For each of the surfaces asked for, up to `most` of its crossings with grid edges, spread over it; samples
//! on its caps count as crossings. Cost: one pass over the samples of their boxes.
std::vector<std::vector<Point3>> grid_crossings(const HeightField& field, const Inventory& inventory,
                                                std::span<const SurfaceId> surfaces, std::size_t most);

} // namespace voroprobe
