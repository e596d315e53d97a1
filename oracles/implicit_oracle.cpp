#include "oracles/implicit_oracle.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "oracles/crossing_search.h"
#include "support/error.h"
#include "support/number_text.h"

namespace voroprobe
{
namespace
{

//! Length of the bracket that ends the refinement of a crossing, as a fraction of the domain's diagonal: near
//! the rounding of coordinates.
constexpr double kRootTolerance = 1e-12;

//! All that is known beside the values is how fast they may change.
class LipschitzField final : public ScalarField
{
public:
    LipschitzField(ImplicitOracle::Function function, double bound)
        : function_(std::move(function)), bound_(bound)
    {
        if (!function_)
            throw UsageError("implicit oracle: no function");
        if (!(bound > 0.0) || !std::isfinite(bound))
            throw UsageError("implicit oracle: Lipschitz bound " + number_text(bound) +
                             ", expected a positive number");
    }

    [[nodiscard]] double value(const Point3& p) const override { return function_(p); }

    //! To reach zero and come back, the function would have to change by the sum of both values.
    [[nodiscard]] bool ends_tell_all(const Segment3& segment, const EndValues& values) const override
    {
        return (values.source >= 0.0) == (values.target >= 0.0) &&
               std::abs(values.source) + std::abs(values.target) >
                   bound_ * distance(segment.source, segment.target);
    }

    [[nodiscard]] BoxSide side_of(const Box3& box) const override
    {
        const double at_center = function_(box.center());
        if (!(std::abs(at_center) > 0.5 * bound_ * box.diagonal()))
            return BoxSide::kUnknown;
        return at_center > 0.0 ? BoxSide::kInside : BoxSide::kOutside;
    }

private:
    ImplicitOracle::Function function_;
    double bound_;
};

} // namespace

ImplicitOracle::ImplicitOracle(Function function, const Box3& domain, double lipschitz_bound,
                               double resolution)
    : ImplicitOracle(std::make_shared<LipschitzField>(std::move(function), lipschitz_bound),
                     ImplicitDomain(domain), resolution)
{
}

ImplicitOracle::ImplicitOracle(std::shared_ptr<const ScalarField> field, const ImplicitDomain& domain,
                               double resolution)
    : field_(std::move(field)), domain_(domain), resolution_(resolution)
{
    if (!field_)
        throw UsageError("implicit oracle: no field");
    if (!(resolution > 0.0) || !std::isfinite(resolution))
        throw UsageError("implicit oracle: resolution " + number_text(resolution) +
                         ", expected a positive number");
}

Region ImplicitOracle::region(const Point3& p) const
{
    return domain_.contains(p) && field_->value(p) >= 0.0 ? Region{1} : kOuterRegion;
}

void ImplicitOracle::find_crossings(const Segment3& segment, std::vector<Crossing>& crossings) const
{
    crossings.clear();
    if (segment.source == segment.target || !is_finite(segment.source) || !is_finite(segment.target))
        return;
    const auto range = domain_.clip(segment);
    if (!range)
        return;

    const double root_tolerance = kRootTolerance * domain_.bounding_box().diagonal();
    CrossingSearch search(*field_, segment, {resolution_, root_tolerance}, crossings);
    const auto first = search.probe(range->first);
    const auto last = search.probe(range->second);
    if (first.inside && !domain_.contains(segment.source))
        search.append(first.t, true);
    search.search(first, last);
    if (last.inside && !domain_.contains(segment.target))
        search.append(last.t, true);
}

bool ImplicitOracle::may_cross(const Box3& box) const
{
    const Box3 part = intersection(box, domain_.bounding_box());
    if (part.empty())
        return false;
    switch (field_->side_of(part))
    {
    case ScalarField::BoxSide::kOutside:
        return false;
    case ScalarField::BoxSide::kInside:
        return !domain_.holds_within(part); // an object that touches the domain's border has its cap there
    case ScalarField::BoxSide::kUnknown:
        break;
    }
    return true;
}

} // namespace voroprobe
