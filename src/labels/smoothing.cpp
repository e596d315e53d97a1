#include "labels/smoothing.h"

#include <algorithm>

#include <itkAntiAliasBinaryImageFilter.h>
#include <itkDiscreteGaussianImageFilter.h>
#include <itkImage.h>

#include "support/error.h"
#include "support/number_text.h"

namespace voroprobe
{
namespace
{

using Image = itk::Image<float, 3>;

//! Height far inside; far outside it is the negative of it.
constexpr float kFar = 0.5F;

Image::Pointer image_of(const PartMask& mask, const Vec3& spacing)
{
    const auto image = Image::New();
    Image::RegionType region;
    Image::SpacingType image_spacing;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
        region.SetSize(axis, mask.size[axis]);
        image_spacing[axis] = spacing[axis];
    }
    image->SetRegions(region);
    image->SetSpacing(image_spacing);
    image->Allocate();
    std::transform(mask.part.begin(), mask.part.end(), image->GetBufferPointer(),
                   [](std::uint32_t part) { return part != 0 ? kFar : -kFar; });
    return image;
}

std::vector<float> samples_of(const Image& image)
{
    const std::size_t count = image.GetBufferedRegion().GetNumberOfPixels();
    return {image.GetBufferPointer(), image.GetBufferPointer() + count};
}

std::vector<float> blurred(const PartMask& mask, const Vec3& spacing, double sigma)
{
    // What the cut-off tails of the kernel weigh, and samples to either side: beyond four standard deviations
    // there is less.
    constexpr double kTruncation = 0.001;
    constexpr unsigned int kWidestKernel = 129;

    const auto filter = itk::DiscreteGaussianImageFilter<Image, Image>::New();
    filter->SetInput(image_of(mask, spacing));
    filter->SetNumberOfWorkUnits(1);
    filter->SetUseImageSpacing(true);
    filter->SetVariance(sigma * sigma);
    filter->SetMaximumError(kTruncation);
    filter->SetMaximumKernelWidth(kWidestKernel);
    filter->Update();
    return samples_of(*filter->GetOutput());
}

std::vector<float> antialiased(const PartMask& mask, const Vec3& spacing)
{
    // The change of a sample, root mean square in voxels, at which the surface stands still to the eye; the
    // filter's own guide asks for less than 0.07. Few masks take so many iterations.
    constexpr double kStandstill = 0.02;
    constexpr unsigned int kMostIterations = 50;

    const auto filter = itk::AntiAliasBinaryImageFilter<Image, Image>::New();
    filter->SetInput(image_of(mask, spacing));
    filter->SetNumberOfWorkUnits(1);
    filter->SetMaximumRMSError(kStandstill);
    filter->SetNumberOfIterations(kMostIterations);
    filter->Update();
    std::vector<float> heights = samples_of(*filter->GetOutput());
    // A level set counts in voxels; half of it between samples on either side, as for the mask itself.
    for (float& height : heights)
        height = std::clamp(0.5F * height, -kFar, kFar);
    return heights;
}

} // namespace

void check_smoothing(const LabelSmoothing& smoothing, const Vec3& spacing)
{
    if (smoothing.method != SmoothingMethod::kGaussian)
        return;
    const double most = kMostVoxelsOfSigma * std::min({spacing.x, spacing.y, spacing.z});
    if (!(smoothing.sigma > 0.0 && smoothing.sigma <= most))
        throw UsageError("the standard deviation of --smooth gaussian is " + number_text(smoothing.sigma) +
                         " mm; allowed: above 0, at most " + number_text(most) + " mm, which are " +
                         number_text(kMostVoxelsOfSigma) + " voxels");
}

std::vector<float> smoothed_heights(const PartMask& mask, const Vec3& spacing,
                                    const LabelSmoothing& smoothing)
{
    switch (smoothing.method)
    {
    case SmoothingMethod::kGaussian:
        return blurred(mask, spacing, smoothing.sigma);
    case SmoothingMethod::kAntialias:
        return antialiased(mask, spacing);
    case SmoothingMethod::kNone:
    case SmoothingMethod::kJoint:
        break;
    }
    std::vector<float> heights(mask.part.size());
    std::transform(mask.part.begin(), mask.part.end(), heights.begin(),
                   [](std::uint32_t part) { return part != 0 ? kFar : -kFar; });
    return heights;
}

} // namespace voroprobe
