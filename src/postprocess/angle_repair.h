#pragma once

#include <cstddef>

#include "postprocess/bounding_surface.h"
#include "postprocess/editable_mesh.h"
#include "postprocess/patch_annealing.h"
#include "postprocess/patch_guard.h"

namespace voroprobe
{

//! Faces with an angle too small, by what is around them.
struct ShortFaces
{
    std::size_t beyond_bound = 0; //!< faces that lay beyond the bound: the mesh does not follow the surface
    std::size_t at_creases = 0;   //!< the surface turns by more than 75 degrees within a face
    std::size_t elsewhere = 0;

    [[nodiscard]] std::size_t all() const { return beyond_bound + at_creases + elsewhere; }
};

//! How hard to try, from cheap to dear.
enum class RepairEffort
{
    kPlane,  //!< vertices move in planes and are projected after it; one change around the face
    kSurface //!< every place tried is on the surface and within the bound
};

//! Works on faces with too small an angle one by one, by moves, flips, collapses and splits around each,
//! where angles get better, none gets below the smallest there, and the guard agrees.
class AngleRepair
{
public:
    //! All must outlive it. `target_angle_deg`: degrees, in [0, 40]. `most_beyond`: faces that may lie beyond
    //! the bound in the end; as many as do now where that is more.
    AngleRepair(EditableMesh& mesh, const BoundingSurface& surface, PatchGuard& guard,
                double target_angle_deg, std::size_t most_beyond);

    //! Takes the best of single changes around each face. Goes over the mesh up to so many times, until
    //! nothing is gained any more.
    void run(int rounds, RepairEffort effort);

    //! Anneals the patches around the faces that are left, again and again until there is none or the effort
    //! is spent.
    void anneal_short_faces(const ShiftBound& shift_bound);

    //! Faces below the target, and why.
    [[nodiscard]] ShortFaces short_faces() const;
    [[nodiscard]] const RelaxationCounts& counts() const { return counts_; }

private:
    struct Change
    {
        enum class Kind
        {
            kNone,
            kFlip,
            kCollapse,
            kSplit
        };
        Kind kind;
        std::uint32_t a;
        std::uint32_t b;
    };
    [[nodiscard]] double angle_of(std::uint32_t face) const;
    bool run_once(RepairEffort effort);
    bool repair(std::uint32_t face, RepairEffort effort);
    void anneal_around(std::uint32_t face, std::size_t round, const ShiftBound& shift_bound);
    [[nodiscard]] std::vector<std::uint32_t> short_face_list() const;
    [[nodiscard]] std::vector<Change> changes_of(std::uint32_t face) const;
    [[nodiscard]] std::vector<ChangedPatch>
    trials(const FacePatch& before, const std::vector<Change>& changes, RepairEffort effort) const;
    [[nodiscard]] bool project(FacePatch& patch) const;
    bool accept_best(std::vector<ChangedPatch> trials, const FacePatch& before);
    void commit(const ChangedPatch& changed);

    EditableMesh& mesh_;
    const BoundingSurface& surface_;
    PatchGuard& guard_;
    double target_angle_deg_;
    double goal_angle_deg_; //!< a little more
    std::size_t most_beyond_;
    std::size_t beyond_ = 0;     //!< faces beyond the bound while annealing
    std::size_t annealings_ = 0; //!< so far
    RelaxationCounts counts_;
};

} // namespace voroprobe
