#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "geometry/box3.h"
#include "postprocess/editable_mesh.h"

namespace voroprobe
{

//! Finds the faces of a mesh near a place, while the mesh changes.
class FaceGrid
{
public:
    //! `cell_size`: scan units, > 0; about an edge or two. `mesh` must outlive the grid.
    FaceGrid(const EditableMesh& mesh, double cell_size);

    //! Takes note of the faces that were added since the last time. To be called after every change;
    //! faces whose corners were moved without being replaced are not found where they are now.
    void update();

    //! Faces whose boxes overlap a box, ascending.
    [[nodiscard]] std::vector<std::uint32_t> faces_near(const Box3& box) const;

private:
    using Cell = std::array<std::int64_t, 3>;

    struct Hash
    {
        std::size_t operator()(const Cell& cell) const;
    };

    [[nodiscard]] Box3 box_of(std::uint32_t face) const;
    [[nodiscard]] Cell cell_of(const Point3& p) const;

    //! false, and no visit, where there are more than it is worth.
    template <typename Visit>
    bool for_cells(const Box3& box, Visit visit) const;

    const EditableMesh& mesh_;
    double cell_size_;
    std::uint32_t known_ = 0;          //!< faces below this number are in the cells
    std::vector<std::uint32_t> large_; //!< faces over too many cells
    std::unordered_map<Cell, std::vector<std::uint32_t>, Hash> cells_;
};

} // namespace voroprobe
