#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "volume/lattice_frame.h"
#include "volume/level.h"
#include "volume/volume.h"

namespace voroprobe
{

//! The samples of a scan as heights above the level, slice by slice, whatever they are stored in. All
//! functions may be called from several threads at once.
class HeightField
{
public:
    virtual ~HeightField() = default;

    [[nodiscard]] virtual LatticeFrame frame() const = 0;

    //! The heights of slice k, x fastest, then y: positive inside, negative outside, never 0, always finite.
    //! \pre heights.size() is the number of samples of a slice.
    virtual void read_slice(std::size_t k, std::span<double> heights) const = 0;
};

//! A volume without NaN and infinite samples, and how its samples are read. Oracle and inventory are made of
//! the same one, so that they agree on every tie.
struct LevelledVolume
{
    std::shared_ptr<const Volume> volume;
    Level level;
};

//! Samples equal to the isovalue are moved inside (see LevelSurvey); samples that are not finite count as
//! outside: the volume is then copied. Cost: one pass. \throw UsageError where there is no volume, fewer than
//! 2 samples along an axis, or the isovalue is not finite; InputError where a sample differs from it by more
//! than 1e60.
LevelledVolume level_volume(std::shared_ptr<const Volume> volume, double isovalue,
                            InsideIs inside = InsideIs::kAbove);

//! The heights of a volume in its grid frame.
std::unique_ptr<HeightField> make_height_field(LevelledVolume levelled);

} // namespace voroprobe
