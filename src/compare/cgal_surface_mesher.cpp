// CGAL's Surface_mesher (Rineau & Yvinec 2007; last in CGAL 5.5) on the trilinear interpolant of the volume.
#include <cmath>
#include <map>
#include <optional>

#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh_default_criteria_3.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>

#include "compare/contestant.h"
#include "compare/peer_field.h"

namespace voroprobe
{

namespace
{

using Triangulation = CGAL::Surface_mesh_default_triangulation_3;
using Complex = CGAL::Complex_2_in_triangulation_3<Triangulation>;
using Kernel = Triangulation::Geom_traits;

constexpr std::size_t kSeedsPerRegion = 20; // as many as CGAL's scan for Mesh_3 shoots rays

//! -1 inside and +1 outside the isosurface of the trilinear interpolant; the mesher looks at signs only.
class TrilinearSide
{
public:
    explicit TrilinearSide(const PeerField& field) : field_(&field) {}

    double operator()(const Kernel::Point_3& p) const
    {
        const auto value = interpolate({p.x(), p.y(), p.z()});
        return value && *value >= field_->isovalue ? -1.0 : 1.0;
    }

private:
    [[nodiscard]] std::optional<double> interpolate(const Point3& p) const // the field begins at the origin
    {
        const auto& n = field_->size;
        std::array<std::size_t, 3> at{};
        std::array<double, 3> t{};
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            const double index = p[axis] / field_->spacing[axis];
            if (!(index >= 0.0 && index <= static_cast<double>(n[axis] - 1)))
                return std::nullopt;
            at[axis] = std::min(static_cast<std::size_t>(index), n[axis] - 2);
            t[axis] = index - static_cast<double>(at[axis]);
        }
        const float* corner = field_->samples.data() + at[0] + n[0] * (at[1] + n[1] * at[2]);
        const auto along_x = [&](std::size_t offset)
        { return (1.0 - t[0]) * corner[offset] + t[0] * corner[offset + 1]; };
        const auto along_xy = [&](std::size_t offset)
        { return (1.0 - t[1]) * along_x(offset) + t[1] * along_x(offset + n[0]); };
        return (1.0 - t[2]) * along_xy(0) + t[2] * along_xy(n[0] * n[1]);
    }

    const PeerField* field_;
};

using Surface = CGAL::Implicit_surface_3<Kernel, TrilinearSide>;

Kernel::Sphere_3 bounding_sphere(const Box3& box)
{
    constexpr double kMargin = 1.01; // the surface has to lie inside, caps on the border included
    const Point3 center = box.center();
    const double radius = kMargin * 0.5 * box.diagonal();
    return {Kernel::Point_3(center.x, center.y, center.z), radius * radius};
}

class SurfaceMesher final : public Contestant
{
public:
    SurfaceMesher(const MeshingTask& task, FirstPoints points)
        : task_(task), points_(points), field_(make_peer_field(task))
    {
    }

    void mesh(StageClock& clock) override
    {
        CGAL::get_default_random() = CGAL::Random(kRandomSeed);
        if (points_ == FirstPoints::kSeeded)
        {
            clock.begin("seeds");
            for (const Point3& p : seeds_on_every_region(field_, kSeedsPerRegion))
                triangulation_.insert(Kernel::Point_3(p.x, p.y, p.z));
        }
        clock.begin("refinement");
        const Surface surface(TrilinearSide(field_), bounding_sphere(field_.border), task_.peer_error_bound);
        const CGAL::Surface_mesh_default_criteria_3<Triangulation> criteria(
            task_.min_facet_angle_deg, task_.max_facet_radius, task_.max_facet_distance);
        CGAL::make_surface_mesh(complex_, surface, criteria, CGAL::Non_manifold_tag());
    }

    [[nodiscard]] TriangleMesh result() const override
    {
        TriangleMesh mesh;
        std::map<Triangulation::Vertex_handle, std::uint32_t> number_of_vertex;
        for (auto facet = complex_.facets_begin(); facet != complex_.facets_end(); ++facet)
        {
            TriangleMesh::Face face{};
            for (int corner = 0; corner < 3; ++corner)
            {
                const auto vertex =
                    facet->first->vertex(Triangulation::vertex_triple_index(facet->second, corner));
                const auto [entry, is_new] =
                    number_of_vertex.try_emplace(vertex, static_cast<std::uint32_t>(mesh.vertices.size()));
                if (is_new)
                    mesh.vertices.push_back({vertex->point().x(), vertex->point().y(), vertex->point().z()});
                face[static_cast<std::size_t>(corner)] = entry->second;
            }
            if (is_inside(facet->first)) // the triple runs counter-clockwise seen from within its cell
                std::swap(face[1], face[2]);
            mesh.faces.push_back(face);
        }
        return mesh;
    }

private:
    //! Of the two cells of a facet one is inside, by their circumcenters, where the surface crosses between
    //! them once.
    [[nodiscard]] bool is_inside(const Triangulation::Cell_handle& cell) const
    {
        return !triangulation_.is_infinite(cell) && TrilinearSide(field_)(triangulation_.dual(cell)) < 0.0;
    }

    MeshingTask task_;
    FirstPoints points_;
    PeerField field_;
    Triangulation triangulation_;
    Complex complex_{triangulation_};
};

} // namespace

std::unique_ptr<Contestant> make_surface_mesher(const MeshingTask& task, FirstPoints points)
{
    return std::make_unique<SurfaceMesher>(task, points);
}

} // namespace voroprobe
