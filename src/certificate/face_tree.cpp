#include "certificate/face_tree.h"

#include <cmath>
#include <limits>
#include <utility>

#include "certificate/space_order.h"
#include "geometry/point_triangle.h"

namespace voroprobe
{
namespace
{

std::vector<std::uint32_t> faces_in_space_order(const TriangleMesh& mesh)
{
    std::vector<Point3> centers;
    centers.reserve(mesh.faces.size());
    for (const TriangleMesh::Face& face : mesh.faces)
        centers.push_back(mesh.corner(face, 0) + mesh.corner(face, 1) + mesh.corner(face, 2));
    return order_in_space(centers);
}

double squared_distance_to_box(const Point3& p, const Box3& box)
{
    double squared = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const double beyond = std::max({box.min[axis] - p[axis], 0.0, p[axis] - box.max[axis]});
        squared += beyond * beyond;
    }
    return squared;
}

} // namespace

FaceTree::FaceTree(const TriangleMesh& mesh) : mesh_(mesh), faces_(faces_in_space_order(mesh))
{
    std::vector<Box3> boxes(faces_.size());
    for (std::size_t place = 0; place < faces_.size(); ++place)
        for (const std::uint32_t v : mesh.faces[faces_[place]])
            boxes[place].include(mesh.vertices[v]);
    while (boxes.size() > 1)
    {
        std::vector<Box3> around((boxes.size() + kArity - 1) / kArity);
        for (std::size_t place = 0; place < boxes.size(); ++place)
        {
            around[place / kArity].include(boxes[place].min);
            around[place / kArity].include(boxes[place].max);
        }
        levels_.push_back(std::exchange(boxes, std::move(around)));
    }
    levels_.push_back(std::move(boxes));
}

double FaceTree::distance(const Point3& p) const
{
    double nearest = std::numeric_limits<double>::infinity();
    if (!faces_.empty())
        look_for_nearer(root(), p, nearest);
    return std::sqrt(nearest);
}

void FaceTree::look_for_nearer(Node node, const Point3& p, double& squared) const
{
    if (node.level == 0)
    {
        const TriangleMesh::Face& face = mesh_.faces[faces_[node.place]];
        squared =
            std::min(squared, squared_distance_to_triangle(
                                  p, {mesh_.corner(face, 0), mesh_.corner(face, 1), mesh_.corner(face, 2)}));
        return;
    }
    std::array<std::pair<double, std::size_t>, kArity> children;
    std::size_t count = 0;
    for (std::size_t child = first_child(node); child < end_of_children(node); ++child)
        children[count++] = {squared_distance_to_box(p, levels_[node.level - 1][child]), child};
    std::sort(children.begin(), children.begin() + count);
    for (std::size_t i = 0; i < count && children[i].first < squared; ++i)
        look_for_nearer({node.level - 1, children[i].second}, p, squared);
}

} // namespace voroprobe
