#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "postprocess/bounding_surface.h"
#include "postprocess/editable_mesh.h"

namespace voroprobe
{

//! Some faces of a mesh, to try out changes on: nothing happens to the mesh until commit().
class FacePatch
{
public:
    using Face = TriangleMesh::Face;

    //! All faces around the `inner` vertices, which are those that may be moved.
    FacePatch(const EditableMesh& mesh, std::span<const std::uint32_t> inner);

    [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
    [[nodiscard]] Point3 point(std::uint32_t vertex) const;

    // Each of the changes below returns false, and does nothing, where it would change the topology or touch
    // a held vertex in a way that moves it. \pre the edge runs between two inner vertices, or an inner one
    // and its neighbour.
    bool flip(std::uint32_t a, std::uint32_t b);
    bool collapse(std::uint32_t a, std::uint32_t b); //!< into `a`, in the middle of the two
    bool split(std::uint32_t a, std::uint32_t b);

    //! Moves the inner vertices, one after another, to where the smallest angle around them is largest.
    //! With a surface every place tried is on it, and none takes a face beyond the bound that was not beyond
    //! it, or farther: slower, and better where the surface bends.
    void improve_positions(int rounds, const BoundingSurface* surface = nullptr);

    //! Edges with both ends inner, each once.
    [[nodiscard]] std::vector<std::array<std::uint32_t, 2>> inner_edges() const;

    //! Inner vertices, those that a split made included.
    [[nodiscard]] const std::vector<std::uint32_t>& inner() const { return inner_; }
    //! Is the face of the mesh one that the patch stands for?
    [[nodiscard]] bool replaces(std::uint32_t face) const;
    [[nodiscard]] bool has_moved(std::uint32_t vertex) const;
    void move(std::uint32_t vertex, const Point3& to);

    //! By itself: the faces and the vertices on them.
    [[nodiscard]] TriangleMesh mesh() const;

    //! Scan units; of the faces that the patch knows.
    [[nodiscard]] double longest_edge_at(std::uint32_t vertex) const;

    //! Squared degrees by which angles fall short of a goal, in sum over the faces.
    [[nodiscard]] double shortfall(double goal_angle_deg) const;
    [[nodiscard]] double smallest_angle_deg() const;

    void commit(EditableMesh& mesh) const;

private:
    struct Moved
    {
        std::uint32_t vertex;
        Point3 to;
    };

    [[nodiscard]] std::optional<std::size_t> index_along(std::uint32_t a, std::uint32_t b) const;
    [[nodiscard]] bool is_inner(std::uint32_t vertex) const;
    [[nodiscard]] std::size_t valence(std::uint32_t vertex) const;
    [[nodiscard]] bool are_neighbours(std::uint32_t a, std::uint32_t b) const;
    [[nodiscard]] std::vector<std::uint32_t> neighbours(std::uint32_t vertex) const;
    [[nodiscard]] double smallest_angle_around(std::uint32_t vertex, const Point3& at) const;
    [[nodiscard]] bool keeps_bound(std::uint32_t vertex, const Point3& to,
                                   const BoundingSurface& surface) const;
    void improve_position(std::uint32_t vertex, const BoundingSurface* surface);

    const EditableMesh* mesh_;           //!< never null; patches can be assigned
    std::vector<std::uint32_t> removed_; //!< the faces of the mesh that the patch stands for
    std::vector<Face> faces_;
    std::vector<std::uint32_t> inner_; //!< all of whose faces are in the patch
    std::vector<Moved> moved_;
    std::uint32_t new_vertices_ = 0; //!< numbered from mesh_->vertex_count() on
};

} // namespace voroprobe
