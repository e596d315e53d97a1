#include "postprocess/surface_projection.h"

#include <cmath>
#include <utility>
#include <vector>

namespace voroprobe
{

SurfaceProjection projection_onto(std::shared_ptr<const MeshDistance> mesh)
{
    return [mesh = std::move(mesh)](const Point3& p) { return mesh->nearest(p); };
}

SurfaceProjection projection_onto(const SurfaceOracle& oracle, std::shared_ptr<const MeshDistance> mesh,
                                  double reach)
{
    return [&oracle, mesh = std::move(mesh), reach,
            crossings = std::vector<Crossing>()](const Point3& p) mutable -> std::optional<NearestPoint>
    {
        const NearestPoint near = mesh->nearest(p);
        oracle.find_crossings({p - reach * near.normal, p + reach * near.normal}, crossings);
        std::optional<NearestPoint> result;
        for (const Crossing& crossing : crossings)
            if (!result || squared_distance(p, crossing.point) < squared_distance(p, result->point))
                result = NearestPoint{crossing.point, near.normal};
        return result;
    };
}

} // namespace voroprobe
