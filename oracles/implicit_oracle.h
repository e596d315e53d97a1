#pragma once

#include <functional>
#include <memory>

#include "oracles/implicit_domain.h"
#include "oracles/scalar_field.h"
#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! The zero set of a function, closed by the border of the domain. Inside: value >= 0 (a sphere of radius r:
//! r^2 - x^2 - y^2 - z^2).
class ImplicitOracle final : public SurfaceOracle
{
public:
    using Function = std::function<double(const Point3&)>;

    //! `function` must be pure and thread-safe; where it is NaN is outside. `lipschitz_bound` > 0: |f(a) -
    //! f(b)| <= bound * |a - b| in the domain; it makes the search for crossings complete down to
    //! `resolution` > 0, the length below which two crossings may be taken for none. \throw UsageError where
    //! an argument is outside its range or the domain is empty.
    ImplicitOracle(Function function, const Box3& domain, double lipschitz_bound, double resolution);

    //! The same for a field that knows more of itself. Two crossings nearer than `resolution` > 0, scan
    //! units, may be taken for none where the field does not settle what lies between. \throw UsageError
    ImplicitOracle(std::shared_ptr<const ScalarField> field, const ImplicitDomain& domain, double resolution);

    [[nodiscard]] Box3 domain() const override { return domain_.bounding_box(); }
    [[nodiscard]] Region region(const Point3& p) const override;
    void find_crossings(const Segment3& segment, std::vector<Crossing>& crossings) const override;
    [[nodiscard]] bool may_cross(const Box3& box) const override;

private:
    std::shared_ptr<const ScalarField> field_;
    ImplicitDomain domain_;
    double resolution_;
};

} // namespace voroprobe
