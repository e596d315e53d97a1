#pragma once

#include <array>
#include <cstddef>
#include <map>

#include "postprocess/bounding_surface.h"
#include "postprocess/face_grid.h"
#include "postprocess/face_patch.h"

namespace voroprobe
{

//! How well the faces of a patch fit the surface.
struct PatchFit
{
    std::size_t beyond = 0;     //!< faces farther from the surface than the bound
    double face_distance = 0.0; //!< the largest of the faces, scan units
    double middle_distance = 0.0;
    double tilt = 1.0; //!< least cosine between a face's way out and the surface's
};

//! Tells whether a patch may take the place of the faces it stands for. Exact about what crosses.
class PatchGuard
{
public:
    //! Both must outlive the guard. `cell_size` as for FaceGrid.
    PatchGuard(const EditableMesh& mesh, const BoundingSurface& surface, double cell_size)
        : surface_(surface), mesh_(mesh), grid_(mesh, cell_size)
    {
    }

    //! Does one of the faces around a vertex lie beyond the bound?
    [[nodiscard]] bool is_beyond(const FacePatch& patch, std::uint32_t vertex);

    [[nodiscard]] PatchFit fit(const FacePatch& patch);

    //! No more faces lie beyond the bound than did, none farther than the farthest did, none looks against
    //! the surface, and none crosses another face but where one did already. Where the surface has creases as
    //! fine as the mesh, which have no direction of their own, faces may look along it. `previous`: a state
    //! of the same patch that is sound itself; of what both have in common nothing is asked again. Cost: some
    //! microseconds for each face that is new.
    [[nodiscard]] bool is_sound(const FacePatch& after, const FacePatch& previous, const PatchFit& before);

    //! To be called after each change of the mesh.
    void update() { grid_.update(); }

private:
    struct FaceFit
    {
        double face_distance;
        double middle_distance;
        double tilt;
    };
    using Corners = std::array<double, 9>;

    [[nodiscard]] const FaceFit& fit_of(const Point3& a, const Point3& b, const Point3& c);
    [[nodiscard]] bool keeps_to_surface(const PatchFit& after, const PatchFit& before) const;
    [[nodiscard]] bool crosses_nothing(const FacePatch& after, const FacePatch& previous) const;

    const BoundingSurface& surface_;
    const EditableMesh& mesh_;
    FaceGrid grid_;
    std::map<Corners, FaceFit> known_; //!< of faces seen lately
};

} // namespace voroprobe
