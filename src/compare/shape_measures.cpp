#include "compare/shape_measures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/measures.h"

namespace voroprobe
{

namespace
{

struct Sides
{
    double shortest;
    double longest;
    double sum;
};

Sides sides_of(const Point3& a, const Point3& b, const Point3& c)
{
    const double ab = distance(a, b);
    const double bc = distance(b, c);
    const double ca = distance(c, a);
    return {std::min({ab, bc, ca}), std::max({ab, bc, ca}), ab + bc + ca};
}

//! Sums over faces with area.
class RatioSums
{
public:
    void add(const Point3& a, const Point3& b, const Point3& c)
    {
        const Sides sides = sides_of(a, b, c);
        edge_length_ += sides.sum;
        const double area = 0.5 * norm(cross(b - a, c - a));
        if (!(area > 0.0))
        {
            ++flat_;
            return;
        }
        ++count_;
        const double product = distance(a, b) * distance(b, c) * distance(c, a);
        const double radius_edge = product / (4.0 * area) / sides.shortest;
        const double aspect = sides.longest * sides.sum / (2.0 * area) / (2.0 * std::sqrt(3.0));
        radius_edge_ += radius_edge;
        max_radius_edge_ = std::max(max_radius_edge_, radius_edge);
        aspect_ += aspect;
        max_aspect_ = std::max(max_aspect_, aspect);
    }

    void tell(ShapeMeasures& shapes) const
    {
        const auto count = static_cast<double>(std::max<std::size_t>(count_, 1));
        shapes.mean_radius_edge_ratio = radius_edge_ / count;
        shapes.max_radius_edge_ratio = max_radius_edge_;
        shapes.mean_aspect_ratio = aspect_ / count;
        shapes.max_aspect_ratio = max_aspect_;
        shapes.mean_edge_length =
            edge_length_ / (3.0 * static_cast<double>(std::max<std::size_t>(count_ + flat_, 1)));
        shapes.flat_faces = flat_;
    }

private:
    std::size_t count_ = 0;
    std::size_t flat_ = 0;
    double edge_length_ = 0.0;
    double radius_edge_ = 0.0;
    double max_radius_edge_ = 0.0;
    double aspect_ = 0.0;
    double max_aspect_ = 0.0;
};

void count_valences(const TriangleMesh& mesh, ShapeMeasures& shapes)
{
    std::vector<std::size_t> faces_around(mesh.vertices.size(), 0);
    for (const TriangleMesh::Face& face : mesh.faces)
        for (const std::uint32_t vertex : face)
            ++faces_around[vertex];
    for (const std::size_t count : faces_around)
        ++shapes.vertices_by_valence[std::min(count, shapes.vertices_by_valence.size() - 1)];
}

} // namespace

ShapeMeasures measure_shapes(const TriangleMesh& mesh)
{
    ShapeMeasures shapes;
    RatioSums sums;
    for (const TriangleMesh::Face& face : mesh.faces)
    {
        const Point3 a = mesh.corner(face, 0);
        const Point3 b = mesh.corner(face, 1);
        const Point3 c = mesh.corner(face, 2);
        sums.add(a, b, c);
        const auto angles = triangle_angles_deg(a, b, c);
        shapes.smallest_angles.add(*std::min_element(angles.begin(), angles.end()));
        for (const double angle : angles)
            shapes.angles.add(angle);
    }
    sums.tell(shapes);
    count_valences(mesh, shapes);
    return shapes;
}

} // namespace voroprobe
