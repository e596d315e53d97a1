#include "mesher/rim.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace voroprobe
{
namespace
{

using Face = TriangleMesh::Face;

//! Halvings of an edge: the rim is found to within a 60,000th of it, less than binary STL can tell.
constexpr int kHalvings = 16;

//! An end within this share of its edge from the rim moves there. Against slivers, as in Labelle & Shewchuk,
//! Isosurface Stuffing, 2007, which has 0.25 to 0.41.
constexpr double kNearRim = 0.3;

//! An edge from a cap to the surface: its vertices.
struct CapEdge
{
    std::uint32_t cap;
    std::uint32_t proper;

    friend auto operator<=>(const CapEdge&, const CapEdge&) = default;
};

//! Where the rim passes an edge.
struct RimPoint
{
    Vec3 out;                                           //!< of the faces of the edge, not normalized
    double share = 0.0;                                 //!< of the edge, from its cap
    Point3 on_edge = {};                                //!< at this share, on the closed mesh
    Point3 on_rim = {};                                 //!< across from it, on the border
    std::optional<std::uint32_t> vertex = std::nullopt; //!< that divides the edge
};

class RimCut
{
public:
    RimCut(CapFinder& caps, CappedMesh& capped) : caps_(caps), capped_(capped) {}

    void run()
    {
        collect_edges();
        for (auto& [edge, point] : rim_)
            find_rim(edge, point);
        draw_ends_to_rim(SurfacePart::kProper);
        draw_ends_to_rim(SurfacePart::kCap);
        keep_proper_parts();
    }

private:
    //! The edge between corners k and k + 1, if it leads from a cap to the surface.
    [[nodiscard]] std::optional<CapEdge> cap_edge(const Face& face, std::size_t k) const
    {
        const std::uint32_t a = face[k];
        const std::uint32_t b = face[(k + 1) % 3];
        if (part(a) == SurfacePart::kCap && part(b) == SurfacePart::kProper)
            return CapEdge{a, b};
        if (part(a) == SurfacePart::kProper && part(b) == SurfacePart::kCap)
            return CapEdge{b, a};
        return std::nullopt;
    }

    void collect_edges()
    {
        for (const Face& face : mesh().faces)
        {
            const Point3 a = mesh().corner(face, 0);
            const Vec3 out = normalized(cross(mesh().corner(face, 1) - a, mesh().corner(face, 2) - a));
            for (std::size_t k = 0; k < 3; ++k)
                if (const auto edge = cap_edge(face, k))
                    rim_[*edge].out += out;
        }
    }

    //! Across its ends lie a cap and the surface.
    void find_rim(const CapEdge& edge, RimPoint& point)
    {
        const Point3 cap = mesh().vertices[edge.cap];
        const Vec3 along = mesh().vertices[edge.proper] - cap;
        const Vec3 out = normalized(point.out);
        const double reach = norm(along);
        point.on_rim = cap;
        double beyond = 1.0;
        for (int i = 0; i < kHalvings; ++i)
        {
            const double share = 0.5 * (point.share + beyond);
            const auto crossing = caps_.nearest(cap + share * along, out, reach);
            if (crossing && crossing->on_border)
            {
                point.share = share;
                point.on_rim = crossing->point;
            }
            else
                beyond = share;
        }
        const Point3 from = capped_.place_on_it[edge.cap];
        point.on_edge = from + point.share * (capped_.place_on_it[edge.proper] - from);
    }

    //! Moves the vertices of a part that an edge not divided yet has near the rim, each to the nearest point.
    void draw_ends_to_rim(SurfacePart of)
    {
        std::map<std::uint32_t, Point3> targets;
        for (const auto& [edge, point] : rim_)
        {
            if (part(edge.cap) != SurfacePart::kCap || part(edge.proper) != SurfacePart::kProper)
                continue;
            const std::uint32_t end = of == SurfacePart::kCap ? edge.cap : edge.proper;
            if ((of == SurfacePart::kCap ? point.share : 1.0 - point.share) > kNearRim)
                continue;
            const Point3 from = mesh().vertices[end];
            Point3& target = targets.try_emplace(end, point.on_rim).first->second;
            if (squared_distance(from, point.on_rim) < squared_distance(from, target))
                target = point.on_rim;
        }
        const auto neighbors = proper_neighbors(targets);
        for (const auto& [end, target] : targets)
        {
            if (of == SurfacePart::kProper && !has_proper(neighbors, end))
                continue;
            mesh().vertices[end] = target;
            capped_.part[end] = SurfacePart::kRim;
        }
    }

    using Neighbors = std::map<std::uint32_t, std::vector<std::uint32_t>>;

    //! Of the vertices to be moved those neighbors that are of the surface.
    [[nodiscard]] Neighbors proper_neighbors(const std::map<std::uint32_t, Point3>& targets) const
    {
        Neighbors neighbors;
        for (const Face& face : capped_.mesh.faces)
            for (std::size_t k = 0; k < 3; ++k)
                if (part(face[k]) == SurfacePart::kProper && targets.contains(face[k]))
                    for (const std::size_t other : {(k + 1) % 3, (k + 2) % 3})
                        if (part(face[other]) == SurfacePart::kProper)
                            neighbors[face[k]].push_back(face[other]);
        return neighbors;
    }

    //! Whether one is left: the last vertex of a small part stays, or the part would be lost.
    [[nodiscard]] bool has_proper(const Neighbors& neighbors, std::uint32_t vertex) const
    {
        const auto found = neighbors.find(vertex);
        return found != neighbors.end() &&
               std::any_of(found->second.begin(), found->second.end(),
                           [&](std::uint32_t other) { return part(other) == SurfacePart::kProper; });
    }

    [[nodiscard]] std::uint32_t dividing_vertex(const CapEdge& edge)
    {
        RimPoint& point = rim_.at(edge);
        if (!point.vertex)
            point.vertex = capped_.add_vertex(point.on_rim, point.on_edge, SurfacePart::kRim);
        return *point.vertex;
    }

    //! The corners of the part of a face that does not lie on a cap: three or four.
    [[nodiscard]] std::vector<std::uint32_t> proper_part(const Face& face)
    {
        std::vector<std::uint32_t> corners;
        for (std::size_t k = 0; k < 3; ++k)
        {
            if (part(face[k]) != SurfacePart::kCap)
                corners.push_back(face[k]);
            if (const auto edge = cap_edge(face, k))
                corners.push_back(dividing_vertex(*edge));
        }
        return corners;
    }

    [[nodiscard]] std::size_t corners_of(const Face& face, SurfacePart wanted) const
    {
        return static_cast<std::size_t>(std::count_if(
            face.begin(), face.end(), [&](std::uint32_t vertex) { return part(vertex) == wanted; }));
    }

    void keep_proper_parts()
    {
        const std::vector<Face> faces = std::exchange(mesh().faces, {});
        const std::vector<SurfaceId> surfaces = std::exchange(capped_.surface_of_face, {});
        for (std::size_t f = 0; f < faces.size(); ++f)
        {
            if (corners_of(faces[f], SurfacePart::kProper) > 0)
                add_polygon(proper_part(faces[f]), surfaces[f]);
            else if (corners_of(faces[f], SurfacePart::kRim) == 3)
                add_over_dent(faces[f], surfaces[f]);
        }
    }

    //! A face from rim to rim goes, unless the surface lies across it: then it is drawn there.
    void add_over_dent(const Face& face, SurfaceId surface)
    {
        const auto crossing = crossing_across(mesh(), face, caps_);
        if (!crossing || crossing->on_border)
            return;
        const auto& places = capped_.place_on_it;
        const Point3 place = (places[face[0]] + places[face[1]] + places[face[2]]) / 3.0;
        const std::uint32_t middle = capped_.add_vertex(crossing->point, place, SurfacePart::kProper);
        for (std::size_t k = 0; k < 3; ++k)
            add_polygon({face[k], face[(k + 1) % 3], middle}, surface);
    }

    //! Of four corners, divided along the shorter diagonal.
    void add_polygon(const std::vector<std::uint32_t>& corners, SurfaceId surface)
    {
        const auto at = [&](std::size_t i) { return mesh().vertices[corners[i % corners.size()]]; };
        const std::size_t first =
            corners.size() == 4 && squared_distance(at(1), at(3)) < squared_distance(at(0), at(2)) ? 1 : 0;
        for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        {
            mesh().faces.push_back({corners[first], corners[(first + i) % corners.size()],
                                    corners[(first + i + 1) % corners.size()]});
            capped_.surface_of_face.push_back(surface);
        }
    }

    [[nodiscard]] TriangleMesh& mesh() { return capped_.mesh; }
    [[nodiscard]] SurfacePart part(std::uint32_t vertex) const { return capped_.part[vertex]; }

    CapFinder& caps_;
    CappedMesh& capped_;
    std::map<CapEdge, RimPoint> rim_;
};

} // namespace

void cut_along_rim(CapFinder& caps, CappedMesh& capped)
{
    RimCut(caps, capped).run();
}

} // namespace voroprobe
