#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh_part.h"

namespace voroprobe
{

//! What a printer asks of a mesh in millimetres, z up.
struct PrintOptions
{
    std::optional<double> min_wall = std::nullopt;      //!< mm, > 0; thinner walls fail
    std::optional<Vec3> bed = std::nullopt;             //!< build volume, mm
    std::optional<double> density_g_cm3 = std::nullopt; //!< of the material, > 0
    double overhang_deg = 45.0;   //!< from the vertical; faces that lean out farther hang over
    std::size_t samples = 100000; //!< points at which walls and gaps are measured
};

//! The smallest length found, and where.
struct Narrowest
{
    double length; //!< mm
    Point3 at;
};

//! Of the surface that is a side of a wall, this much is on walls thinner than so many mm: one noisy place
//! moves the thinnest wall, and none of these.
struct WallThickness
{
    double percent_1;
    double percent_5;
    double median;
};

//! A closed surface inside of a body: powder and resin stay in.
struct TrappedCavity
{
    double volume; //!< mm3
    Box3 box;
};

struct PrintCheck
{
    Box3 box;
    std::size_t bodies = 0;
    std::vector<TrappedCavity> cavities; //!< largest first
    double volume = 0.0;                 //!< of material, mm3
    std::optional<double> weight_g = std::nullopt;

    //! Thickness: from a point of the surface along its inward normal to the first face that looks away from
    //! it, within 60 degrees. Walls that are wedges with a larger angle are not measured. nullopt: no wall
    //! was met.
    std::optional<Narrowest> thinnest_wall = std::nullopt;
    std::optional<WallThickness> wall_thickness = std::nullopt;
    double thin_area_share = 0.0; //!< of the surface, below min_wall
    std::optional<Narrowest> narrowest_gap =
        std::nullopt; //!< likewise, outward, to the first face that looks back

    Box3 smallest_body;          //!< the one with the shortest diagonal
    double overhang_area = 0.0;  //!< mm2, but for what lies on the bed
    double overhang_share = 0.0; //!< of all of the area
    bool fits = true;            //!< the bed, as it lies or turned by 90 degrees
    bool fits_turned = false;    //!< only turned

    std::vector<std::string> warnings; //!< a line each: size, cavities
    std::vector<std::string> failures; //!< a line each: wall, bed
};

//! Judges objects that lie beside one another. \pre each closed and oriented; else volume, cavities and walls
//! mean little. Deterministic. Cost: one ray each way per sample. \throw UsageError where there is no face
//! with area.
PrintCheck check_printable(const std::vector<MeshPart>& parts, const PrintOptions& options);

} // namespace voroprobe
