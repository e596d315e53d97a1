#pragma once

#include <cstddef>

#include "mesher/boundary_complex.h"

namespace voroprobe
{

std::size_t separate_contacts(BoundaryComplex& complex);

} // namespace voroprobe
