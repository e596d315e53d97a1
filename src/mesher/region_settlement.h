#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

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
    //! Both must outlive the object.
    RegionSettlement(RestrictedDelaunay& restricted, const MeshingOptions& options)
        : restricted_(restricted), options_(options)
    {
    }

    //! Makes the regions what the oracle's inventory says they are. `handles`: the number of handles of every
    //! surface too, where the Delaunay cells are small; pointless in a mesh that is not finished. Cost:
    //! O(Delaunay cells).
    void settle(bool handles);

    //! Puts right what handles are still wrong with facets as long as facets of the mesh may be, and at
    //! single cells out of place; then angles, where the repair has spoilt them. The last thing to be done.
    //! After settle().
    void finish();

    //! Gives all cells what they knew before settle(), and extract_surface(): refinement may go on.
    void unsettle();

    //! Necks of the scan that want vertices beside them for the number of handles to come right: those where
    //! smaller Delaunay cells would do, a few for each handle; and of surfaces with few on the wrong side all
    //! of these. After settle().
    [[nodiscard]] std::vector<Neck> necks_to_refine() const;

    //! Takes back what was done for handles at any of the vertices; false where there was nothing.
    bool undo_handles_at(std::span<const VertexHandle> vertices);

    //! Says what settle() did the last time.
    void count(MeshingStatistics& statistics) const;

    //! Pieces of regions that settle() could not join to the rest.
    [[nodiscard]] std::size_t pieces_left_apart() const { return report_.pieces_left_apart; }

private:
    //! What settle() and extract_surface() change of a Delaunay cell.
    struct FormerCell
    {
        Region region;
        std::array<FacetId, 4> facet;
    };

    void remember_cells();
    void settle_regions();
    void repair(CellTable& table);
    void settle_handles();
    void put_right(double longest_side);
    void add_where_few(const std::vector<Neck>& others, std::vector<Neck>& necks) const;
    void add(std::vector<HandleChange> changes);
    void improve_angles();
    void undo_side_changes();
    [[nodiscard]] bool lacks_any() const;

    RestrictedDelaunay& restricted_;
    const MeshingOptions& options_;
    std::vector<FormerCell> former_cells_; //!< all, in the order of the triangulation
    std::optional<std::vector<Neck>> necks_;
    std::vector<long> lacking_; //!< see lacking_euler(); empty where it was not asked for
    std::vector<HandleChange> handle_changes_;
    std::vector<SideChange> side_changes_; //!< after all changes for handles
    std::vector<CoarseNeck> coarse_necks_;
    std::vector<Neck> other_missed_necks_;
    RegionRepairReport report_;
    std::size_t cells_relabelled_ = 0;
};

} // namespace voroprobe
