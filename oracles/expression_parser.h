#pragma once

#include <string>

#include "oracles/expression_tape.h"

namespace voroprobe
{

//! Reads a formula in x, y and z, as muParser knows them: + - * / ^ ( ), comparisons, && ||, "a ? b : c", the
//! constants pi and e, the functions of unary_functions(), atan2(y, x), and min and max of any number of
//! arguments. \throw UsageError that quotes the formula and tells what is wrong and at which character.
ExpressionTape parse_expression(const std::string& formula);

} // namespace voroprobe
