#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mesher/cell_table.h"
#include "mesher/handle_repair.h"
#include "mesher/region_repair.h"
#include "mesher/relabelling.h"
#include "mesher/restricted_delaunay.h"
#include "mesher/seeded_mesher.h"

namespace voroprobe
{

//! The regions of the Delaunay cells where refinement has ended: settled by labels alone (repair_regions(),
//! relabel_pinched_cells(), repair_handles()), and given up again for more refinement.
class RegionSettlement
{
public:
    //! All must outlive the object.
    RegionSettlement(RestrictedDelaunay& restricted, const MeshingOptions& options, const Workers& workers)
        : restricted_(restricted), options_(options), workers_(workers)
    {
    }

    //! See voroprobe::find_gaps(): in the regions as refinement has left them. What settle() did is
    //! forgotten.
    std::vector<Point3> find_gaps();

    //! Makes the regions what the oracle's inventory says they are. `handles`: the number of handles of every
    //! surface too, where the Delaunay cells are small; pointless in a mesh that is not finished. What was
    //! settled before stays, but for cells that are gone. Cost: O(Delaunay cells).
    void settle(bool handles);

    //! Puts right what handles are still wrong with facets as long as facets of the mesh may be, and at
    //! single cells out of place; then angles, where the repair has spoilt them. The last thing to be done.
    //! After settle().
    void finish();

    //! Gives all cells the regions that they had before settle(): refinement may go on.
    void unsettle();

    //! Necks of the scan that want vertices beside them for the number of handles to come right: those where
    //! smaller Delaunay cells would do, a few for each handle; and of surfaces with few on the wrong side all
    //! of these. After settle().
    [[nodiscard]] std::vector<Neck> necks_to_refine() const;

    //! Vertices of the mesh, at least once for each surface that they are on, as settle() found them where it
    //! was to look at handles.
    [[nodiscard]] const std::vector<SurfacePoint>& vertices_on_surfaces() const
    {
        return vertices_on_surfaces_;
    }

    //! Surfaces of the inventory that none of these vertices is on; none where settle() was not to look at
    //! handles.
    [[nodiscard]] std::vector<SurfaceId> surfaces_without_vertices() const;

    //! Takes back what was done for handles at any of the vertices, and joins regions that fall apart
    //! thereby; false where there was nothing.
    bool undo_handles_at(std::span<const VertexHandle> vertices);

    //! Gives up the inside around the vertices: the surface no longer passes there.
    void carve(std::span<const VertexHandle> vertices);

    //! All cells with their regions as they are now. After settle().
    [[nodiscard]] const CellTable& table() const { return *table_; }

    //! Says what settle() and finish() did.
    void count(MeshingStatistics& statistics) const;

    //! Pieces of regions that settle() could not join to the rest.
    [[nodiscard]] std::size_t pieces_left_apart() const { return report_.pieces_left_apart; }

private:
    void take_in_new_cells();
    void forget_umbrellas_at_changes();
    void forget();
    void settle_regions();
    void repair();
    std::vector<VertexHandle> vertices_to_look_at();
    void undo_broken_changes();
    void settle_handles();
    void put_right(double longest_side);
    void add_where_few(const std::vector<Neck>& others, std::vector<Neck>& necks) const;
    void add(std::vector<HandleChange> changes);
    void improve_angles();
    [[nodiscard]] bool lacks_any() const;

    RestrictedDelaunay& restricted_;
    const MeshingOptions& options_;
    const Workers& workers_;
    std::optional<CellTable> table_;           //!< from the first look at all cells on
    bool is_settled_ = false;                  //!< but for new cells
    std::vector<CellTable::Number> new_cells_; //!< since the regions were settled
    RegionRepairMemory regions_;
    HandleMemory handles_;
    std::vector<SurfacePoint> vertices_on_surfaces_;
    std::vector<long> lacking_; //!< see lacking_euler(); empty where it was not asked for
    std::vector<HandleChange> handle_changes_;
    std::size_t changes_before_angles_ = 0; //!< of the table
    std::vector<CoarseNeck> coarse_necks_;
    std::vector<Neck> other_missed_necks_;
    RegionRepairReport report_;
    std::size_t cells_relabelled_ = 0;
    std::size_t cells_relabelled_for_angles_ = 0;
};

} // namespace voroprobe
