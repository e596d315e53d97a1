#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "labels/smoothing.h"

namespace CLI // NOLINT(readability-identifier-naming): the name of the library
{
class App;
}

namespace voroprobe
{

//! What the user says of a label map to `voroprobe mesh --labels` and `voroprobe compare --labels`.
struct LabelArguments
{
    std::optional<std::string> labels = std::nullopt;       //!< as LabelRanges takes it; unset: no label map
    std::optional<std::string> exclude = std::nullopt;      //!< likewise
    std::optional<LabelSmoothing> smoothing = std::nullopt; //!< sigma 0 where none was given
    std::optional<std::filesystem::path> names = std::nullopt;

    std::optional<std::size_t> most_labels = std::nullopt; //!< unset: by what the image looks like

    bool shared_interfaces = false; //!< smoothing is joint then

    [[nodiscard]] bool wanted() const { return labels.has_value(); }
};

//! Declares the options of every command that meshes label maps; `arguments` must outlive the parsing and
//! holds the values after it.
void add_label_options(CLI::App& command, LabelArguments& arguments);

//! Likewise those of `voroprobe mesh` alone.
void add_label_mesh_options(CLI::App& command, LabelArguments& arguments);

} // namespace voroprobe
