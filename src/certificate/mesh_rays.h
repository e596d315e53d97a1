#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Where a ray meets a mesh. May be asked from several threads at once. Holds a copy of the corners.
class MeshRays
{
public:
    struct Hit
    {
        double distance; //!< from the origin of the ray
        Point3 point;
        Vec3 normal; //!< of the face that is met, unit
    };

    //! Cost: O(n log n). \throw UsageError where the mesh has no face with area.
    explicit MeshRays(const TriangleMesh& mesh);
    ~MeshRays();
    MeshRays(const MeshRays&) = delete;
    MeshRays& operator=(const MeshRays&) = delete;

    //! The first face that a ray meets beyond `beyond` (scan units) of its origin; nullopt where it meets
    //! none. Numbers are rounded: a ray through an edge may pass. \pre `direction` is a unit vector. Cost:
    //! O(log n).
    [[nodiscard]] std::optional<Hit> first_hit(const Point3& origin, const Vec3& direction,
                                               double beyond) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

} // namespace voroprobe
