#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "postprocess/bounding_surface.h"
#include "postprocess/editable_mesh.h"

namespace voroprobe
{

//! Sweeps over all of a mesh: edges flip where that raises the smallest angle, vertices move along the
//! surface towards the middle of their neighbours. No face gets beyond the bound, or farther beyond it, and
//! none turns over; whether faces cross is not asked. Source: Botsch & Kobbelt 2004, "A remeshing approach
//! to multiresolution modeling".
class RelaxationSweeps
{
public:
    //! All must outlive it. `held`: vertices that stay where they are, with their edges.
    RelaxationSweeps(EditableMesh& mesh, const BoundingSurface& surface, const std::vector<bool>& held);

    void run(int times);

    [[nodiscard]] std::size_t edges_flipped() const { return edges_flipped_; }

private:
    [[nodiscard]] double angle_of(const TriangleMesh::Face& face) const;
    [[nodiscard]] Vec3 normal_of(const TriangleMesh::Face& face) const;
    [[nodiscard]] double distance_of(std::uint32_t face);

    void flip_edges();
    void try_flip(std::uint32_t f, std::uint32_t a, std::uint32_t b);
    [[nodiscard]] bool flip_keeps_to_surface(std::uint32_t f, std::uint32_t g,
                                             const std::array<TriangleMesh::Face, 2>& added);
    void move_vertices();
    void try_move(std::uint32_t v);
    [[nodiscard]] bool improves(std::uint32_t v, const Point3& to) const;
    [[nodiscard]] bool keeps_bound(std::uint32_t v, const Point3& to);
    [[nodiscard]] bool keeps_fold(std::uint32_t v, const Point3& to, const Vec3& normal) const;
    [[nodiscard]] bool is_near(const Point3& p, const Point3& replaced) const;
    [[nodiscard]] double distance_to_surface(const Point3& p) const;

    EditableMesh& mesh_;
    const BoundingSurface& surface_;
    const std::vector<bool>& held_;
    std::vector<std::optional<double>> face_distances_; //!< as far as they are known
    std::size_t edges_flipped_ = 0;
};

} // namespace voroprobe
