#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! An oracle without some of its surfaces, for what asks for crossings alone: segments pass through those as
//! if they were not there. The regions are the whole scan's. The oracle must outlive the object.
class KeptSurfaces final : public SurfaceOracle
{
public:
    //! `kept`: by surface of the oracle's inventory.
    KeptSurfaces(const SurfaceOracle& oracle, std::vector<bool> kept)
        : oracle_(oracle), kept_(std::move(kept))
    {
    }

    [[nodiscard]] Box3 domain() const override { return oracle_.domain(); }
    [[nodiscard]] Region region(const Point3& p) const override { return oracle_.region(p); }
    [[nodiscard]] bool may_cross(const Box3& box) const override { return oracle_.may_cross(box); }

    void find_crossings(const Segment3& segment, std::vector<Crossing>& crossings) const override
    {
        oracle_.find_crossings(segment, crossings);
        std::erase_if(crossings, [&](const Crossing& crossing) { return !is_kept(crossing); });
    }

private:
    //! What rounding hides the surface of stays.
    [[nodiscard]] bool is_kept(const Crossing& crossing) const
    {
        const SurfaceId surface = oracle_.surface_at(crossing.point);
        return surface == kNoSurface || kept_[static_cast<std::size_t>(surface)];
    }

    const SurfaceOracle& oracle_;
    std::vector<bool> kept_; //!< by surface
};

} // namespace voroprobe
