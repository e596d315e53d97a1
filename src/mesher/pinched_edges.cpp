#include "mesher/pinched_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "support/check.h"
#include "support/grouping.h"

namespace voroprobe
{
namespace
{

//! The part of space between a boundary half-edge and its partner: inside, or outside where the inside parts
//! are joined.
struct Wedge
{
    std::uint32_t half_edge;
    double width; //!< radians, in (0, 2 pi)
    Vec3 bisector;
};

//! Unit vector in the plane of a face, orthogonal to its half-edge, towards the face.
Vec3 into_face(const BoundaryComplex& complex, std::uint32_t half_edge)
{
    const BoundaryFace& face = complex.faces[half_edge / 3];
    const std::size_t k = half_edge % 3;
    const Point3 a = position(corner(face, k));
    const Vec3 along = normalized(position(corner(face, (k + 1) % 3)) - a);
    const Vec3 to_apex = position(corner(face, (k + 2) % 3)) - a;
    return normalized(to_apex - dot(to_apex, along) * along);
}

Wedge measure_wedge(const BoundaryComplex& complex, std::uint32_t half_edge, bool inside)
{
    const BoundaryFace& face = complex.faces[half_edge / 3];
    const std::size_t k = half_edge % 3;
    const Vec3 along = normalized(position(corner(face, (k + 1) % 3)) - position(corner(face, k)));
    const Vec3 here = into_face(complex, half_edge);
    const Vec3 there = into_face(complex, complex.partner[half_edge]);

    // The face's outward normal is along x here; the wedge begins at `here` and is swept by turning away from
    // the normal, or towards it for an outside wedge, until `there`.
    const Vec3 into_wedge = inside ? cross(here, along) : cross(along, here);
    double width = std::atan2(dot(there, into_wedge), dot(there, here));
    if (width <= 0.0)
        width += 2.0 * std::numbers::pi;
    return {half_edge, width, std::cos(0.5 * width) * here + std::sin(0.5 * width) * into_wedge};
}

//! An edge of the mesh with more than two faces, by the half-edges that run from a to b.
struct PinchedEdge
{
    std::uint32_t a;
    std::uint32_t b;
    std::vector<std::uint32_t> half_edges;
};

//! Half-edges by their first vertex.
Grouping<std::uint32_t> half_edges_by_source(const TriangleMesh& mesh)
{
    return {mesh.vertices.size(), [&](auto&& visit)
            {
                for (std::uint32_t h = 0; h < 3 * mesh.faces.size(); ++h)
                    visit(mesh.faces[h / 3][h % 3], h);
            }};
}

std::vector<PinchedEdge> find_pinched_edges(const BoundaryComplex& complex)
{
    const TriangleMesh& mesh = complex.mesh;
    Grouping<std::uint32_t> outgoing = half_edges_by_source(mesh);
    const auto target = [&](std::uint32_t h) { return mesh.faces[h / 3][(h % 3 + 1) % 3]; };
    std::vector<PinchedEdge> pinched;
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v)
    {
        if (!complex.vertex_of_copy[v]->info().pinched)
            continue;
        const auto first = outgoing.of(v).begin();
        const auto last = outgoing.of(v).end();
        std::sort(first, last,
                  [&](std::uint32_t g, std::uint32_t h)
                  { return std::pair(target(g), g) < std::pair(target(h), h); });
        for (auto i = first; i != last;)
        {
            const auto end = std::find_if(i, last, [&](std::uint32_t h) { return target(h) != target(*i); });
            if (end - i > 1 && v < target(*i)) // each edge from one of its ends
                pinched.push_back({v, target(*i), {i, end}});
            i = end;
        }
    }
    return pinched;
}

//! Cuts mesh faces at new vertices in their edges, and knows the pieces of each.
class FaceCutter
{
public:
    explicit FaceCutter(BoundaryComplex& complex) : complex_(complex) {}

    //! Puts `middle` into the edge between the mesh vertices a and b of boundary face f.
    void cut(std::uint32_t f, std::uint32_t a, std::uint32_t b, std::uint32_t middle)
    {
        const auto found = pieces_.try_emplace(f, std::vector<std::uint32_t>{f}).first;
        for (const std::uint32_t piece : found->second)
        {
            TriangleMesh::Face& face = complex_.mesh.faces[piece];
            for (std::size_t k = 0; k < 3; ++k)
            {
                if (face[k] != a || face[(k + 1) % 3] != b)
                    continue;
                const TriangleMesh::Face second{middle, b, face[(k + 2) % 3]};
                face[(k + 1) % 3] = middle;
                found->second.push_back(static_cast<std::uint32_t>(complex_.mesh.faces.size()));
                complex_.mesh.faces.push_back(second);
                complex_.origin_of_face.push_back(f);
                return;
            }
        }
        CHECK(false && "the edge is on a piece of its face");
    }

private:
    BoundaryComplex& complex_;
    std::map<std::uint32_t, std::vector<std::uint32_t>> pieces_; //!< of the boundary faces cut so far
};

//! Gives the wedge a middle vertex of its own.
Displacement split_wedge(BoundaryComplex& complex, FaceCutter& cutter, const PinchedEdge& edge,
                         const Wedge& wedge)
{
    const Point3 a = complex.mesh.vertices[edge.a];
    const Point3 b = complex.mesh.vertices[edge.b];
    const Point3 middle = 0.5 * (a + b);
    const auto vertex = static_cast<std::uint32_t>(complex.mesh.vertices.size());
    complex.mesh.vertices.push_back(middle);
    complex.vertex_of_copy.emplace_back();
    cutter.cut(wedge.half_edge / 3, edge.a, edge.b, vertex);
    cutter.cut(complex.partner[wedge.half_edge] / 3, edge.b, edge.a, vertex);
    return {vertex, complex.vertex_of_copy[edge.a], middle, wedge.bisector, kHairPerEdge * distance(a, b)};
}

} // namespace

std::vector<Displacement> split_pinched_edges(const RestrictedDelaunay& restricted, BoundaryComplex& complex)
{
    std::vector<Displacement> moves;
    FaceCutter cutter(complex);
    for (const PinchedEdge& edge : find_pinched_edges(complex))
    {
        std::vector<Wedge> wedges;
        const bool joined = joined_at_edge(restricted, complex.faces[edge.half_edges.front() / 3].inside,
                                           complex.vertex_of_copy[edge.a], complex.vertex_of_copy[edge.b]);
        for (const std::uint32_t half_edge : edge.half_edges)
            wedges.push_back(measure_wedge(complex, half_edge, !joined));
        std::sort(wedges.begin(), wedges.end(),
                  [](const Wedge& a, const Wedge& b) { return a.width < b.width; });
        for (std::size_t i = 0; i + 1 < wedges.size(); ++i) // the widest stays
            moves.push_back(split_wedge(complex, cutter, edge, wedges[i]));
    }
    return moves;
}

} // namespace voroprobe
