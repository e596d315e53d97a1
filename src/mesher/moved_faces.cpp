#include "mesher/moved_faces.h"

#include <cstdint>
#include <utility>

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

class MovedFaces
{
public:
    MovedFaces(const std::vector<Point3>& places, TriangleMesh& mesh)
        : places_(places), mesh_(mesh), is_changed_(mesh.faces.size())
    {
        for (std::size_t f = 0; f < mesh.faces.size(); ++f)
            is_changed_[f] = is_moved(mesh.faces[f]);
    }

    void settle()
    {
        while (put_back(vertices_to_put_back()))
        {
        }
    }

private:
    [[nodiscard]] bool is_moved(std::uint32_t vertex) const
    {
        return mesh_.vertices[vertex] != places_[vertex];
    }

    [[nodiscard]] bool is_moved(const Face& face) const
    {
        return is_moved(face[0]) || is_moved(face[1]) || is_moved(face[2]);
    }

    //! Those of the crossing faces that are moved.
    [[nodiscard]] std::vector<bool> vertices_to_put_back() const
    {
        std::vector<bool> found(mesh_.vertices.size(), false);
        const auto find = [&](const Face& face)
        {
            for (const std::uint32_t vertex : face)
                found[vertex] = found[vertex] || is_moved(vertex);
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

    //! Whether there were any. The faces at them are looked at next.
    bool put_back(const std::vector<bool>& vertices)
    {
        bool any = false;
        for (std::size_t v = 0; v < vertices.size(); ++v)
        {
            if (vertices[v])
                mesh_.vertices[v] = places_[v];
            any = any || vertices[v];
        }
        for (std::size_t f = 0; f < mesh_.faces.size(); ++f)
        {
            const Face& face = mesh_.faces[f];
            is_changed_[f] = vertices[face[0]] || vertices[face[1]] || vertices[face[2]];
        }
        return any;
    }

    const std::vector<Point3>& places_;
    TriangleMesh& mesh_;
    std::vector<bool> is_changed_; //!< by face: since crossings were last looked for
};

} // namespace

void put_back_where_faces_cross(const std::vector<Point3>& places, TriangleMesh& mesh)
{
    MovedFaces(places, mesh).settle();
}

} // namespace voroprobe
