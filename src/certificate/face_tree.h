#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/box3.h"
#include "mesh/triangle_mesh.h"

namespace voroprobe
{

//! Finds the faces of a mesh that are at some place. The faces are put in an order by space (order_in_space);
//! around every four of them there is a box, around every four of these boxes another one, up to one around
//! all. Memory: 68 bytes a face. May be asked from several threads at once.
class FaceTree
{
public:
    //! A face or a box: of level 0, the box of a single face; of level n, that of up to 4^n.
    struct Node
    {
        std::size_t level;
        std::size_t place; //!< in the level
    };

    //! `mesh` must outlive the tree. \pre faces name existing vertices, coordinates are finite. Cost: that
    //! of order_in_space(), and O(n).
    explicit FaceTree(const TriangleMesh& mesh);

    [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }

    //! All faces in the order of the tree: neighbours in the list are mostly neighbours in space.
    [[nodiscard]] const std::vector<std::uint32_t>& faces() const { return faces_; }

    //! From a point to the nearest point of the mesh, but for the rounding of doubles; infinite where there
    //! is no face. Cost: O(log n) where the point is near the mesh.
    [[nodiscard]] double distance(const Point3& p) const;

    //! Calls `visit(face)` for the faces whose boxes pass the test `may_be_in(box)`, as do all boxes around
    //! them.
    template <typename Test, typename Visit>
    void for_each_face_in(const Test& may_be_in, const Visit& visit) const
    {
        if (!faces_.empty())
            descend(root(), may_be_in, visit);
    }

    //! Blocks that for_each_meeting_pair() is asked for one after the other, or side by side.
    [[nodiscard]] std::size_t block_count() const
    {
        return faces_.empty() ? 0 : levels_[block_level()].size();
    }

    //! Calls `visit(f, g)` for every pair of faces whose boxes have a point in common, f of this block and g
    //! of it or of one that comes later; all blocks together tell each pair once.
    template <typename Visit>
    void for_each_meeting_pair(std::size_t block, const Visit& visit) const
    {
        const std::size_t level = block_level();
        find_pairs_within({level, block}, visit);
        for (std::size_t later = block + 1; later < levels_[level].size(); ++later)
            find_pairs_between({level, block}, {level, later}, visit);
    }

private:
    static constexpr std::size_t kArity = 4;

    //! Blocks are the boxes of the lowest level that has no more.
    static constexpr std::size_t kMostBlocks = 1024;

    [[nodiscard]] Node root() const { return {levels_.size() - 1, 0}; }
    [[nodiscard]] std::size_t block_level() const
    {
        std::size_t level = 0;
        while (levels_[level].size() > kMostBlocks)
            ++level;
        return level;
    }
    [[nodiscard]] const Box3& box(Node node) const { return levels_[node.level][node.place]; }
    [[nodiscard]] std::size_t first_child(Node node) const { return kArity * node.place; }
    [[nodiscard]] std::size_t end_of_children(Node node) const
    {
        return std::min(kArity * (node.place + 1), levels_[node.level - 1].size());
    }

    template <typename Test, typename Visit>
    void descend(Node node, const Test& may_be_in, const Visit& visit) const
    {
        if (!may_be_in(box(node)))
            return;
        if (node.level == 0)
            return visit(faces_[node.place]);
        for (std::size_t child = first_child(node); child < end_of_children(node); ++child)
            descend({node.level - 1, child}, may_be_in, visit);
    }

    static bool meet(const Box3& a, const Box3& b)
    {
        return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y &&
               a.min.z <= b.max.z && b.min.z <= a.max.z;
    }

    //! Of two different faces of one box.
    template <typename Visit>
    void find_pairs_within(Node node, const Visit& visit) const
    {
        if (node.level == 0)
            return;
        for (std::size_t a = first_child(node); a < end_of_children(node); ++a)
        {
            find_pairs_within({node.level - 1, a}, visit);
            for (std::size_t b = a + 1; b < end_of_children(node); ++b)
                find_pairs_between({node.level - 1, a}, {node.level - 1, b}, visit);
        }
    }

    //! Of faces of two boxes of one level.
    template <typename Visit>
    void find_pairs_between(Node a, Node b, const Visit& visit) const
    {
        if (!meet(box(a), box(b)))
            return;
        if (a.level == 0)
            return visit(faces_[a.place], faces_[b.place]);
        for (std::size_t child = first_child(a); child < end_of_children(a); ++child)
            if (meet(levels_[a.level - 1][child], box(b)))
                for (std::size_t other = first_child(b); other < end_of_children(b); ++other)
                    find_pairs_between({a.level - 1, child}, {b.level - 1, other}, visit);
    }

    //! Lowers the squared distance to that of the nearest face in a box, nearer boxes first.
    void look_for_nearer(Node node, const Point3& p, double& squared) const;

    const TriangleMesh& mesh_;
    std::vector<std::uint32_t> faces_;      //!< those of level 0, in order
    std::vector<std::vector<Box3>> levels_; //!< each box around four of the level before
};

} // namespace voroprobe
