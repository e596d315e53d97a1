#include "postprocess/face_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "postprocess/face_shape.h"

namespace voroprobe
{

namespace
{

using Face = TriangleMesh::Face;

constexpr int kDirections = 8;

//! First and last step of the search for a better place, as shares of the mean distance to the neighbours.
constexpr double kFirstStep = 0.25;
constexpr double kLastStep = 0.015;
constexpr int kMostSteps = 24;

//! The fewest faces around a vertex of a closed mesh.
constexpr std::size_t kFewestFaces = 3;

bool names(const Face& face, std::uint32_t vertex)
{
    return face[0] == vertex || face[1] == vertex || face[2] == vertex;
}

bool contains(const std::vector<std::uint32_t>& list, std::uint32_t value)
{
    return std::find(list.begin(), list.end(), value) != list.end();
}

void rename(Face& face, std::uint32_t from, std::uint32_t to)
{
    std::replace(face.begin(), face.end(), from, to);
}

//! Two unit vectors at right angles to a unit vector and one another.
std::array<Vec3, 2> tangents(const Vec3& normal)
{
    const Vec3 axis = std::abs(normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 first = normalized(cross(normal, axis));
    return {first, cross(normal, first)};
}

} // namespace

FacePatch::FacePatch(const EditableMesh& mesh, std::span<const std::uint32_t> inner)
    : mesh_(&mesh), inner_(inner.begin(), inner.end())
{
    for (const std::uint32_t v : inner_)
    {
        removed_.insert(removed_.end(), mesh.faces_of(v).begin(), mesh.faces_of(v).end());
    }
    std::sort(removed_.begin(), removed_.end());
    removed_.erase(std::unique(removed_.begin(), removed_.end()), removed_.end());
    for (const std::uint32_t f : removed_)
        faces_.push_back(mesh.face(f));
}

Point3 FacePatch::point(std::uint32_t vertex) const
{
    for (const Moved& moved : moved_)
        if (moved.vertex == vertex)
            return moved.to;
    return mesh_->point(vertex);
}

bool FacePatch::replaces(std::uint32_t face) const
{
    return std::binary_search(removed_.begin(), removed_.end(), face);
}

bool FacePatch::has_moved(std::uint32_t vertex) const
{
    return std::any_of(moved_.begin(), moved_.end(),
                       [vertex](const Moved& moved) { return moved.vertex == vertex; });
}

void FacePatch::move(std::uint32_t vertex, const Point3& to)
{
    for (Moved& moved : moved_)
        if (moved.vertex == vertex)
        {
            moved.to = to;
            return;
        }
    moved_.push_back({vertex, to});
}

bool FacePatch::is_inner(std::uint32_t vertex) const
{
    return contains(inner_, vertex);
}

std::optional<std::size_t> FacePatch::index_along(std::uint32_t a, std::uint32_t b) const
{
    for (std::size_t i = 0; i < faces_.size(); ++i)
        if (names(faces_[i], a) && next_corner(faces_[i], a) == b)
            return i;
    return std::nullopt;
}

//! Of a vertex whose faces are all in the patch; of others those that the patch knows.
std::vector<std::uint32_t> FacePatch::neighbours(std::uint32_t vertex) const
{
    std::vector<std::uint32_t> result;
    for (const Face& face : faces_)
        if (names(face, vertex))
            for (const std::uint32_t corner : face)
                if (corner != vertex && !contains(result, corner))
                    result.push_back(corner);
    return result;
}

//! Number of faces around a vertex, in the patch and outside.
std::size_t FacePatch::valence(std::uint32_t vertex) const
{
    auto count = static_cast<std::size_t>(std::count_if(
        faces_.begin(), faces_.end(), [vertex](const Face& face) { return names(face, vertex); }));
    if (vertex < mesh_->vertex_count())
        for (const std::uint32_t f : mesh_->faces_of(vertex))
            count += replaces(f) ? 0 : 1;
    return count;
}

bool FacePatch::are_neighbours(std::uint32_t a, std::uint32_t b) const
{
    const auto joins = [a, b](const Face& face) { return names(face, a) && names(face, b); };
    if (std::any_of(faces_.begin(), faces_.end(), joins))
        return true;
    return a < mesh_->vertex_count() &&
           std::any_of(mesh_->faces_of(a).begin(), mesh_->faces_of(a).end(),
                       [&](std::uint32_t f) { return !replaces(f) && joins(mesh_->face(f)); });
}

std::vector<std::array<std::uint32_t, 2>> FacePatch::inner_edges() const
{
    std::vector<std::array<std::uint32_t, 2>> edges;
    for (const Face& face : faces_)
        for (std::size_t i = 0; i < 3; ++i)
            if (const std::uint32_t a = face[i], b = face[(i + 1) % 3]; a < b && is_inner(a) && is_inner(b))
                edges.push_back({a, b});
    return edges;
}

bool FacePatch::flip(std::uint32_t a, std::uint32_t b)
{
    const auto f = index_along(a, b);
    const auto g = index_along(b, a);
    if (!f || !g)
        return false;
    const std::uint32_t c = opposite_corner(faces_[*f], a, b);
    const std::uint32_t d = opposite_corner(faces_[*g], a, b);
    if (are_neighbours(c, d) || valence(a) <= kFewestFaces || valence(b) <= kFewestFaces)
        return false;
    faces_[*f] = {a, d, c};
    faces_[*g] = {d, b, c};
    return true;
}

//! Source: Dey, Edelsbrunner, Guha & Nekhayev 1999 (link condition).
bool FacePatch::collapse(std::uint32_t a, std::uint32_t b)
{
    const auto f = index_along(a, b);
    const auto g = index_along(b, a);
    if (!f || !g || !is_inner(a) || !is_inner(b))
        return false;
    const std::uint32_t c = opposite_corner(faces_[*f], a, b);
    const std::uint32_t d = opposite_corner(faces_[*g], a, b);
    if (valence(c) <= kFewestFaces || valence(d) <= kFewestFaces)
        return false;
    for (const std::uint32_t v : neighbours(a))
        if (v != b && v != c && v != d && contains(neighbours(b), v))
            return false;
    const Point3 middle = 0.5 * (point(a) + point(b));
    std::erase_if(faces_, [&](const Face& face) { return names(face, a) && names(face, b); });
    for (Face& face : faces_)
        rename(face, b, a);
    std::erase(inner_, b);
    move(a, middle);
    return true;
}

bool FacePatch::split(std::uint32_t a, std::uint32_t b)
{
    const auto f = index_along(a, b);
    const auto g = index_along(b, a);
    if (!f || !g)
        return false;
    const auto m = static_cast<std::uint32_t>(mesh_->vertex_count()) + new_vertices_++;
    Face second_f = faces_[*f];
    Face second_g = faces_[*g];
    rename(faces_[*f], b, m);
    rename(faces_[*g], b, m);
    rename(second_f, a, m);
    rename(second_g, a, m);
    faces_.push_back(second_f);
    faces_.push_back(second_g);
    move(m, 0.5 * (point(a) + point(b)));
    inner_.push_back(m);
    return true;
}

double FacePatch::smallest_angle_around(std::uint32_t vertex, const Point3& at) const
{
    double smallest = std::numeric_limits<double>::infinity();
    for (const Face& face : faces_)
        if (names(face, vertex))
        {
            const std::uint32_t b = next_corner(face, vertex);
            const std::uint32_t c = next_corner(face, b);
            smallest = std::min(smallest, voroprobe::smallest_angle_deg(at, point(b), point(c)));
        }
    return smallest;
}

//! Does no face around the vertex come to lie beyond the bound, or farther beyond it, by the move?
bool FacePatch::keeps_bound(std::uint32_t vertex, const Point3& to, const BoundingSurface& surface) const
{
    return std::all_of(faces_.begin(), faces_.end(),
                       [&](const Face& face)
                       {
                           if (!names(face, vertex))
                               return true;
                           const Point3 b = point(next_corner(face, vertex));
                           const Point3 c = point(next_corner(face, next_corner(face, vertex)));
                           const double after = surface.distance(to, b, c);
                           return after <= surface.max_distance ||
                                  after <= surface.distance(point(vertex), b, c);
                       });
}

//! Compass search in the tangent plane. Source: Kolda, Lewis & Torczon 2003.
void FacePatch::improve_position(std::uint32_t vertex, const BoundingSurface* surface)
{
    Point3 at = point(vertex);
    Vec3 normal;
    double reach = 0.0;
    const std::vector<std::uint32_t> around = neighbours(vertex);
    for (const Face& face : faces_)
        if (names(face, vertex))
            normal += cross(point(face[1]) - point(face[0]), point(face[2]) - point(face[0]));
    for (const std::uint32_t v : around)
        reach += distance(at, point(v)) / static_cast<double>(around.size());
    if (around.empty() || normal == Vec3{})
        return;
    const auto [u, w] = tangents(normalized(normal));
    double best = smallest_angle_around(vertex, at);
    double step = kFirstStep;
    for (int trial_round = 0; trial_round < kMostSteps && step > kLastStep; ++trial_round)
    {
        bool better = false;
        for (int i = 0; i < kDirections; ++i)
        {
            const double turn = 2.0 * std::numbers::pi * i / kDirections;
            Point3 trial = at + step * reach * (std::cos(turn) * u + std::sin(turn) * w);
            if (surface != nullptr)
                trial = surface->projection(trial).value_or(NearestPoint{at, {}}).point;
            const double angle = smallest_angle_around(vertex, trial);
            if (angle > best && (surface == nullptr || keeps_bound(vertex, trial, *surface)))
            {
                best = angle;
                at = trial;
                better = true;
                break;
            }
        }
        step *= better ? 1.0 : 0.5;
    }
    if (!(at == point(vertex)))
        move(vertex, at);
}

void FacePatch::improve_positions(int rounds, const BoundingSurface* surface)
{
    for (int round = 0; round < rounds; ++round)
        for (const std::uint32_t v : inner_)
            improve_position(v, surface);
}

TriangleMesh FacePatch::mesh() const
{
    TriangleMesh mesh;
    std::vector<std::uint32_t> vertices;
    for (const Face& face : faces_)
    {
        Face renamed = face;
        for (std::uint32_t& v : renamed)
        {
            const auto known = std::find(vertices.begin(), vertices.end(), v);
            const auto place = static_cast<std::uint32_t>(known - vertices.begin());
            if (known == vertices.end())
            {
                vertices.push_back(v);
                mesh.vertices.push_back(point(v));
            }
            v = place;
        }
        mesh.faces.push_back(renamed);
    }
    return mesh;
}

double FacePatch::longest_edge_at(std::uint32_t vertex) const
{
    double longest = 0.0;
    for (const std::uint32_t v : neighbours(vertex))
        longest = std::max(longest, distance(point(vertex), point(v)));
    return longest;
}

double FacePatch::shortfall(double goal_angle_deg) const
{
    double sum = 0.0;
    for (const Face& face : faces_)
    {
        const double angle = voroprobe::smallest_angle_deg(point(face[0]), point(face[1]), point(face[2]));
        const double missing = std::max(0.0, goal_angle_deg - angle);
        sum += missing * missing;
    }
    return sum;
}

double FacePatch::smallest_angle_deg() const
{
    double smallest = std::numeric_limits<double>::infinity();
    for (const Face& face : faces_)
        smallest =
            std::min(smallest, voroprobe::smallest_angle_deg(point(face[0]), point(face[1]), point(face[2])));
    return smallest;
}

void FacePatch::commit(EditableMesh& mesh) const
{
    const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
    for (std::uint32_t i = 0; i < new_vertices_; ++i)
        mesh.add_vertex(point(first + i));
    for (const Moved& moved : moved_)
        mesh.move(moved.vertex, moved.to);
    mesh.replace(removed_, faces_);
}

} // namespace voroprobe
