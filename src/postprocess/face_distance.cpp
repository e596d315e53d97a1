#include "postprocess/face_distance.h"

#include <limits>
#include <utility>

#include "certificate/nearest_crossing.h"
#include "mesh/circumcircle.h"

namespace voroprobe
{

namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();

} // namespace

FaceDistance face_distance_to(std::shared_ptr<const MeshDistance> mesh)
{
    return [mesh = std::move(mesh)](const Point3& a, const Point3& b, const Point3& c)
    {
        const auto circle = circumcircle(a, b, c);
        return circle ? (*mesh)(circle->center) : kInfinity;
    };
}

FaceDistance face_distance_to(const SurfaceOracle& oracle, double reach)
{
    return
        [search = NearestCrossing(oracle), reach](const Point3& a, const Point3& b, const Point3& c) mutable
    {
        const auto circle = circumcircle(a, b, c);
        const auto found = circle ? search.along(circle->center, circle->normal, reach) : std::nullopt;
        return found ? found->distance : kInfinity;
    };
}

} // namespace voroprobe
