#include "oracles/implicit_expression.h"

#include <cmath>

#include "oracles/expression_parser.h"
#include "oracles/implicit_oracle.h"
#include "support/error.h"
#include "support/number_text.h"

namespace voroprobe
{
namespace
{

//! Shortest piece a segment is divided into, as a fraction of the domain's diagonal.
constexpr double kResolution = 1e-9;

//! Steps along each side of the domain where a formula that may be NaN is tried before the work begins:
//! 36,000 points, a matter of milliseconds.
constexpr int kTrialSteps = 32;

class ExpressionField final : public ScalarField
{
public:
    explicit ExpressionField(const ExpressionSurface& surface)
        : formula_(surface.formula), tape_(parse_expression(surface.formula)), isovalue_(surface.isovalue),
          inside_(surface.inside)
    {
        if (!std::isfinite(isovalue_))
            throw UsageError("the isovalue of a formula is " + number_text(isovalue_) +
                             "; it must be a finite number");
    }

    [[nodiscard]] double value(const Point3& p) const override
    {
        const double f = tape_.value(p);
        if (std::isnan(f))
            throw UsageError("the formula '" + formula_ + "' is not a number at (" + number_text(p.x) + ", " +
                             number_text(p.y) + ", " + number_text(p.z) +
                             "); it must be defined all over the domain");
        return inside_ == InsideIs::kAbove ? f - isovalue_ : isovalue_ - f;
    }

    [[nodiscard]] bool ends_tell_all(const Segment3& segment, const EndValues& /*values*/) const override
    {
        const IntervalSlope along = tape_.along(segment);
        if (!along.value.is_bounded())
            return false;
        return !along.value.contains(isovalue_) || along.slope.keeps_sign();
    }

    [[nodiscard]] BoxSide side_of(const Box3& box) const override
    {
        const Interval values = tape_.over(box);
        if (!values.is_bounded() || values.contains(isovalue_))
            return BoxSide::kUnknown;
        return (values.low > isovalue_) == (inside_ == InsideIs::kAbove) ? BoxSide::kInside
                                                                         : BoxSide::kOutside;
    }

    //! Throws where the formula is NaN at a node of a lattice over the domain. Nothing to try where interval
    //! arithmetic says that it is defined everywhere.
    void try_out(const ImplicitDomain& domain) const
    {
        const Box3& box = domain.bounding_box();
        if (tape_.over(box).is_bounded())
            return;
        const Vec3 step = box.extent() / kTrialSteps;
        for (int k = 0; k <= kTrialSteps; ++k)
            for (int j = 0; j <= kTrialSteps; ++j)
                for (int i = 0; i <= kTrialSteps; ++i)
                    if (const Point3 p = box.min + Vec3{i * step.x, j * step.y, k * step.z};
                        domain.contains(p))
                        static_cast<void>(value(p));
    }

private:
    std::string formula_;
    ExpressionTape tape_;
    double isovalue_;
    InsideIs inside_;
};

} // namespace

std::shared_ptr<const ScalarField> make_expression_field(const ExpressionSurface& surface)
{
    return std::make_shared<ExpressionField>(surface);
}

std::unique_ptr<SurfaceOracle> make_expression_oracle(const ExpressionSurface& surface,
                                                      const ImplicitDomain& domain)
{
    auto field = std::make_shared<ExpressionField>(surface);
    field->try_out(domain);
    const double resolution = kResolution * domain.bounding_box().diagonal();
    return std::make_unique<ImplicitOracle>(std::move(field), domain, resolution);
}

} // namespace voroprobe
