#pragma once

#include <vector>

#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! A sphere; nested spheres bound shells: a point is inside the object where it lies in an odd number of
//! spheres.
struct Sphere
{
    Point3 center;
    double radius; //!< scan units, > 0
};

//! Non-intersecting, possibly nested spheres in closed form: ground truth for tests and for the paper's
//! figures.
class SphereUnionOracle final : public SurfaceOracle
{
public:
    //! The domain is the bounding box of the spheres grown by `margin` >= 0. \throw UsageError for an empty
    //! list, a radius that is not positive, or spheres that intersect.
    explicit SphereUnionOracle(std::vector<Sphere> spheres, double margin = 1.0);

    [[nodiscard]] Box3 domain() const override { return domain_; }
    [[nodiscard]] Region region(const Point3& p) const override;
    void find_crossings(const Segment3& segment, std::vector<Crossing>& crossings) const override;
    [[nodiscard]] bool may_cross(const Box3& box) const override;

private:
    std::vector<Sphere> spheres_;
    Box3 domain_;
};

} // namespace voroprobe
