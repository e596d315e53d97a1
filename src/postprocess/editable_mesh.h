#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! A closed mesh whose faces can be taken out and put in, a few at a time: what flips, collapses and splits
//! are made of.
class EditableMesh
{
public:
    using Face = TriangleMesh::Face;

    //! \pre closed and manifold.
    explicit EditableMesh(const TriangleMesh& mesh);

    [[nodiscard]] std::size_t vertex_count() const { return points_.size(); } //!< those taken out included
    [[nodiscard]] std::size_t face_count() const { return faces_.size(); }    //!< likewise
    [[nodiscard]] bool is_alive(std::uint32_t face) const { return alive_[face]; }
    [[nodiscard]] const Face& face(std::uint32_t face) const { return faces_[face]; }
    [[nodiscard]] const Point3& point(std::uint32_t vertex) const { return points_[vertex]; }
    [[nodiscard]] const std::vector<std::uint32_t>& faces_of(std::uint32_t vertex) const
    {
        return faces_of_[vertex];
    }

    //! Vertices joined to one by an edge, ascending. \pre closed around it.
    [[nodiscard]] std::vector<std::uint32_t> neighbours(std::uint32_t vertex) const;
    [[nodiscard]] bool are_neighbours(std::uint32_t a, std::uint32_t b) const;

    //! The face that has the edge from `a` to `b` in this direction; no face's number where there is none.
    [[nodiscard]] std::uint32_t face_along(std::uint32_t a, std::uint32_t b) const;

    void move(std::uint32_t vertex, const Point3& to) { points_[vertex] = to; }
    std::uint32_t add_vertex(const Point3& p);

    //! \pre the surface is as closed after it as before.
    void replace(std::span<const std::uint32_t> removed, std::span<const Face> added);

    //! The faces and the vertices on them, in order.
    [[nodiscard]] TriangleMesh mesh() const;

private:
    void detach(std::uint32_t face);
    void attach(const Face& face);

    std::vector<Point3> points_;
    std::vector<Face> faces_;
    std::vector<bool> alive_;
    std::vector<std::vector<std::uint32_t>> faces_of_; //!< by vertex
};

//! The corner of a face after `vertex`. \pre the face names it.
std::uint32_t next_corner(const TriangleMesh::Face& face, std::uint32_t vertex);

//! The corner of a face that is neither `a` nor `b`. \pre the face names both.
std::uint32_t opposite_corner(const TriangleMesh::Face& face, std::uint32_t a, std::uint32_t b);

} // namespace voroprobe
