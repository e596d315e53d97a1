#include "postprocess/bodies.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace voroprobe
{

namespace
{

using Face = TriangleMesh::Face;

bool contains(const Box3& outer, const Box3& inner)
{
    return outer.contains(inner.min) && outer.contains(inner.max);
}

//! Faces by piece, and the corner to look from.
class PieceFaces
{
public:
    PieceFaces(const TriangleMesh& mesh, const MeshPieces& pieces) : mesh_(mesh), faces_(pieces.pieces.size())
    {
        for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
            faces_[pieces.piece_of_face[f]].push_back(f);
    }

    [[nodiscard]] Point3 a_point_of(std::uint32_t piece) const
    {
        return mesh_.corner(mesh_.faces[faces_[piece].front()], 0);
    }

    //! How often a piece winds around a point: 1 inside of a shell. Source: van Oosterom & Strackee 1983.
    [[nodiscard]] double winding(std::uint32_t piece, const Point3& p) const
    {
        double half_angle = 0.0;
        for (const std::uint32_t f : faces_[piece])
        {
            const Vec3 a = mesh_.corner(mesh_.faces[f], 0) - p;
            const Vec3 b = mesh_.corner(mesh_.faces[f], 1) - p;
            const Vec3 c = mesh_.corner(mesh_.faces[f], 2) - p;
            const double la = norm(a);
            const double lb = norm(b);
            const double lc = norm(c);
            half_angle += std::atan2(dot(a, cross(b, c)),
                                     la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
        }
        return half_angle / (2.0 * std::numbers::pi);
    }

    [[nodiscard]] const std::vector<std::uint32_t>& of(std::uint32_t piece) const { return faces_[piece]; }

private:
    const TriangleMesh& mesh_;
    std::vector<std::vector<std::uint32_t>> faces_;
};

std::optional<std::size_t> shell_around(std::uint32_t cavity, const std::vector<Body>& bodies,
                                        const MeshPieces& pieces, const PieceFaces& faces)
{
    const Box3& box = pieces.pieces[cavity].box;
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        const MeshPiece& shell = pieces.pieces[bodies[i].shell];
        if (shell.enclosed_volume <= 0.0 || !contains(shell.box, box) ||
            (best && shell.enclosed_volume >= pieces.pieces[bodies[*best].shell].enclosed_volume))
            continue;
        if (faces.winding(bodies[i].shell, faces.a_point_of(cavity)) > 0.5)
            best = i;
    }
    return best;
}

TriangleMesh mesh_of(const TriangleMesh& mesh, const Body& body, const PieceFaces& faces)
{
    std::vector<bool> kept(mesh.faces.size(), false);
    const auto keep = [&](std::uint32_t piece)
    {
        for (const std::uint32_t f : faces.of(piece))
            kept[f] = true;
    };
    keep(body.shell);
    std::for_each(body.cavities.begin(), body.cavities.end(), keep);
    return with_faces(mesh, kept);
}

} // namespace

std::vector<Body> find_bodies(const TriangleMesh& mesh, const MeshPieces& pieces)
{
    const PieceFaces faces(mesh, pieces);
    std::vector<Body> bodies;
    std::vector<std::uint32_t> cavities;
    for (std::uint32_t i = 0; i < pieces.pieces.size(); ++i)
        if (const MeshPiece& piece = pieces.pieces[i]; piece.closed() && piece.enclosed_volume < 0.0)
            cavities.push_back(i);
        else
            bodies.push_back({.shell = i, .cavities = {}, .volume = piece.enclosed_volume});
    const std::vector<Body> shells = bodies;
    for (const std::uint32_t cavity : cavities)
    {
        const double volume = pieces.pieces[cavity].enclosed_volume;
        const auto around = shell_around(cavity, shells, pieces, faces);
        if (!around)
        {
            bodies.push_back({.shell = cavity, .cavities = {}, .volume = volume});
            continue;
        }
        bodies[*around].cavities.push_back(cavity);
        bodies[*around].volume += volume;
    }
    return bodies;
}

SelectedBodies select_bodies(const TriangleMesh& mesh, const BodySelection& selection, bool largest_first)
{
    const MeshPieces pieces = split_into_pieces(mesh);
    const PieceFaces faces(mesh, pieces);
    std::vector<Body> bodies = find_bodies(mesh, pieces);
    SelectedBodies result;
    if (selection.drop_cavities)
        for (Body& body : bodies)
        {
            result.cavities_dropped += body.cavities.size();
            body.volume = pieces.pieces[body.shell].enclosed_volume;
            body.cavities.clear();
        }

    std::vector<std::size_t> by_volume(bodies.size());
    std::iota(by_volume.begin(), by_volume.end(), std::size_t{0});
    std::stable_sort(by_volume.begin(), by_volume.end(),
                     [&](std::size_t a, std::size_t b) { return bodies[a].volume > bodies[b].volume; });
    const auto is_kept = [&](std::size_t rank)
    {
        return rank < selection.keep_largest.value_or(bodies.size()) &&
               bodies[by_volume[rank]].volume >=
                   selection.min_volume.value_or(bodies[by_volume[rank]].volume);
    };
    std::vector<std::size_t> kept;
    for (std::size_t rank = 0; rank < by_volume.size(); ++rank)
        if (is_kept(rank))
            kept.push_back(by_volume[rank]);
        else
        {
            ++result.bodies_dropped;
            result.volume_dropped += bodies[by_volume[rank]].volume;
        }
    if (!largest_first)
        std::sort(kept.begin(), kept.end());
    for (const std::size_t i : kept)
        result.bodies.push_back(mesh_of(mesh, bodies[i], faces));
    return result;
}

} // namespace voroprobe
