#pragma once

#include <span>

#include "oracles/expression_tape.h"

namespace voroprobe
{

//! The functions of one variable that formulas may name. log is the natural logarithm, as ln.
std::span<const UnaryFunction> unary_functions();

} // namespace voroprobe
