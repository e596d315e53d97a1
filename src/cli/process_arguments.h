#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/affine_transform.h"
#include "postprocess/bodies.h"

namespace CLI // NOLINT(readability-identifier-naming): the name of the library
{
class App;
}

namespace voroprobe
{

//! How many faces decimation is to leave.
struct FaceGoal
{
    std::optional<std::size_t> count = std::nullopt;
    std::optional<double> share = std::nullopt; //!< of those there are, in (0, 1)

    [[nodiscard]] bool given() const { return count || share; }
};

//! Where the mesh is put, in this order.
struct PlacementArguments
{
    double scale = 1.0;
    std::vector<AffineTransform> moves = {}; //!< rotations and translations as they were given
    bool center = false;                     //!< the box's middle to the origin
    bool on_bed = false;                     //!< the box's middle above the origin, its lowest point at z = 0

    [[nodiscard]] bool keeps_all() const { return scale == 1.0 && moves.empty() && !center && !on_bed; }
};

//! What `voroprobe process` and `voroprobe mesh` can do to a mesh that is there, in the order in which it is
//! done.
struct FinishArguments
{
    std::size_t smooth = 0; //!< rounds
    FaceGoal decimate;
    std::optional<double> max_error = std::nullopt; //!< of decimation, mm
    double decimate_angle_deg = 20.0;
    bool relax = false;
    std::optional<double> max_distance = std::nullopt; //!< that a step may move the surface, mm
    PlacementArguments placement;

    [[nodiscard]] bool decimates() const { return decimate.given() || max_error; }
    [[nodiscard]] bool changes_shape() const { return smooth > 0 || decimates() || relax; }
};

//! How to hollow bodies out.
struct HollowArguments
{
    std::optional<double> wall = std::nullopt;  //!< mm; unset: leave them solid
    std::optional<double> drain = std::nullopt; //!< diameter, mm; unset: no way out
    std::optional<double> voxel = std::nullopt; //!< mm; unset: a quarter of the wall
};

//! Everything the user can say to `voroprobe process`.
struct ProcessArguments
{
    std::filesystem::path mesh;
    std::filesystem::path output;
    std::optional<std::string> format = std::nullopt;
    bool normals = false; //!< of the vertices, into the file
    std::optional<std::filesystem::path> summary = std::nullopt;
    bool quiet = false;

    double mm_per_unit = 1.0;
    bool repair = false;
    std::optional<double> max_hole_rim = std::nullopt; //!< mm
    BodySelection bodies;
    bool sort = false;
    bool split = false;
    FinishArguments finish;
    HollowArguments hollow;
};

//! Declares the command's options; `arguments` must outlive the parsing and holds the values after it.
void add_process_arguments(CLI::App& command, ProcessArguments& arguments);

//! Whether --smooth is among the options; `mesh` has one of its own, for label maps.
enum class OffersSmoothing
{
    kNo,
    kYes
};

//! Those that `mesh` takes as well.
void add_finish_options(CLI::App& command, FinishArguments& arguments, OffersSmoothing smoothing);

} // namespace voroprobe
