#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "compare/contestant.h"
#include "geometry/vec3.h"

namespace voroprobe
{

//! The samples as the peers get them: 32-bit floats, x fastest, inside where at least the isovalue. Exact for
//! integers of up to 24 bits. Sample (i, j, k) is at origin + spacing .* (i, j, k), grid frame.
struct PeerField
{
    std::array<std::size_t, 3> size;
    Vec3 spacing;
    Point3 origin{0, 0, 0};
    std::vector<float> samples;
    double isovalue; //!< that of the task, or next to it where samples equal that: see LevelSurvey
    Box3 border;     //!< of the volume's samples: where the object ends
};

//! For peers that draw random numbers: CGAL takes the time of day otherwise, another mesh each time.
constexpr unsigned kRandomSeed = 1;

//! The field of a task. What is not finite becomes a value outside; where the object lies below the isovalue,
//! signs are changed. Cost: a pass over the samples.
PeerField make_peer_field(const MeshingTask& task);

//! The field with one layer of outside samples around it: the lowest sample.
PeerField padded(const PeerField& field);

//! Moves what lies beyond the border onto it: caps of a surface made of the padded field. Where two or three
//! sides of the border meet, vertices of their caps fall together: they are made one, and faces between them
//! are left out.
void close_on_border(TriangleMesh& mesh, const Box3& border);

//! Faces turned over where the mesh as a whole winds inward.
void wind_outward(TriangleMesh& mesh);

//! Points on the surface, on edges of the grid, up to `per_region` for each 6-connected set of inside
//! samples, spread over its border crossings. The same for the same input. For peers that have to be told
//! where the surface is.
std::vector<Point3> seeds_on_every_region(const PeerField& field, std::size_t per_region);

} // namespace voroprobe
