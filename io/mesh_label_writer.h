#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "io/mesh_writer.h"
#include "mesh/mesh_part.h"

namespace voroprobe
{

//! Whether a format keeps labels apart in one file: 3MF as objects, OBJ as groups, PLY as a number per face.
bool holds_labels(MeshFormat format);

//! Writes the meshes of several labels to one file, in their order:
//!
//! - 3MF: an object for each, with name and colour;
//! - OBJ: `g label_7 NAME` (blanks in it replaced) before its vertices and faces, colours behind the
//! coordinates of the vertices;
//! - PLY, binary: faces have `int label` and `uchar red green blue` (grey where there is none); a comment
//! line
//!   `label 7 NAME` for each.
//!
//! Coordinates of OBJ and PLY are 32-bit floats; meshes are rounded each for itself. `labels`: one for each
//! part. `last_look`: as write_mesh. \pre holds_labels(format). \throw OutputError with the reason.
WriteReport write_labels(std::span<const MeshPart> parts, std::span<const std::int64_t> labels,
                         const std::filesystem::path& path, MeshFormat format,
                         const std::vector<std::string>& comments = {},
                         const std::function<void()>& last_look = {});

} // namespace voroprobe
