#pragma once

#include <vector>

#include "geometry/vec3.h"
#include "labels/part_groups.h"

namespace voroprobe
{

//! How the staircase of voxels is smoothed.
enum class SmoothingMethod
{
    kNone,      //!< not: halfway between the voxels of a mask of 0 and 1
    kGaussian,  //!< the mask blurred
    kAntialias, //!< the surface of least area between the voxels inside and outside, about
    kJoint      //!< all labels together; for mesh_labels_jointly() alone
};

struct LabelSmoothing
{
    SmoothingMethod method;
    double sigma = 0.0; //!< kGaussian: standard deviation, scan units, > 0
};

//! \throw UsageError where sigma is not above 0 or spans more than kMostVoxelsOfSigma voxels: of a shape
//! blurred so far nothing is left.
void check_smoothing(const LabelSmoothing& smoothing, const Vec3& spacing);
inline constexpr double kMostVoxelsOfSigma = 16.0;

//! Heights of the samples of a mask, between -0.5 and 0.5, positive where the smoothed object is. They may
//! leave out thin parts; PartField puts those back.
//!
//! kGaussian: ITK's DiscreteGaussianImageFilter. kAntialias: ITK's AntiAliasBinaryImageFilter; source:
//! Whitaker, Reducing aliasing artifacts in iso-surfaces of binary volumes, 2000. Both run on the thread that
//! calls. kJoint gives what kNone does. `spacing`: scan units. Cost: some passes over the samples; some dozen
//! for kAntialias.
std::vector<float> smoothed_heights(const PartMask& mask, const Vec3& spacing,
                                    const LabelSmoothing& smoothing);

} // namespace voroprobe
