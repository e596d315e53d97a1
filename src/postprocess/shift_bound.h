#pragma once

#include <array>
#include <cstddef>
#include <set>
#include <vector>

#include "certificate/mesh_distance.h"
#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! How far changes may take a mesh from what it was at first. Asked at vertices and the middles of faces.
class ShiftBound
{
public:
    //! `reach`: scan units, > 0. `original` must outlive it.
    ShiftBound(const TriangleMesh& original, double reach)
        : original_(original), distance_to_original_(original), reach_(reach)
    {
    }

    //! The same for a patch of the mesh as it is now.
    class OfPatch
    {
    public:
        //! Is the patch that takes the other's place within reach of the original, and are those points of
        //! the original within reach of it that were so of the other? Where that was farther, as far will do.
        //! Quick where little has changed since it was asked before. Remembers: one per thread.
        [[nodiscard]] bool holds(const TriangleMesh& patch);

    private:
        friend class ShiftBound;

        //! A point of the original and the face of the patch that was near it when last asked.
        struct PointToReach
        {
            Point3 point;
            std::size_t near_face = 0;
        };

        [[nodiscard]] bool is_near_original(const Point3& p);
        [[nodiscard]] bool is_reached(PointToReach& p, const TriangleMesh& patch) const;

        const MeshDistance* distance_to_original_;
        double reach_from_patch_;
        double reach_from_original_;
        std::vector<PointToReach> points_of_original_;
        std::set<std::array<double, 3>> known_near_; //!< to the original
    };

    //! `share` of the reach, in (0, 1]. Cost: a pass over the original. The bound must outlive what it
    //! returns.
    [[nodiscard]] OfPatch around(const TriangleMesh& patch, double share = 1.0) const;

private:
    const TriangleMesh& original_;
    MeshDistance distance_to_original_;
    double reach_;
};

} // namespace voroprobe
