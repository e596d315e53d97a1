#include "compare/view_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "certificate/mesh_pieces.h"
#include "certificate/nearest_crossing.h"
#include "compare/decimation.h"
#include "mesh/measures.h"

namespace voroprobe
{

namespace
{

using Face = TriangleMesh::Face;

//! The smallest pieces are shown whole, as many as take this share of the faces: decimation could take them
//! away.
constexpr double kShareOfSmallPieces = 0.5;

//! The search for the surface begins within so many voxels of a face.
constexpr double kFirstReachInVoxels = 0.25;

Point3 centroid(const TriangleMesh& mesh, const Face& face)
{
    return (mesh.corner(face, 0) + mesh.corner(face, 1) + mesh.corner(face, 2)) / 3.0;
}

//! The most faces of a piece that is shown whole.
std::size_t largest_small_piece(const MeshPieces& pieces, std::size_t most_faces)
{
    std::vector<std::size_t> faces;
    for (const MeshPiece& piece : pieces.pieces)
        faces.push_back(piece.faces);
    std::sort(faces.begin(), faces.end());
    std::size_t sum = 0;
    std::size_t largest = 0;
    for (const std::size_t count : faces)
    {
        sum += count;
        if (static_cast<double>(sum) > kShareOfSmallPieces * static_cast<double>(most_faces))
            break;
        largest = count;
    }
    return largest;
}

//! The faces shown, over the vertices of the whole mesh.
std::vector<Face> shown_faces(const TriangleMesh& mesh, const MeshPieces& pieces, std::size_t most_faces)
{
    const std::size_t largest = largest_small_piece(pieces, most_faces);
    std::vector<Face> shown;
    TriangleMesh rest{.vertices = mesh.vertices, .faces = {}};
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
        (pieces.pieces[pieces.piece_of_face[i]].faces <= largest ? shown : rest.faces)
            .push_back(mesh.faces[i]);
    // Of pieces of equal size all are small or none: some more than their share.
    const std::size_t left = std::max(most_faces / 10, most_faces - std::min(shown.size(), most_faces));
    const std::vector<Face> coarse = decimated_faces(rest, left);
    shown.insert(shown.end(), coarse.begin(), coarse.end());
    return shown;
}

//! Which faces of a mesh each of its vertices is on.
class FacesOfVertices
{
public:
    explicit FacesOfVertices(const TriangleMesh& mesh) : begin_(mesh.vertices.size() + 1, 0)
    {
        for (const Face& face : mesh.faces)
            for (const std::uint32_t vertex : face)
                ++begin_[vertex + 1];
        std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
        faces_.resize(begin_.back());
        std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
        for (std::size_t i = 0; i < mesh.faces.size(); ++i)
            for (const std::uint32_t vertex : mesh.faces[i])
                faces_[next[vertex]++] = static_cast<std::uint32_t>(i);
    }

    [[nodiscard]] std::span<const std::uint32_t> operator[](std::uint32_t vertex) const
    {
        return std::span(faces_).subspan(begin_[vertex], begin_[vertex + 1] - begin_[vertex]);
    }

private:
    std::vector<std::size_t> begin_; //!< by vertex: its first place in `faces_`
    std::vector<std::uint32_t> faces_;
};

//! For each face shown the face of the whole mesh that it stands for: of those at its corners the one whose
//! centroid is next to its own.
std::vector<std::uint32_t> nearest_faces(const std::vector<Face>& shown, const TriangleMesh& whole)
{
    const FacesOfVertices faces_of(whole);
    std::vector<std::uint32_t> nearest;
    nearest.reserve(shown.size());
    for (const Face& face : shown)
    {
        const Point3 center = centroid(whole, face);
        std::uint32_t best = faces_of[face[0]].front();
        for (const std::uint32_t corner : face)
            for (const std::uint32_t other : faces_of[corner])
                if (squared_distance(center, centroid(whole, whole.faces[other])) <
                    squared_distance(center, centroid(whole, whole.faces[best])))
                    best = other;
        nearest.push_back(best);
    }
    return nearest;
}

std::vector<std::uint32_t> all_faces(const TriangleMesh& mesh)
{
    std::vector<std::uint32_t> faces(mesh.faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
        faces[i] = static_cast<std::uint32_t>(i);
    return faces;
}

double smallest_angle_deg(const TriangleMesh& mesh, const Face& face)
{
    const auto angles = triangle_angles_deg(mesh.corner(face, 0), mesh.corner(face, 1), mesh.corner(face, 2));
    return *std::min_element(angles.begin(), angles.end());
}

void add_facts(const TriangleMesh& whole, const std::vector<std::uint32_t>& faces, const MeshPieces& pieces,
               const ReferenceSurface& reference, ViewMesh& view)
{
    NearestCrossing search(*reference.oracle);
    const double first_reach = kFirstReachInVoxels * reference.voxel;
    const double last_reach = kLongestDistanceInVoxels * reference.voxel;
    for (const std::uint32_t number : faces)
    {
        const Face& face = whole.faces[number];
        const Vec3 normal = normalized(cross(whole.corner(face, 1) - whole.corner(face, 0),
                                             whole.corner(face, 2) - whole.corner(face, 0)));
        const auto found = search.near(centroid(whole, face), normal, first_reach, last_reach);
        view.distances.push_back(found ? found->distance : last_reach);
        view.smallest_angles_deg.push_back(smallest_angle_deg(whole, face));
        view.pieces.push_back(pieces.piece_of_face[number]);
    }
}

} // namespace

ViewMesh make_view_mesh(const TriangleMesh& mesh, const ReferenceSurface& reference, std::size_t most_faces)
{
    const MeshPieces pieces = split_into_pieces(mesh);
    ViewMesh view{.mesh = mesh,
                  .smallest_angles_deg = {},
                  .distances = {},
                  .pieces = {},
                  .faces_of_whole = mesh.faces.size()};
    std::vector<std::uint32_t> stands_for = all_faces(mesh);
    if (mesh.faces.size() > most_faces)
    {
        view.mesh.faces = shown_faces(mesh, pieces, most_faces);
        stands_for = nearest_faces(view.mesh.faces, mesh);
        view.mesh = with_faces(view.mesh, std::vector<bool>(view.mesh.faces.size(), true));
    }
    add_facts(mesh, stands_for, pieces, reference, view);
    transform(view.mesh, reference.world_from_grid);
    return view;
}

} // namespace voroprobe
