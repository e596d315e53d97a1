#include "postprocess/decimation.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "certificate/self_intersections.h"
#include "postprocess/face_shape.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

namespace om = OpenMesh;

struct DoubleTraits : om::DefaultTraits
{
    using Point = om::Vec3d;
    using Normal = om::Vec3d;
};
using HalfEdges = om::TriMesh_ArrayKernelT<DoubleTraits>;

//! Faces turn by less than this in one collapse.
constexpr double kLargestTurnDeg = 60.0;

//! Times that all is begun anew with more vertices locked.
constexpr int kMostAttempts = 8;

constexpr std::size_t kFewestFaces = 4;

Point3 point3(const om::Vec3d& p)
{
    return {p[0], p[1], p[2]};
}

//! Refuses what makes thin faces, and what would flatten a tetrahedron, which OpenMesh does not see.
template <class MeshType>
class ShapeModule final : public om::Decimater::ModBaseT<MeshType>
{
public:
    DECIMATING_MODULE(ShapeModule, MeshType, Shape);

    explicit ShapeModule(MeshType& mesh) : Base(mesh, true) {}

    void set_min_angle_deg(double angle) { min_angle_deg_ = angle; }

    float collapse_priority(const CollapseInfo& collapse) override
    {
        constexpr unsigned kFewestNeighbours = 3;
        const MeshType& mesh = Base::mesh();
        if ((collapse.vl.is_valid() && mesh.valence(collapse.vl) <= kFewestNeighbours) ||
            (collapse.vr.is_valid() && mesh.valence(collapse.vr) <= kFewestNeighbours))
            return static_cast<float>(Base::ILLEGAL_COLLAPSE);
        double before = min_angle_deg_;
        double after = min_angle_deg_;
        for (const auto face : mesh.vf_range(collapse.v0))
        {
            before = std::min(before, angle(face, collapse, false));
            if (face != collapse.fl && face != collapse.fr)
                after = std::min(after, angle(face, collapse, true));
        }
        return static_cast<float>(after >= before ? Base::LEGAL_COLLAPSE : Base::ILLEGAL_COLLAPSE);
    }

private:
    //! Of a face around the vertex that goes, as it is, or with the one that stays in its place.
    [[nodiscard]] double angle(om::FaceHandle face, const CollapseInfo& collapse, bool is_collapsed)
    {
        std::array<Point3, 3> corners;
        std::size_t i = 0;
        for (const auto vertex : Base::mesh().fv_range(face))
            corners[i++] =
                point3(is_collapsed && vertex == collapse.v0 ? collapse.p1 : Base::mesh().point(vertex));
        return smallest_angle_deg(corners[0], corners[1], corners[2]);
    }

    double min_angle_deg_ = 0.0;
};

HalfEdges half_edges_of(const TriangleMesh& mesh, const std::vector<bool>& locked)
{
    HalfEdges result;
    result.request_vertex_status();
    result.request_edge_status();
    result.request_face_status();
    result.request_face_normals();
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    {
        const Point3& p = mesh.vertices[v];
        result.status(result.add_vertex({p.x, p.y, p.z})).set_locked(locked[v]);
    }
    for (const TriangleMesh::Face& face : mesh.faces)
        result.add_face(result.vertex_handle(face[0]), result.vertex_handle(face[1]),
                        result.vertex_handle(face[2]));
    if (result.n_faces() != mesh.faces.size())
        throw UsageError("decimation: the mesh is not manifold; allowed: closed, manifold, oriented meshes");
    result.update_face_normals();
    return result;
}

//! What is left, and the numbers that its vertices had.
struct Remainder
{
    TriangleMesh mesh;
    std::vector<std::uint32_t> original;
};

Remainder remainder_of(const HalfEdges& half_edges)
{
    Remainder result;
    std::vector<std::uint32_t> number(half_edges.n_vertices(), 0);
    for (const auto vertex : half_edges.vertices())
        if (!half_edges.status(vertex).deleted())
        {
            number[static_cast<std::size_t>(vertex.idx())] =
                static_cast<std::uint32_t>(result.original.size());
            result.original.push_back(static_cast<std::uint32_t>(vertex.idx()));
            result.mesh.vertices.push_back(point3(half_edges.point(vertex)));
        }
    for (const auto face : half_edges.faces())
        if (!half_edges.status(face).deleted())
        {
            TriangleMesh::Face corners{};
            std::size_t i = 0;
            for (const auto vertex : half_edges.fv_range(face))
                corners[i++] = number[static_cast<std::size_t>(vertex.idx())];
            result.mesh.faces.push_back(corners);
        }
    return result;
}

Remainder attempt(const TriangleMesh& mesh, const DecimationOptions& options, const std::vector<bool>& locked)
{
    HalfEdges half_edges = half_edges_of(mesh, locked);
    om::Decimater::DecimaterT<HalfEdges> decimater(half_edges);
    om::Decimater::ModQuadricT<HalfEdges>::Handle quadric;
    om::Decimater::ModNormalFlippingT<HalfEdges>::Handle flipping;
    om::Decimater::ModHausdorffT<HalfEdges>::Handle hausdorff;
    ShapeModule<HalfEdges>::Handle shape;
    decimater.add(quadric);
    decimater.module(quadric).unset_max_err();
    decimater.add(flipping);
    decimater.module(flipping).set_max_normal_deviation(kLargestTurnDeg);
    decimater.add(shape);
    decimater.module(shape).set_min_angle_deg(options.min_angle_deg);
    if (options.max_distance)
    {
        decimater.add(hausdorff);
        decimater.module(hausdorff).set_tolerance(*options.max_distance);
    }
    decimater.initialize();
    decimater.decimate_to_faces(0, std::max(options.faces.value_or(kFewestFaces), kFewestFaces));
    return remainder_of(half_edges);
}

//! Locks the corners of faces that cross, and every vertex that went nearer to them than they are to one
//! another.
std::size_t lock_around(const std::vector<FacePair>& pairs, const Remainder& left, const TriangleMesh& mesh,
                        std::vector<bool>& locked)
{
    const auto before = std::count(locked.begin(), locked.end(), true);
    Box3 everything;
    std::vector<Box3> boxes;
    for (const auto& [f, g] : pairs)
    {
        Box3 box;
        for (const std::uint32_t face : {f, g})
            for (const std::uint32_t v : left.mesh.faces[face])
            {
                locked[left.original[v]] = true;
                box.include(left.mesh.vertices[v]);
            }
        boxes.push_back(box);
        everything.include(box.min);
        everything.include(box.max);
    }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if (everything.contains(mesh.vertices[v]))
            locked[v] =
                locked[v] || std::any_of(boxes.begin(), boxes.end(),
                                         [&](const Box3& box) { return box.contains(mesh.vertices[v]); });
    return static_cast<std::size_t>(std::count(locked.begin(), locked.end(), true) - before);
}

void check_options(const DecimationOptions& options)
{
    if (!options.faces && !options.max_distance)
        throw UsageError("decimation: no bound is given; allowed: a number of faces, a distance, or both");
    if (options.max_distance && !(*options.max_distance > 0.0))
        throw UsageError("decimation: the largest distance is " + std::to_string(*options.max_distance) +
                         "; allowed: a number > 0");
    if (!(options.min_angle_deg >= 0.0 && options.min_angle_deg < 60.0))
        throw UsageError("decimation: the smallest angle is " + std::to_string(options.min_angle_deg) +
                         " degrees; allowed: from 0 to below 60");
}

} // namespace

DecimationResult decimate(const TriangleMesh& mesh, const DecimationOptions& options)
{
    check_options(options);
    std::vector<bool> locked(mesh.vertices.size(), false);
    const std::size_t crossings_before = self_intersections(mesh).size();
    for (int number = 1;; ++number)
    {
        Remainder left = attempt(mesh, options, locked);
        const std::vector<FacePair> crossings = self_intersections(left.mesh);
        if (crossings.size() <= crossings_before || number == kMostAttempts ||
            lock_around(crossings, left, mesh, locked) == 0)
            return {.mesh = std::move(left.mesh),
                    .vertices_removed = mesh.vertices.size() - left.original.size(),
                    .vertices_locked =
                        static_cast<std::size_t>(std::count(locked.begin(), locked.end(), true)),
                    .self_intersections = crossings.size()};
    }
}

} // namespace voroprobe
