#include "mesher/contact_separation.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "geometry/box3.h"
#include "mesher/face_crossings.h"
#include "mesher/vertex_sectors.h"
#include "support/grouping.h"

namespace voroprobe
{
namespace
{

constexpr int kHalvings = 6;          // of a move whose faces cross others, before it is given up
constexpr int kDirectionSteps = 200;  // of the search for a direction behind all faces of an umbrella
constexpr double kLeastMargin = 0.02; // sine of the least angle between a move and the faces it leaves

//! The index of the Delaunay vertex that each mesh vertex is a copy of; kNoIndex for one inside an edge.
constexpr auto kNoIndex = std::numeric_limits<std::uint32_t>::max();
std::vector<std::uint32_t> indices_of_copies(const BoundaryComplex& complex)
{
    std::vector<std::uint32_t> indices;
    indices.reserve(complex.vertex_of_copy.size());
    for (const VertexHandle vertex : complex.vertex_of_copy)
        indices.push_back(vertex == VertexHandle() ? kNoIndex : vertex->info().index);
    return indices;
}

//! Mesh faces by the indices of the Delaunay vertices of the boundary faces they are pieces of.
Grouping<std::uint32_t> faces_around_vertices(const RestrictedDelaunay& restricted,
                                              const BoundaryComplex& complex)
{
    const std::vector<std::uint32_t> index = indices_of_copies(complex);
    return {restricted.vertex_index_bound(), [&](auto&& visit)
            {
                for (std::uint32_t m = 0; m < complex.mesh.faces.size(); ++m)
                {
                    const TriangleMesh::Face& face = complex.mesh.faces[m];
                    const bool is_whole = std::all_of(face.begin(), face.end(),
                                                      [&](std::uint32_t v) { return index[v] != kNoIndex; });
                    for (std::size_t k = 0; k < 3; ++k)
                        visit(is_whole ? index[face[k]]
                                       : corner(complex.faces[complex.origin_of_face[m]], k)->info().index,
                              m);
                }
            }};
}

Box3 bounds_of(const TriangleMesh& mesh, const TriangleMesh::Face& face)
{
    Box3 box;
    for (std::size_t k = 0; k < 3; ++k)
        box.include(mesh.corner(face, k));
    return box;
}

bool boxes_meet(const Box3& a, const Box3& b)
{
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y &&
           a.min.z <= b.max.z && b.min.z <= a.max.z;
}

Vec3 unit_normal(const TriangleMesh& mesh, const TriangleMesh::Face& face)
{
    const Point3 a = mesh.corner(face, 0);
    return normalized(cross(mesh.corner(face, 1) - a, mesh.corner(face, 2) - a));
}

//! A unit vector whose product with every one of the unit vectors is at least kLeastMargin; nullopt where
//! none was found. Perceptron: turns towards the vector it satisfies least.
std::optional<Vec3> direction_along_all(const std::vector<Vec3>& vectors)
{
    Vec3 direction;
    for (const Vec3& vector : vectors)
        direction += vector;
    direction = normalized(direction);

    double best_margin = kLeastMargin;
    std::optional<Vec3> best;
    for (int step = 0; step < kDirectionSteps; ++step)
    {
        const auto worst = std::min_element(vectors.begin(), vectors.end(),
                                            [&](const Vec3& a, const Vec3& b)
                                            { return dot(a, direction) < dot(b, direction); });
        const double margin = dot(*worst, direction);
        if (margin > best_margin)
        {
            best_margin = margin;
            best = direction;
        }
        direction = normalized(direction + (1.0 / (step + 2.0)) * *worst);
    }
    return best;
}

class ContactSeparation
{
public:
    ContactSeparation(const RestrictedDelaunay& restricted, BoundaryComplex& complex)
        : restricted_(restricted), complex_(complex), mesh_(complex.mesh),
          faces_(faces_around_vertices(restricted, complex))
    {
    }

    void add_moves(const std::vector<Displacement>& moves)
    {
        moves_.insert(moves_.end(), moves.begin(), moves.end());
    }

    //! Plans the moves of the copies of a vertex.
    void plan(VertexHandle vertex)
    {
        std::vector<BoundaryFace> faces;
        std::vector<std::uint32_t> copies;
        for (const std::uint32_t m : faces_around(vertex))
        {
            for (const std::uint32_t copy : mesh_.faces[m])
            {
                if (complex_.vertex_of_copy[copy] != vertex)
                    continue;
                faces.push_back(complex_.faces[complex_.origin_of_face[m]]);
                copies.push_back(copy);
            }
        }
        std::size_t staying = 0;
        for (const UmbrellaSides& sides : find_umbrella_sides(restricted_, vertex, faces, copies))
        {
            if (const auto move = plan_move(vertex, sides))
                moves_.push_back(*move);
            else
                ++staying;
        }
        if (staying > 1)
            report_.unseparated.push_back(vertex);
    }

    ContactReport run()
    {
        for (const Displacement& move : moves_)
            apply(move);
        std::vector<Displacement*> crossing;
        for (Displacement& move : moves_)
            crossing.push_back(&move);
        for (int halving = 0; halving <= kHalvings && !crossing.empty(); ++halving)
        {
            std::vector<Displacement*> still_crossing;
            std::copy_if(crossing.begin(), crossing.end(), std::back_inserter(still_crossing),
                         [&](const Displacement* move) { return crosses(*move); });
            for (Displacement* move : still_crossing)
            {
                move->length *= halving < kHalvings ? 0.5 : 0.0;
                apply(*move);
            }
            crossing = std::move(still_crossing);
        }
        for (const Displacement* move : crossing)
            report_.unseparated.push_back(move->near);
        report_.separated = moves_.size() - crossing.size();
        const auto by_index = [](VertexHandle a, VertexHandle b)
        { return a->info().index < b->info().index; };
        std::sort(report_.unseparated.begin(), report_.unseparated.end(), by_index);
        report_.unseparated.erase(std::unique(report_.unseparated.begin(), report_.unseparated.end()),
                                  report_.unseparated.end());
        return report_;
    }

private:
    [[nodiscard]] std::span<const std::uint32_t> faces_around(VertexHandle vertex) const
    {
        return faces_.of(vertex->info().index);
    }

    std::optional<Displacement> plan_move(VertexHandle vertex, const UmbrellaSides& sides) const
    {
        std::vector<Vec3> inward;
        double shortest = std::numeric_limits<double>::infinity();
        for (const std::uint32_t m : faces_around(vertex))
        {
            const TriangleMesh::Face& face = mesh_.faces[m];
            const auto at = std::find(face.begin(), face.end(), sides.copy);
            if (at == face.end())
                continue;
            inward.push_back(-unit_normal(mesh_, face));
            for (std::size_t k = 0; k < 3; ++k)
                shortest =
                    std::min(shortest, distance(mesh_.corner(face, k), mesh_.corner(face, (k + 1) % 3)));
        }
        std::optional<Vec3> direction;
        if (sides.owns_inside)
            direction = direction_along_all(inward);
        if (!direction && sides.owns_outside)
        {
            for (Vec3& normal : inward)
                normal = -normal;
            direction = direction_along_all(inward);
        }
        if (!direction)
            return std::nullopt;
        return Displacement{sides.copy, vertex, position(vertex), *direction, kHairPerEdge * shortest};
    }

    void apply(const Displacement& move)
    {
        mesh_.vertices[move.vertex] = move.from + move.length * move.direction;
    }

    //! Whether a face at the moved vertex crosses any other face near it.
    bool crosses(const Displacement& move)
    {
        std::vector<VertexHandle> neighbors{move.near};
        restricted_.triangulation().finite_adjacent_vertices(move.near, std::back_inserter(neighbors));
        std::vector<std::uint32_t> nearby;
        for (const VertexHandle neighbor : neighbors)
            nearby.insert(nearby.end(), faces_around(neighbor).begin(), faces_around(neighbor).end());
        std::sort(nearby.begin(), nearby.end());
        nearby.erase(std::unique(nearby.begin(), nearby.end()), nearby.end());

        for (const std::uint32_t m : nearby)
        {
            const TriangleMesh::Face& moved = mesh_.faces[m];
            if (std::find(moved.begin(), moved.end(), move.vertex) == moved.end())
                continue;
            const Box3 moved_box = bounds_of(mesh_, moved);
            for (const std::uint32_t other : nearby)
            {
                if (other != m && boxes_meet(moved_box, bounds_of(mesh_, mesh_.faces[other])) &&
                    faces_cross(mesh_, moved, mesh_.faces[other]))
                    return true;
            }
        }
        return false;
    }

    const RestrictedDelaunay& restricted_;
    BoundaryComplex& complex_;
    TriangleMesh& mesh_;
    Grouping<std::uint32_t> faces_;
    std::vector<Displacement> moves_;
    ContactReport report_;
};

//! The Delaunay vertices with several copies, in the order of their second ones.
std::vector<VertexHandle> find_singular_vertices(const BoundaryComplex& complex)
{
    std::vector<std::uint8_t> copies;
    std::vector<VertexHandle> singular;
    for (const VertexHandle vertex : complex.vertex_of_copy)
    {
        if (vertex == VertexHandle())
            continue;
        const std::uint32_t index = vertex->info().index;
        if (index >= copies.size())
            copies.resize(std::max<std::size_t>(index + 1, 2 * copies.size()), 0);
        if (copies[index] == 1)
            singular.push_back(vertex);
        copies[index] = static_cast<std::uint8_t>(std::min(copies[index] + 1, 2));
    }
    return singular;
}

} // namespace

ContactReport separate_contacts(const RestrictedDelaunay& restricted, BoundaryComplex& complex,
                                const std::vector<Displacement>& pinched)
{
    const auto singular = find_singular_vertices(complex);
    if (singular.empty() && pinched.empty())
        return {};
    ContactSeparation separation(restricted, complex);
    separation.add_moves(pinched);
    for (const VertexHandle vertex : singular)
        separation.plan(vertex);
    return separation.run();
}

} // namespace voroprobe
