#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "mesher/convex_region.h"
#include "oracles/surface_oracle.h"
#include "support/progress.h"

namespace voroprobe
{

//! Rounding of coordinates, in reaches: far above what it is, far below what could be seen.
inline constexpr double kRoundingInReaches = 1e-9;

//! A tile's half diagonal, its farthest point from the middle, in reaches.
inline constexpr double kTileHalfDiagonal = 1.0 - kRoundingInReaches;

//! What probing costs and finds.
struct ProbeCounts
{
    std::size_t queries = 0;          //!< segments asked about
    std::size_t hits_passed_over = 0; //!< crossings near the mesh
    std::size_t boxes_certified = 0;  //!< boxes the oracle certified to hold no surface: no probe there

    ProbeCounts& operator+=(const ProbeCounts& other)
    {
        queries += other.queries;
        hits_passed_over += other.hits_passed_over;
        boxes_certified += other.boxes_certified;
        return *this;
    }
};

//! Whether a crossing is news: not passed over for being near the mesh.
using IsNews = std::function<bool(const Point3&)>;

//! probe(C): looks for a crossing that is news in a convex region, so that in the end
//!
//! - every point of the region is within `reach` of a probed segment or lies in a box certified to be empty;
//! - what was probed and certified is connected, and connected to the region's hub.
//!
//! That is all the proof of Proposition 4 asks of it: a component around a ball of radius `reach` has a
//! probed point inside; along the connected set from there to the outside the surface is crossed, and not in
//! a box certified to be empty. Source: Feree & Alliez 2009, Sec. 4.
class Probing
{
public:
    //! All references must outlive the object. `stop` is asked every thousand questions; from when it says
    //! so nothing is asked any more, and what was to be probed was not.
    Probing(const SurfaceOracle& oracle, double reach, ProbeCounts& counts, const ProgressSink& stop)
        : oracle_(oracle), reach_(reach), counts_(counts), stop_(stop)
    {
    }

    //! The paper's probes: along the longest side of a thin bounding box, one through the middle of each tile
    //! of its smallest face, the central axis first and then level by level where the earlier ones are
    //! farthest. Each is clipped to the domain and the region, both grown by the tile, so that each point of
    //! the region has its tile's probe beside it. Then one across each row of tiles and one from each to the
    //! hub connect them. Returns the first news. Cost: about A / (2 reach^2) queries for a face of area A,
    //! and O(sqrt(A) / reach) to connect them. \throw UsageError for more than kMostTiles.
    std::optional<Point3> probe_all(const ConvexRegion& region, const IsNews& is_news);

    //! Whether the oracle certifies that the box holds no surface.
    bool certify(const Box3& box);

    [[nodiscard]] double reach() const { return reach_; }

    //! Whether probing was asked to stop; looks if so.
    bool stop_requested();

    [[nodiscard]] bool was_stopped() const { return stopped_; }

    //! One probe. Returns the first news along it.
    std::optional<Point3> query(const Segment3& segment, const IsNews& is_news);

private:
    class Tiles;

    void begin(const ConvexRegion& region, const IsNews& is_news);
    bool may_ask();
    std::optional<Point3> query(const Vec3& from, const Vec3& to);
    [[nodiscard]] Point3 world(const Vec3& coordinates) const;

    const SurfaceOracle& oracle_;
    double reach_;
    ProbeCounts& counts_;
    const ProgressSink& stop_;
    bool stopped_ = false;
    std::size_t asked_ = 0; //!< questions, since the last look

    // Of the region at hand.
    const ConvexRegion* region_ = nullptr;
    const IsNews* is_news_ = nullptr;
    ThinBox box_;
    std::vector<HalfSpace> half_spaces_; //!< the region's, in coordinates along the box's axes
    std::vector<Crossing> crossings_;
};

} // namespace voroprobe
