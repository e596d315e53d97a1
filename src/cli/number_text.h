#pragma once

#include <cstddef>
#include <string>

#include "geometry/vec3.h"
#include "support/number_text.h"

namespace voroprobe
{

//! Three numbers with a word between: "3.2 x 3.2 x 1.5".
std::string triple_text(const Vec3& values, const std::string& separator = " x ");

//! "1 face", "3 faces", "1,234 vertices".
std::string plural_text(std::size_t count, const std::string& one, const std::string& many);

//! The same where the plural ends in s alone.
std::string plural_text(std::size_t count, const std::string& one);

//! A share of 1 as a percentage with three significant digits: "37.2 %".
std::string percent_text(double share);

//! Seconds with two decimals and the unit: "1.25 s".
std::string seconds_text(double seconds);

//! Bytes in the largest unit that leaves at least one whole: "118 MB" (powers of 1000).
std::string bytes_text(std::size_t bytes);

} // namespace voroprobe
