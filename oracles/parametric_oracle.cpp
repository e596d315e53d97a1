#include "oracles/parametric_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "oracles/triangle_mesh_oracle.h"
#include "support/error.h"
#include "support/number_text.h"

namespace voroprobe
{
namespace
{

//! Steps of the first lattice along each side.
constexpr std::size_t kFirstSteps = 16;

//! More points than this are refused: some 2 GB of triangles and tree.
constexpr std::size_t kMostPoints = std::size_t{1} << 22;

//! A side is one point where it is shorter than this fraction of the surface's diagonal: far above the
//! rounding of a pole, far below any size that could be meant.
constexpr double kPointSize = 1e-9;

double distance_to_segment(const Point3& p, const Point3& a, const Point3& b)
{
    const Vec3 along = b - a;
    const double squared_length = squared_norm(along);
    const double t = squared_length > 0.0 ? std::clamp(dot(p - a, along) / squared_length, 0.0, 1.0) : 0.0;
    return distance(p, a + t * along);
}

//! The surface's points on a lattice of (u steps) x (v steps) over the square.
class Lattice
{
public:
    Lattice(const ParametricSurface& surface, std::array<std::size_t, 2> steps)
        : surface_(surface), steps_(steps)
    {
        points_.reserve((steps[0] + 1) * (steps[1] + 1));
        for (std::size_t j = 0; j <= steps[1]; ++j)
            for (std::size_t i = 0; i <= steps[0]; ++i)
                points_.push_back(at(static_cast<double>(i), static_cast<double>(j)));
    }

    //! Largest distances of the surface from middles of edges.
    struct Deviation
    {
        double along_u = 0.0;
        double along_v = 0.0;
        double diagonal = 0.0;
    };

    [[nodiscard]] Deviation deviation() const
    {
        Deviation worst;
        const auto include = [](double& most, double value) { most = std::max(most, value); };
        for (std::size_t j = 0; j < steps_[1]; ++j)
            for (std::size_t i = 0; i < steps_[0]; ++i)
            {
                const double u = static_cast<double>(i);
                const double v = static_cast<double>(j);
                const Point3& here = point(i, j);
                include(worst.along_u, distance_to_segment(at(u + 0.5, v), here, point(i + 1, j)));
                include(worst.along_v, distance_to_segment(at(u, v + 0.5), here, point(i, j + 1)));
                include(worst.diagonal, distance_to_segment(at(u + 0.5, v + 0.5), here, point(i + 1, j + 1)));
            }
        return worst;
    }

    [[nodiscard]] TriangleMesh triangles() const
    {
        TriangleMesh mesh{.vertices = points_, .faces = {}};
        const std::vector<std::uint32_t> vertex = representatives();
        const auto add = [&](std::size_t a, std::size_t b, std::size_t c)
        {
            const TriangleMesh::Face face{vertex[a], vertex[b], vertex[c]};
            if (face[0] != face[1] && face[1] != face[2] && face[2] != face[0])
                mesh.faces.push_back(face);
        };
        for (std::size_t j = 0; j < steps_[1]; ++j)
            for (std::size_t i = 0; i < steps_[0]; ++i)
            {
                add(index(i, j), index(i + 1, j), index(i + 1, j + 1));
                add(index(i, j), index(i + 1, j + 1), index(i, j + 1));
            }
        return mesh;
    }

private:
    //! Where a joined direction ends it begins anew.
    [[nodiscard]] Point3 at(double i, double j) const
    {
        double u = i / static_cast<double>(steps_[0]);
        double v = j / static_cast<double>(steps_[1]);
        u = surface_.joined_in_u && u == 1.0 ? 0.0 : u;
        v = surface_.joined_in_v && v == 1.0 ? 0.0 : v;
        const Point3 p = surface_.point(u, v);
        if (!is_finite(p))
            throw UsageError("the parametric surface is not finite at u = " + number_text(u) +
                             ", v = " + number_text(v) + "; it must be, all over [0, 1]^2");
        return p;
    }

    [[nodiscard]] std::size_t index(std::size_t i, std::size_t j) const { return i + j * (steps_[0] + 1); }
    [[nodiscard]] const Point3& point(std::size_t i, std::size_t j) const { return points_[index(i, j)]; }

    //! For each lattice point the one that stands for it: joined sides share their points, and a side that is
    //! one point has one.
    [[nodiscard]] std::vector<std::uint32_t> representatives() const
    {
        const auto [nu, nv] = steps_;
        std::vector<std::uint32_t> vertex(points_.size());
        for (std::size_t j = 0; j <= nv; ++j)
            for (std::size_t i = 0; i <= nu; ++i)
                vertex[index(i, j)] = static_cast<std::uint32_t>(
                    index(surface_.joined_in_u ? i % nu : i, surface_.joined_in_v ? j % nv : j));
        for (const std::size_t j : {std::size_t{0}, nv})
            unite(vertex, index(0, j), 1, nu + 1);
        for (const std::size_t i : {std::size_t{0}, nu})
            unite(vertex, index(i, 0), nu + 1, nv + 1);
        return vertex;
    }

    //! Makes one of `count` points from `first` on, if they are one.
    void unite(std::vector<std::uint32_t>& vertex, std::size_t first, std::size_t stride,
               std::size_t count) const
    {
        Box3 box;
        for (std::size_t k = 0; k < count; ++k)
            box.include(points_[first + k * stride]);
        if (box.diagonal() > kPointSize * diagonal())
            return;
        for (std::size_t k = 0; k < count; ++k)
            vertex[first + k * stride] = vertex[first];
    }

    [[nodiscard]] double diagonal() const
    {
        Box3 box;
        for (const Point3& p : points_)
            box.include(p);
        return box.diagonal();
    }

    const ParametricSurface& surface_;
    std::array<std::size_t, 2> steps_;
    std::vector<Point3> points_; //!< u fastest, both ends included
};

TriangleMesh without_unused_vertices(const TriangleMesh& mesh)
{
    constexpr std::uint32_t kUnused = 0xffffffff;
    std::vector<std::uint32_t> new_index(mesh.vertices.size(), kUnused);
    TriangleMesh used;
    for (TriangleMesh::Face face : mesh.faces)
    {
        for (std::uint32_t& corner : face)
        {
            if (new_index[corner] == kUnused)
            {
                new_index[corner] = static_cast<std::uint32_t>(used.vertices.size());
                used.vertices.push_back(mesh.vertices[corner]);
            }
            corner = new_index[corner];
        }
        used.faces.push_back(face);
    }
    return used;
}

} // namespace

TriangleMesh tessellate(const ParametricSurface& surface, double tolerance)
{
    if (!surface.point)
        throw UsageError("the parametric surface has no function");
    if (!(tolerance > 0.0) || !std::isfinite(tolerance))
        throw UsageError("the tolerance of a parametric surface is " + number_text(tolerance) +
                         "; it must be finite and above 0");
    std::array<std::size_t, 2> steps{kFirstSteps, kFirstSteps};
    while (steps[0] * steps[1] <= kMostPoints)
    {
        const Lattice lattice(surface, steps);
        const Lattice::Deviation deviation = lattice.deviation();
        const bool refine_u = deviation.along_u > tolerance;
        const bool refine_v = deviation.along_v > tolerance;
        const bool refine_both = !refine_u && !refine_v && deviation.diagonal > tolerance;
        if (!refine_u && !refine_v && !refine_both)
            return without_unused_vertices(lattice.triangles());
        steps[0] *= refine_u || refine_both ? 2 : 1;
        steps[1] *= refine_v || refine_both ? 2 : 1;
    }
    throw UsageError("the tolerance of a parametric surface is " + number_text(tolerance) +
                     "; this surface would take more than " + std::to_string(kMostPoints) +
                     " points, so it must be larger");
}

std::unique_ptr<SurfaceOracle> make_parametric_oracle(const ParametricSurface& surface, double tolerance)
{
    return make_triangle_mesh_oracle(tessellate(surface, tolerance), "the parametric surface");
}

} // namespace voroprobe
