#include "compare/view_mesh.h"

#include <algorithm>
#include <cmath>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include "certificate/mesh_pieces.h"
#include "certificate/nearest_crossing.h"
#include "compare/decimation.h"
#include "mesh/measures.h"

namespace voroprobe
{

namespace
{

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

//! The smallest pieces are shown whole, as many as take this share of the faces: decimation could take them
//! away.
constexpr double kShareOfSmallPieces = 0.5;

//! The search for the surface begins within so many voxels of a face.
constexpr double kFirstReachInVoxels = 0.25;

Point3 centroid(const TriangleMesh& mesh, const TriangleMesh::Face& face)
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

//! The mesh shown, grid frame.
TriangleMesh decimated(const TriangleMesh& mesh, const MeshPieces& pieces, std::size_t most_faces)
{
    const std::size_t largest = largest_small_piece(pieces, most_faces);
    std::vector<bool> small;
    std::vector<bool> large;
    for (const std::uint32_t piece : pieces.piece_of_face)
    {
        small.push_back(pieces.pieces[piece].faces <= largest);
        large.push_back(!small.back());
    }
    TriangleMesh shown = with_faces(mesh, small);
    const TriangleMesh rest = with_faces(mesh, large);
    // Of pieces of equal size all are small or none: some more than their share.
    const std::size_t left = std::max(most_faces / 10, most_faces - std::min(shown.faces.size(), most_faces));
    const TriangleMesh coarse = decimate_faces(rest, left);
    const auto offset = static_cast<std::uint32_t>(shown.vertices.size());
    shown.vertices.insert(shown.vertices.end(), coarse.vertices.begin(), coarse.vertices.end());
    for (const TriangleMesh::Face& face : coarse.faces)
        shown.faces.push_back({face[0] + offset, face[1] + offset, face[2] + offset});
    return shown;
}

//! For each face of `shown` the face of `whole` next to its centroid.
std::vector<std::uint32_t> nearest_faces(const TriangleMesh& shown, const TriangleMesh& whole)
{
    const auto point = [](const Point3& p) { return Kernel::Point_3(p.x, p.y, p.z); };
    Triangles triangles;
    std::vector<std::uint32_t> face_of_triangle;
    for (std::size_t i = 0; i < whole.faces.size(); ++i)
    {
        const TriangleMesh::Face& face = whole.faces[i];
        const Kernel::Triangle_3 triangle(point(whole.corner(face, 0)), point(whole.corner(face, 1)),
                                          point(whole.corner(face, 2)));
        if (!(triangle.squared_area() > 0.0))
            continue;
        triangles.push_back(triangle);
        face_of_triangle.push_back(static_cast<std::uint32_t>(i));
    }
    Tree tree(triangles.cbegin(), triangles.cend());
    tree.build();
    std::vector<std::uint32_t> nearest;
    nearest.reserve(shown.faces.size());
    for (const TriangleMesh::Face& face : shown.faces)
    {
        const auto found = tree.closest_point_and_primitive(point(centroid(shown, face))).second;
        nearest.push_back(face_of_triangle[static_cast<std::size_t>(found - triangles.cbegin())]);
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

double smallest_angle_deg(const TriangleMesh& mesh, const TriangleMesh::Face& face)
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
        const TriangleMesh::Face& face = whole.faces[number];
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
    const bool whole = mesh.faces.size() <= most_faces;
    ViewMesh view{.mesh = whole ? mesh : decimated(mesh, pieces, most_faces),
                  .smallest_angles_deg = {},
                  .distances = {},
                  .pieces = {},
                  .faces_of_whole = mesh.faces.size()};
    add_facts(mesh, whole ? all_faces(mesh) : nearest_faces(view.mesh, mesh), pieces, reference, view);
    transform(view.mesh, reference.world_from_grid);
    return view;
}

} // namespace voroprobe
