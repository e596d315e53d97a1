#include "mesher/face_settling.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include "mesher/face_crossings.h"

namespace voroprobe
{
namespace
{

using Face = TriangleMesh::Face;
using FaceBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

FaceBox box_of(const TriangleMesh& mesh, std::uint32_t f)
{
    CGAL::Bbox_3 box;
    for (const std::uint32_t vertex : mesh.faces[f])
    {
        const Point3& p = mesh.vertices[vertex];
        box += CGAL::Bbox_3(p.x, p.y, p.z, p.x, p.y, p.z);
    }
    return {box, f};
}

bool has_area(const TriangleMesh& mesh, const Face& face)
{
    const Point3 a = mesh.corner(face, 0);
    return squared_norm(cross(mesh.corner(face, 1) - a, mesh.corner(face, 2) - a)) > 0.0;
}

class FaceSettling
{
public:
    FaceSettling(OtherPlaces places, TriangleMesh& mesh) : mesh_(mesh), is_changed_(mesh.faces.size(), false)
    {
        next_.resize(mesh.vertices.size());
        for (auto& [vertex, others] : places)
            next_[vertex].assign(others.rbegin(), others.rend());
        for (std::size_t f = 0; f < mesh.faces.size(); ++f)
            is_changed_[f] = std::any_of(mesh.faces[f].begin(), mesh.faces[f].end(),
                                         [&](std::uint32_t vertex) { return !next_[vertex].empty(); });
    }

    void run()
    {
        while (move_on(vertices_of_crossing_faces()))
        {
        }
    }

private:
    //! By vertex. Only faces that have changed are held against the others.
    [[nodiscard]] std::vector<bool> vertices_of_crossing_faces() const
    {
        std::vector<bool> found(mesh_.vertices.size(), false);
        if (std::find(is_changed_.begin(), is_changed_.end(), true) == is_changed_.end())
            return found;
        const auto find = [&](const Face& face)
        {
            for (const std::uint32_t vertex : face)
                found[vertex] = true;
        };
        std::vector<FaceBox> all;
        std::vector<FaceBox> changed;
        for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f)
        {
            if (!has_area(mesh_, mesh_.faces[f]))
            {
                find(mesh_.faces[f]);
                continue;
            }
            all.push_back(box_of(mesh_, f));
            if (is_changed_[f])
                changed.push_back(all.back());
        }
        CGAL::box_intersection_d(changed.begin(), changed.end(), all.begin(), all.end(),
                                 [&](const FaceBox& a, const FaceBox& b)
                                 {
                                     const Face& f = mesh_.faces[a.info()];
                                     const Face& g = mesh_.faces[b.info()];
                                     if (a.info() == b.info() || !faces_cross(mesh_, f, g))
                                         return;
                                     find(f);
                                     find(g);
                                 });
        return found;
    }

    //! Each of these to the next of its places; returns whether one had any.
    bool move_on(const std::vector<bool>& vertices)
    {
        std::vector<bool> moved(vertices.size(), false);
        for (std::size_t v = 0; v < vertices.size(); ++v)
        {
            if (!vertices[v] || next_[v].empty())
                continue;
            mesh_.vertices[v] = next_[v].back();
            next_[v].pop_back();
            moved[v] = true;
        }
        for (std::size_t f = 0; f < mesh_.faces.size(); ++f)
        {
            const Face& face = mesh_.faces[f];
            is_changed_[f] = moved[face[0]] || moved[face[1]] || moved[face[2]];
        }
        return std::find(moved.begin(), moved.end(), true) != moved.end();
    }

    TriangleMesh& mesh_;
    std::vector<std::vector<Point3>> next_; //!< by vertex: its other places, the last one first
    std::vector<bool> is_changed_;          //!< by face: since crossings were last looked for
};

} // namespace

void settle_crossing_faces(OtherPlaces places, TriangleMesh& mesh)
{
    if (!places.empty())
        FaceSettling(std::move(places), mesh).run();
}

} // namespace voroprobe
