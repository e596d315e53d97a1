// This file follows:
// Akio Doi and Akio Koide, An efficient method of triangulating equi-valued surfaces by using tetrahedral
// cells, 1991, for the zero set.

#include "oracles/point_cloud_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Poisson_reconstruction_function.h>
#include <CGAL/property_map.h>

#include "oracles/triangle_mesh_oracle.h"
#include "support/error.h"
#include "support/random.h"

namespace voroprobe
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using PointWithNormal = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Poisson = CGAL::Poisson_reconstruction_function<Kernel>;
using Triangulation = Poisson::Triangulation;
using Matrix = CGAL::Eigen_sparse_symmetric_matrix<double>::EigenType;
using Solver = CGAL::Eigen_solver_traits<Eigen::ConjugateGradient<Matrix>>;
using VertexHandle = Triangulation::Vertex_handle;
using CellHandle = Triangulation::Cell_handle;

//! Fewer hardly sample anything.
constexpr std::size_t kFewestPoints = 10;

std::vector<PointWithNormal> checked_points(std::span<const OrientedPoint> points, const std::string& name)
{
    if (points.size() < kFewestPoints)
        throw InputError(name + " has " + std::to_string(points.size()) + " points; it must have at least " +
                         std::to_string(kFewestPoints));
    std::vector<PointWithNormal> checked;
    checked.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const Point3& p = points[i].position;
        const Vec3 n = normalized(points[i].normal);
        if (!is_finite(p) || !is_finite(n) || n == Vec3{})
            throw InputError("point " + std::to_string(i + 1) + " of " + name +
                             " is not finite or has no normal; every point must have both");
        checked.emplace_back(Kernel::Point_3(p.x, p.y, p.z), Kernel::Vector_3(n.x, n.y, n.z));
    }
    return checked;
}

bool are_coplanar(const std::vector<PointWithNormal>& points)
{
    const auto& a = points.front().first;
    const auto differs = [&](const PointWithNormal& p) { return p.first != a; };
    const auto b = std::find_if(points.begin(), points.end(), differs);
    if (b == points.end())
        return true;
    const auto c =
        std::find_if(points.begin(), points.end(),
                     [&](const PointWithNormal& p) { return !CGAL::collinear(a, b->first, p.first); });
    if (c == points.end())
        return true;
    return std::all_of(points.begin(), points.end(),
                       [&](const PointWithNormal& p)
                       { return CGAL::coplanar(a, b->first, c->first, p.first); });
}

//! By how much points are moved before the fit, as a fraction of their mean spacing on a surface as large as
//! their box: far below what the fit does to them.
constexpr double kJitter = 1e-2;

//! CGAL's refinement gives up, and spoils the fit, where very many points lie on one sphere: so each is moved
//! by a hair, the same at every run.
void jitter(std::vector<PointWithNormal>& points)
{
    CGAL::Bbox_3 box;
    for (const PointWithNormal& point : points)
        box += point.first.bbox();
    const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
    const double reach = kJitter * diagonal / std::sqrt(static_cast<double>(points.size()));
    Random random(0);
    for (PointWithNormal& point : points)
    {
        const double x = random.uniform(-reach, reach);
        const double y = random.uniform(-reach, reach);
        point.first = point.first + Kernel::Vector_3(x, y, random.uniform(-reach, reach));
    }
}

//! Keeps what CGAL tells developers off the users' terminal.
class SilentErrorStream
{
public:
    SilentErrorStream() : shown_(std::cerr.rdbuf(hidden_.rdbuf())) {}
    SilentErrorStream(const SilentErrorStream&) = delete;
    SilentErrorStream& operator=(const SilentErrorStream&) = delete;
    ~SilentErrorStream() { std::cerr.rdbuf(shown_); }

private:
    std::ostringstream hidden_;
    std::streambuf* shown_;
};

//! The zero set of a function that is linear on the cells of a triangulation, a triangle or two in each cell,
//! closed by the convex hull of its vertices.
class ZeroSet
{
public:
    explicit ZeroSet(const Triangulation& triangulation)
    {
        for (auto cell = triangulation.all_cells_begin(); cell != triangulation.all_cells_end(); ++cell)
            if (triangulation.is_infinite(cell))
                add_cap(cell, cell->index(triangulation.infinite_vertex()));
            else
                add(cell);
    }

    TriangleMesh take() { return std::move(mesh_); }

private:
    //! Zero counts as inside.
    [[nodiscard]] static bool is_inside(VertexHandle v) { return v->f() <= 0.0; }

    struct Corners
    {
        std::array<int, 4> corner;
        std::size_t inside; //!< how many of them
    };

    //! The corners of a cell in positive orientation, those inside first.
    [[nodiscard]] static Corners inside_first(CellHandle cell)
    {
        Corners corners{{0, 1, 2, 3}, 0};
        bool odd = false;
        for (std::size_t i = 0; i < 4; ++i)
            if (is_inside(cell->vertex(corners.corner[i])))
            {
                odd ^= corners.inside != i;
                std::swap(corners.corner[corners.inside++], corners.corner[i]);
            }
        const std::size_t of_one_side = corners.inside == 3 ? 0 : 2;
        if (odd)
            std::swap(corners.corner[of_one_side], corners.corner[of_one_side + 1]);
        return corners;
    }

    void add(CellHandle cell)
    {
        const auto [order, inside] = inside_first(cell);
        const auto point = [&, &order = order](std::size_t a, std::size_t b)
        { return crossing(cell->vertex(order[a]), cell->vertex(order[b])); };
        if (inside == 1)
            mesh_.faces.push_back({point(0, 1), point(0, 2), point(0, 3)});
        if (inside == 3)
            mesh_.faces.push_back({point(0, 3), point(1, 3), point(2, 3)});
        if (inside == 2)
        {
            const auto a = point(0, 2);
            const auto b = point(0, 3);
            const auto c = point(1, 3);
            const auto d = point(1, 2);
            mesh_.faces.push_back({a, b, c});
            mesh_.faces.push_back({a, c, d});
        }
    }

    //! What is inside of a facet of the convex hull: the object ends there. Seen from outside the corners run
    //! counter-clockwise.
    void add_cap(CellHandle cell, int infinite)
    {
        std::vector<std::uint32_t> polygon;
        for (int i = 0; i < 3; ++i)
        {
            const VertexHandle here = cell->vertex(Triangulation::vertex_triple_index(infinite, i));
            const VertexHandle next = cell->vertex(Triangulation::vertex_triple_index(infinite, (i + 1) % 3));
            if (is_inside(here))
                polygon.push_back(crossing(here, here));
            if (is_inside(here) != is_inside(next))
                polygon.push_back(is_inside(here) ? crossing(here, next) : crossing(next, here));
        }
        for (std::size_t i = 2; i < polygon.size(); ++i)
            mesh_.faces.push_back({polygon[0], polygon[i - 1], polygon[i]});
    }

    //! The vertex where the function is zero along an edge of the triangulation; the end where both are one.
    std::uint32_t crossing(VertexHandle inside, VertexHandle outside)
    {
        const auto [entry, is_new] =
            crossings_.try_emplace({inside, outside}, static_cast<std::uint32_t>(mesh_.vertices.size()));
        if (is_new)
        {
            const double t = inside == outside ? 0.0 : inside->f() / (inside->f() - outside->f());
            const auto p = inside->point() + t * (outside->point() - inside->point());
            mesh_.vertices.push_back({p.x(), p.y(), p.z()});
        }
        return entry->second;
    }

    TriangleMesh mesh_;
    std::map<std::pair<VertexHandle, VertexHandle>, std::uint32_t>
        crossings_; //!< only looked up, never walked
};

} // namespace

TriangleMesh fit_point_cloud(std::span<const OrientedPoint> points, const std::string& name)
{
    std::vector<PointWithNormal> checked = checked_points(points, name);
    if (are_coplanar(checked))
        throw InputError("the points of " + name + " lie in one plane; they must surround an object");
    jitter(checked);
    const SilentErrorStream silent;
    Poisson function(checked.begin(), checked.end(), CGAL::First_of_pair_property_map<PointWithNormal>(),
                     CGAL::Second_of_pair_property_map<PointWithNormal>());
    if (!function.compute_implicit_function(Solver()))
        throw InputError("the Poisson equation of " + name +
                         " has no solution; its normals must point outward");
    TriangleMesh mesh = ZeroSet(function.tr()).take();
    if (mesh.faces.empty())
        throw InputError("the fit to " + name + " has no inside; its normals must point outward");
    return mesh;
}

std::unique_ptr<SurfaceOracle> make_point_cloud_oracle(std::span<const OrientedPoint> points,
                                                       const std::string& name)
{
    return make_triangle_mesh_oracle(fit_point_cloud(points, name), "the fit to " + name,
                                     MeshChecks::kClosed);
}

} // namespace voroprobe
