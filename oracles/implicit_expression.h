#pragma once

#include <memory>
#include <string>

#include "oracles/implicit_domain.h"
#include "oracles/scalar_field.h"
#include "oracles/surface_oracle.h"
#include "volume/level.h"

namespace voroprobe
{

//! Where a formula in x, y and z has a value, and which side of that is the object.
struct ExpressionSurface
{
    std::string formula; //!< see parse_expression()
    double isovalue = 0.0;
    InsideIs inside = InsideIs::kBelow; //!< as x^2 + y^2 + z^2 - 1 wants it
};

//! The level set of a formula. What lies between two points, or in a box, is settled by interval arithmetic
//! on the formula and its derivative along the segment: nothing is missed, and empty space is certified
//! empty, without a bound from the user. A point where the formula is NaN throws UsageError that names it.
std::shared_ptr<const ScalarField> make_expression_field(const ExpressionSurface& surface);

//! The oracle of that field, closed by the border of the domain. Segments are divided down to a billionth of
//! the domain's diagonal where the intervals settle nothing: at tangencies and jumps. \throw UsageError where
//! the formula does not parse, names the character; where it is NaN at a node of a lattice over the domain,
//! names the node. Points that are NaN between the nodes throw when they are met.
std::unique_ptr<SurfaceOracle> make_expression_oracle(const ExpressionSurface& surface,
                                                      const ImplicitDomain& domain);

} // namespace voroprobe
