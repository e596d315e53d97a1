#include "mesh/topology.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>

#include "mesh/edge_table.h"
#include "support/check.h"

namespace voroprobe
{

namespace
{

//! Disjoint sets of the numbers 0 to n - 1; a set is named by its smallest member. Source: Tarjan & van
//! Leeuwen 1984 (path halving).
class DisjointSets
{
public:
    explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }

    std::uint32_t find(std::uint32_t i)
    {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    void unite(std::uint32_t i, std::uint32_t j)
    {
        const auto [low, high] = std::minmax({find(i), find(j)});
        parent_[high] = low;
    }

private:
    std::vector<std::uint32_t> parent_;
};

std::uint32_t vertex_of_corner(const TriangleMesh& mesh, std::uint32_t corner)
{
    return mesh.faces[corner / 3][corner % 3];
}

std::uint32_t next_corner(std::uint32_t corner)
{
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

//! Does the work of analyze_topology(): one pass over the edges, one over the faces.
class TopologyAnalysis
{
public:
    explicit TopologyAnalysis(const TriangleMesh& mesh)
        : mesh_(mesh), fans_(3 * mesh.faces.size()), on_bad_edge_(mesh.vertices.size(), false)
    {
    }

    MeshTopology run(const EdgeTable& edges)
    {
        edges.for_each_edge([this](std::span<const Side> sides) { visit_edge(sides); });
        count_vertices_and_faces();
        return topology_;
    }

private:
    using Side = EdgeTable::Side;

    bool is_regular(const Side& side) const { return !names_a_vertex_twice(mesh_.faces[side.corner / 3]); }

    void visit_edge(std::span<const Side> sides)
    {
        regular_.clear();
        std::copy_if(sides.begin(), sides.end(), std::back_inserter(regular_),
                     [this](const Side& side) { return is_regular(side); });
        if (regular_.empty())
            return;

        ++edges_;
        join_fans_across_edge();
        if (regular_.size() == 1)
            ++topology_.boundary_edges;
        else if (regular_.size() == 2)
            topology_.misoriented_edges += start(regular_[0]) == start(regular_[1]) ? 1 : 0;
        else
            mark_non_manifold_edge();
    }

    //! Of the corners at either end of the edge, those of faces that share it belong to one fan.
    void join_fans_across_edge()
    {
        for (std::size_t i = 1; i < regular_.size(); ++i)
        {
            const std::uint32_t a = regular_[0].corner;
            const std::uint32_t b = regular_[i].corner;
            const bool same_direction = start(regular_[0]) == start(regular_[i]);
            fans_.unite(a, same_direction ? b : next_corner(b));
            fans_.unite(next_corner(a), same_direction ? next_corner(b) : b);
        }
    }

    void mark_non_manifold_edge()
    {
        ++topology_.non_manifold_edges;
        on_bad_edge_[start(regular_[0])] = true;
        on_bad_edge_[vertex_of_corner(mesh_, next_corner(regular_[0].corner))] = true;
    }

    std::uint32_t start(const Side& side) const { return vertex_of_corner(mesh_, side.corner); }

    void count_vertices_and_faces()
    {
        std::vector<std::uint32_t> fans_at(mesh_.vertices.size(), 0);
        std::vector<bool> on_a_face(mesh_.vertices.size(), false);
        for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f)
        {
            const TriangleMesh::Face& face = mesh_.faces[f];
            const bool degenerate = names_a_vertex_twice(face);
            topology_.degenerate_faces += degenerate ? 1 : 0;
            for (std::uint32_t i = 0; i < 3; ++i)
            {
                CHECK_LT(face[i], mesh_.vertices.size());
                on_a_face[face[i]] = true;
                if (!degenerate && fans_.find(3 * f + i) == 3 * f + i)
                    ++fans_at[face[i]];
            }
        }
        sum_up(fans_at, on_a_face);
    }

    void sum_up(const std::vector<std::uint32_t>& fans_at, const std::vector<bool>& on_a_face)
    {
        long regular_vertices = 0;
        for (std::size_t v = 0; v < fans_at.size(); ++v)
        {
            regular_vertices += fans_at[v] > 0 ? 1 : 0;
            topology_.non_manifold_vertices += fans_at[v] > 1 || on_bad_edge_[v] ? 1 : 0;
            topology_.unused_vertices += on_a_face[v] ? 0 : 1;
        }
        const auto regular_faces = static_cast<long>(mesh_.faces.size() - topology_.degenerate_faces);
        topology_.euler_characteristic = regular_vertices - edges_ + regular_faces;
    }

    const TriangleMesh& mesh_;
    MeshTopology topology_;
    DisjointSets fans_;             //!< of corners
    std::vector<bool> on_bad_edge_; //!< per vertex: end of an edge with three or more faces
    std::vector<Side> regular_;     //!< sides of the visited edge, without those of degenerate faces
    long edges_ = 0;
};

std::size_t count_components(const std::vector<std::uint32_t>& component)
{
    return component.empty() ? 0 : 1 + std::size_t{*std::max_element(component.begin(), component.end())};
}

//! For each vertex the first one at the same place.
std::vector<std::uint32_t> first_vertex_at_same_place(const std::vector<Point3>& vertices)
{
    struct Entry
    {
        Point3 p;
        std::uint32_t vertex;
    };
    std::vector<Entry> entries(vertices.size());
    for (std::uint32_t v = 0; v < entries.size(); ++v)
        entries[v] = {vertices[v], v};
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b)
              { return std::tie(a.p.x, a.p.y, a.p.z, a.vertex) < std::tie(b.p.x, b.p.y, b.p.z, b.vertex); });

    std::vector<std::uint32_t> first(entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i)
    {
        const bool same_place = i > 0 && entries[i].p == entries[i - 1].p;
        first[entries[i].vertex] = same_place ? first[entries[i - 1].vertex] : entries[i].vertex;
    }
    return first;
}

} // namespace

MeshTopology analyze_topology(const TriangleMesh& mesh)
{
    const EdgeTable edges(mesh);
    return analyze_topology(mesh, edges, count_components(component_of_faces(mesh, edges)));
}

MeshTopology analyze_topology(const TriangleMesh& mesh, const EdgeTable& edges, std::size_t components)
{
    MeshTopology topology = TopologyAnalysis(mesh).run(edges);
    topology.components = components;
    return topology;
}

bool is_closed_manifold(const TriangleMesh& mesh)
{
    const MeshTopology topology = analyze_topology(mesh);
    return topology.closed() && topology.manifold() && topology.oriented() && topology.unused_vertices == 0;
}

std::size_t count_components(const TriangleMesh& mesh)
{
    return count_components(component_of_faces(mesh));
}

long euler_characteristic(const TriangleMesh& mesh)
{
    return analyze_topology(mesh).euler_characteristic;
}

std::vector<std::uint32_t> component_of_faces(const TriangleMesh& mesh)
{
    return component_of_faces(mesh, EdgeTable(mesh));
}

std::vector<std::uint32_t> component_of_faces(const TriangleMesh& mesh, const EdgeTable& edges)
{
    DisjointSets pieces(mesh.faces.size());
    edges.for_each_edge(
        [&](std::span<const EdgeTable::Side> sides)
        {
            for (std::size_t i = 1; i < sides.size(); ++i)
                pieces.unite(sides[0].corner / 3, sides[i].corner / 3);
        });

    // A piece is named by its first face, so its number is known before any other face of it is met.
    std::vector<std::uint32_t> component(mesh.faces.size());
    std::uint32_t count = 0;
    for (std::uint32_t f = 0; f < component.size(); ++f)
    {
        const std::uint32_t first_face = pieces.find(f);
        component[f] = first_face == f ? count++ : component[first_face];
    }
    return component;
}

TriangleMesh weld(const TriangleMesh& mesh)
{
    const auto first = first_vertex_at_same_place(mesh.vertices);
    TriangleMesh welded;
    std::vector<std::uint32_t> number(first.size());
    for (std::uint32_t v = 0; v < first.size(); ++v)
    {
        if (first[v] == v)
            welded.vertices.push_back(mesh.vertices[v]);
        number[v] = first[v] == v ? static_cast<std::uint32_t>(welded.vertices.size() - 1) : number[first[v]];
    }
    welded.faces.reserve(mesh.faces.size());
    for (const TriangleMesh::Face& face : mesh.faces)
        welded.faces.push_back({number[face[0]], number[face[1]], number[face[2]]});
    return welded;
}

} // namespace voroprobe
