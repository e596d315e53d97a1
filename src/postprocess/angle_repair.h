#pragma once

#include <cstddef>

#include "postprocess/bounding_surface.h"
#include "postprocess/editable_mesh.h"
#include "postprocess/patch_guard.h"

namespace voroprobe
{

//! What was done to a mesh to raise its angles.
struct RelaxationCounts
{
    std::size_t flips = 0;
    std::size_t collapses = 0;
    std::size_t splits = 0;
};

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
    kPlane,    //!< vertices move in planes and are projected after it; one change around the face
    kSurface,  //!< every place tried is on the surface and within the bound
    kTwoSteps, //!< in planes; a second change after the most promising first ones, over a wider patch
};

//! Works on faces with an angle below a goal one by one: the best of moves, flips, collapses and splits
//! around each is taken, where angles get better, none gets below the smallest there, and the guard agrees.
class AngleRepair
{
public:
    //! All must outlive it. `goal_angle_deg`: degrees, in [0, 60].
    AngleRepair(EditableMesh& mesh, const BoundingSurface& surface, PatchGuard& guard, double goal_angle_deg);

    //! Goes over the mesh up to so many times, until nothing is gained any more.
    void run(int rounds, RepairEffort effort);

    //! Faces with a smaller angle, degrees, and why.
    [[nodiscard]] ShortFaces short_faces(double angle_deg) const;
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
    struct Trial
    {
        FacePatch patch;
        double shortfall; //!< see FacePatch::shortfall()
        RelaxationCounts changes;
    };

    [[nodiscard]] double angle_of(std::uint32_t face) const;
    bool run_once(RepairEffort effort);
    bool repair(std::uint32_t face, RepairEffort effort);
    [[nodiscard]] std::vector<Change> changes_of(std::uint32_t face) const;
    [[nodiscard]] static std::vector<Change> changes_in(const FacePatch& patch);
    [[nodiscard]] std::vector<Trial> trials(const Trial& from, const std::vector<Change>& changes,
                                            RepairEffort effort) const;
    [[nodiscard]] bool project(FacePatch& patch) const;
    bool accept_best(std::vector<Trial> trials, const FacePatch& before);

    EditableMesh& mesh_;
    const BoundingSurface& surface_;
    PatchGuard& guard_;
    double goal_angle_deg_;
    RelaxationCounts counts_;
};

} // namespace voroprobe
