#pragma once

#include <functional>

#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! The zero set of a function, closed by the domain. Inside: value >= 0 (a sphere of radius r: r^2 - x^2 -
//! y^2 - z^2).
class ImplicitOracle final : public SurfaceOracle
{
public:
    using Function = std::function<double(const Point3&)>;

    //! `function` must be pure and thread-safe. `lipschitz_bound` > 0: |f(a) - f(b)| <= bound * |a - b| in
    //! the domain; it makes the search for crossings complete down to `resolution` > 0, the length below
    //! which two crossings may be taken for none. \throw UsageError where an argument is outside its range or
    //! the domain is empty.
    ImplicitOracle(Function function, const Box3& domain, double lipschitz_bound, double resolution);

    [[nodiscard]] Box3 domain() const override { return domain_; }
    [[nodiscard]] Region region(const Point3& p) const override;
    void find_crossings(const Segment3& segment, std::vector<Crossing>& crossings) const override;
    [[nodiscard]] bool may_cross(const Box3& box) const override;

private:
    Function function_;
    Box3 domain_;
    double lipschitz_bound_;
    double resolution_;
};

} // namespace voroprobe
