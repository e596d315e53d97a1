#pragma once

#include <filesystem>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "io/float_rounding.h"
#include "mesh/mesh_part.h"

namespace voroprobe
{

//! lib3mf multiplies floats by a million and drops what is behind the point. Numbers as far apart as these
//! stay apart.
inline constexpr StoredNumbers kNumbersOf3mf{.binary_digits = 22, .step = 0x1p-18};

//! Writes the 3MF package of a print job: one object for each part, with its name and colour, in millimetres,
//! and one item on the plate for each. Comments are its description. Coordinates are to be kNumbersOf3mf. The
//! package is read back and compared before it is written. Holds it in memory. The same parts give the same
//! bytes. \throw OutputError with lib3mf's reason, or where the package does not hold what it should;
//! whatever the stream throws.
void write_3mf(std::span<const MeshPart> parts, std::ostream& out, const std::vector<std::string>& comments);

//! The objects on the plate, each where its item puts it, converted to millimetres; an object of components
//! is one part. \throw InputError with lib3mf's reason.
std::vector<MeshPart> read_3mf(const std::filesystem::path& path);

//! The same of a package in memory; `path` is what messages call it.
std::vector<MeshPart> parse_3mf(std::string& package, const std::filesystem::path& path);

} // namespace voroprobe
