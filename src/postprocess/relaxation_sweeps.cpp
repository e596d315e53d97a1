#include "postprocess/relaxation_sweeps.h"

#include <algorithm>
#include <array>
#include <limits>

#include "postprocess/face_shape.h"

namespace voroprobe
{

namespace
{

using Face = TriangleMesh::Face;

//! Angles above this are no reason to leave a vertex where it is, degrees: the others of its star gain.
constexpr double kGoodAngleDeg = 42.0;

//! A flip has to gain as much, degrees: rounding is no gain.
constexpr double kLeastGainDeg = 0.01;

//! Moves below this share of the way to a neighbour are not worth their questions.
constexpr double kLeastMove = 0.005;

//! A move that would not do is tried again at these shares of its way.
constexpr std::array kShares{1.0, 0.5, 0.2};

//! Faces turn by less than 60 degrees when a vertex moves, and stay within 75 of the surface's own direction.
constexpr double kCosLargestTurn = 0.5;
constexpr double kCosLargestTilt = 0.26;

//! Faces that lean by more than 60 degrees from their vertex make a fold.
constexpr double kCosFold = 0.5;

} // namespace

RelaxationSweeps::RelaxationSweeps(EditableMesh& mesh, const BoundingSurface& surface,
                                   const std::vector<bool>& held)
    : mesh_(mesh), surface_(surface), held_(held)
{
}

void RelaxationSweeps::run(int times)
{
    for (int i = 0; i < times; ++i)
    {
        flip_edges();
        move_vertices();
    }
}

double RelaxationSweeps::angle_of(const Face& face) const
{
    return smallest_angle_deg(mesh_.point(face[0]), mesh_.point(face[1]), mesh_.point(face[2]));
}

Vec3 RelaxationSweeps::normal_of(const Face& face) const
{
    return unit_normal(mesh_.point(face[0]), mesh_.point(face[1]), mesh_.point(face[2]));
}

double RelaxationSweeps::distance_of(std::uint32_t f)
{
    face_distances_.resize(mesh_.face_count());
    if (!face_distances_[f])
    {
        const Face& face = mesh_.face(f);
        face_distances_[f] =
            surface_.distance(mesh_.point(face[0]), mesh_.point(face[1]), mesh_.point(face[2]));
    }
    return *face_distances_[f];
}

void RelaxationSweeps::flip_edges()
{
    const auto count = static_cast<std::uint32_t>(mesh_.face_count());
    for (std::uint32_t f = 0; f < count; ++f)
        for (std::size_t i = 0; i < 3 && mesh_.is_alive(f); ++i)
        {
            const std::uint32_t a = mesh_.face(f)[i];
            const std::uint32_t b = mesh_.face(f)[(i + 1) % 3];
            if (a < b)
                try_flip(f, a, b);
        }
}

void RelaxationSweeps::try_flip(std::uint32_t f, std::uint32_t a, std::uint32_t b)
{
    constexpr std::size_t kFewestFaces = 4; // with three, no angle can be good
    const std::uint32_t g = mesh_.face_along(b, a);
    const std::uint32_t c = opposite_corner(mesh_.face(f), a, b);
    const std::uint32_t d = opposite_corner(mesh_.face(g), a, b);
    if (held_[a] || held_[b] || held_[c] || held_[d] || mesh_.faces_of(a).size() <= kFewestFaces ||
        mesh_.faces_of(b).size() <= kFewestFaces || mesh_.are_neighbours(c, d))
        return;
    const std::array<Face, 2> added{Face{a, d, c}, Face{d, b, c}};
    const double before = std::min(angle_of(mesh_.face(f)), angle_of(mesh_.face(g)));
    const double after = std::min(angle_of(added[0]), angle_of(added[1]));
    if (after <= before + kLeastGainDeg)
        return;
    const Vec3 out = normalized(normal_of(mesh_.face(f)) + normal_of(mesh_.face(g)));
    if (dot(normal_of(added[0]), out) < kCosLargestTurn || dot(normal_of(added[1]), out) < kCosLargestTurn ||
        !is_near(0.5 * (mesh_.point(c) + mesh_.point(d)), 0.5 * (mesh_.point(a) + mesh_.point(b))) ||
        !flip_keeps_to_surface(f, g, added))
        return;
    mesh_.replace(std::array{f, g}, added);
    ++edges_flipped_;
}

bool RelaxationSweeps::flip_keeps_to_surface(std::uint32_t f, std::uint32_t g,
                                             const std::array<Face, 2>& added)
{
    const double bound = surface_.max_distance;
    const auto beyond = [bound](double distance) { return distance > bound ? 1 : 0; };
    const auto distance = [this](const Face& face)
    { return surface_.distance(mesh_.point(face[0]), mesh_.point(face[1]), mesh_.point(face[2])); };
    const std::array before{distance_of(f), distance_of(g)};
    const std::array after{distance(added[0]), distance(added[1])};
    return beyond(after[0]) + beyond(after[1]) <= beyond(before[0]) + beyond(before[1]) &&
           std::max(after[0], after[1]) <= std::max({bound, before[0], before[1]});
}

//! Is `p` as near to the surface as is asked for, or as `replaced` was?
bool RelaxationSweeps::is_near(const Point3& p, const Point3& replaced) const
{
    const double distance_to_it = distance_to_surface(p);
    return distance_to_it <= surface_.max_distance || distance_to_it <= distance_to_surface(replaced);
}

double RelaxationSweeps::distance_to_surface(const Point3& p) const
{
    const auto near = surface_.projection(p);
    return near ? distance(p, near->point) : std::numeric_limits<double>::infinity();
}

void RelaxationSweeps::move_vertices()
{
    for (std::uint32_t v = 0; v < mesh_.vertex_count(); ++v)
        if (!mesh_.faces_of(v).empty() && !held_[v])
            try_move(v);
}

//! Along the surface, towards the middle of the neighbours.
void RelaxationSweeps::try_move(std::uint32_t v)
{
    Vec3 normal;
    Point3 middle;
    const auto& star = mesh_.faces_of(v);
    double reach = 0.0;
    for (const std::uint32_t f : star)
    {
        const Face& face = mesh_.face(f);
        normal +=
            cross(mesh_.point(face[1]) - mesh_.point(face[0]), mesh_.point(face[2]) - mesh_.point(face[0]));
        const Point3& neighbour = mesh_.point(next_corner(face, v));
        middle += neighbour / static_cast<double>(star.size());
        reach = std::max(reach, distance(mesh_.point(v), neighbour));
    }
    normal = normalized(normal);
    const Point3 here = mesh_.point(v);
    const Vec3 to_middle = middle - here;
    const Vec3 way = to_middle - dot(to_middle, normal) * normal;
    if (norm(way) < kLeastMove * reach)
        return;
    for (const double share : kShares)
    {
        const auto target = surface_.projection(here + share * way);
        if (!target || dot(target->normal, normal) <= kCosLargestTilt || !improves(v, target->point) ||
            !keeps_fold(v, target->point, normal) || !keeps_bound(v, target->point))
            continue;
        mesh_.move(v, target->point);
        return;
    }
}

//! Does no face of the star get beyond the bound, or farther beyond it?
bool RelaxationSweeps::keeps_bound(std::uint32_t v, const Point3& to)
{
    const auto& star = mesh_.faces_of(v);
    std::vector<double> after;
    for (const std::uint32_t f : star)
    {
        const Face& face = mesh_.face(f);
        const std::uint32_t b = next_corner(face, v);
        after.push_back(surface_.distance(to, mesh_.point(b), mesh_.point(next_corner(face, b))));
        if (after.back() > surface_.max_distance && after.back() > distance_of(f))
            return false;
    }
    face_distances_.resize(mesh_.face_count());
    for (std::size_t i = 0; i < star.size(); ++i)
        face_distances_[star[i]] = after[i];
    return true;
}

//! Where faces fold around a vertex, moving it along one side may take it off the other.
bool RelaxationSweeps::keeps_fold(std::uint32_t v, const Point3& to, const Vec3& normal) const
{
    const auto& star = mesh_.faces_of(v);
    if (std::all_of(star.begin(), star.end(),
                    [&](std::uint32_t f) { return dot(normal_of(mesh_.face(f)), normal) > kCosFold; }))
        return true;
    return std::all_of(star.begin(), star.end(),
                       [&](std::uint32_t f)
                       {
                           const Face& face = mesh_.face(f);
                           const Vec3 middle =
                               (mesh_.point(face[0]) + mesh_.point(face[1]) + mesh_.point(face[2])) / 3.0;
                           return is_near(middle + (to - mesh_.point(v)) / 3.0, middle);
                       });
}

bool RelaxationSweeps::improves(std::uint32_t v, const Point3& to) const
{
    double before = kGoodAngleDeg;
    double after = kGoodAngleDeg;
    for (const std::uint32_t f : mesh_.faces_of(v))
    {
        const Face& face = mesh_.face(f);
        const Point3& b = mesh_.point(next_corner(face, v));
        const Point3& c = mesh_.point(next_corner(face, next_corner(face, v)));
        if (dot(unit_normal(to, b, c), normal_of(face)) < kCosLargestTurn)
            return false;
        before = std::min(before, angle_of(face));
        after = std::min(after, smallest_angle_deg(to, b, c));
    }
    return after >= before;
}

} // namespace voroprobe
