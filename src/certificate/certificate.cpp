#include "certificate/certificate.h"

#include <algorithm>
#include <map>
#include <optional>

#include <tbb/parallel_invoke.h>

#include "certificate/border_surfaces.h"
#include "certificate/complaints.h"
#include "certificate/face_tree.h"
#include "certificate/kept_surfaces.h"
#include "certificate/mesh_pieces.h"
#include "certificate/mesh_sides.h"
#include "certificate/self_intersections.h"
#include "certificate/surface_assignment.h"
#include "support/check.h"
#include "support/error.h"
#include "support/number_text.h"

namespace voroprobe
{

namespace
{

//! The pieces of the mesh that have to do with one surface of the scan.
struct Evidence
{
    std::vector<std::uint32_t> pieces;              //!< those that represent it
    std::optional<std::uint32_t> swallowed_by = {}; //!< the piece that has most of it, and represents another
    double swallowed_area = 0.0;
};

void check_arguments(const TriangleMesh& mesh, std::span<const ScanSurface> surfaces,
                     const CertificateOptions& options,
                     const std::optional<std::span<const SurfaceId>>& surface_of_face)
{
    if (!(options.reach > 0.0))
        throw UsageError("reach of the certificate is " + number_text(options.reach) +
                         "; allowed: a number > 0");
    for (const DroppedSurface& dropped : options.dropped)
        if (dropped.id < 0 || static_cast<std::size_t>(dropped.id) >= surfaces.size())
            throw UsageError("dropped surface is " + std::to_string(dropped.id) + "; allowed: 0 to " +
                             std::to_string(surfaces.size()) + ", not included");
    if (surface_of_face && surface_of_face->size() != mesh.faces.size())
        throw UsageError("surfaces are given for " + std::to_string(surface_of_face->size()) +
                         " faces; allowed: all " + std::to_string(mesh.faces.size()));
}

class Certification
{
public:
    Certification(const TriangleMesh& mesh, const SurfaceOracle& oracle,
                  std::span<const ScanSurface> surfaces, const CertificateOptions& options)
        : mesh_(mesh), oracle_(oracle), surfaces_(surfaces), options_(options), evidence_(surfaces.size()),
          expected_(surfaces.size(), true)
    {
        tbb::parallel_invoke([&] { tree_.emplace(mesh); },
                             [&]
                             {
                                 edges_.emplace(mesh);
                                 pieces_ = split_into_pieces(mesh, *edges_);
                             });
        surface_of_piece_.assign(pieces_.pieces.size(), kNoSurface);
    }

    Certificate run(const std::optional<std::span<const SurfaceId>>& surface_of_face)
    {
        assign_pieces(surface_of_face ? shares_of_faces(mesh_, pieces_.piece_of_face,
                                                        {surface_of_face->begin(), surface_of_face->end()})
                                      : found_shares());
        list_dropped();
        for (SurfaceId id = 0; id < static_cast<SurfaceId>(surfaces_.size()); ++id)
            if (expected_[static_cast<std::size_t>(id)])
                judge_surface(id);
        list_foreign_pieces();
        // Each fills in fields of its own, and has work for several threads besides.
        tbb::parallel_invoke([&] { measure_distance(); }, [&] { test_self_intersections(); },
                             [&] { count_criteria_exceptions(); }, [&] { find_places_of_mismatches(); },
                             [&] { list_lost_parts(); }, [&] { judge_topology(); });
        return std::move(certificate_);
    }

private:
    std::vector<Share> found_shares() const
    {
        return shares_of_vertices(mesh_, pieces_.piece_of_face,
                                  surface_of_vertices(mesh_, oracle_, options_.reach, options_.caps));
    }

    //! By the largest share of the area that lies on a surface. The shares come by piece, the largest first.
    void assign_pieces(const std::vector<Share>& shares)
    {
        for (const Share& share : shares)
        {
            if (share.surface == kNoSurface)
                continue;
            CHECK_LT(static_cast<std::size_t>(share.surface), surfaces_.size());
            Evidence& evidence = evidence_[static_cast<std::size_t>(share.surface)];
            SurfaceId& represented = surface_of_piece_[share.piece];
            if (represented == kNoSurface)
            {
                represented = share.surface;
                evidence.pieces.push_back(share.piece);
            }
            else if (!evidence.swallowed_by || share.area > evidence.swallowed_area)
            {
                evidence.swallowed_by = share.piece;
                evidence.swallowed_area = share.area;
            }
        }
    }

    void list_dropped()
    {
        for (const auto& [id, reason] : options_.dropped)
        {
            expected_[static_cast<std::size_t>(id)] = false;
            certificate_.dropped.push_back(entry(id, reason));
        }
        kept_.emplace(oracle_, expected_);
    }

    void judge_surface(SurfaceId id)
    {
        const ScanSurface& surface = surfaces_[static_cast<std::size_t>(id)];
        const std::vector<std::uint32_t>& pieces = evidence_[static_cast<std::size_t>(id)].pieces;
        if (pieces.empty() && may_end_at_border(surface) && lies_in_border(oracle_, id, floor_radius()))
        {
            certificate_.in_border.push_back(entry(id, "it lies in the border of the volume"));
            return;
        }
        ++certificate_.surfaces_expected;
        const bool has_closed_piece =
            std::any_of(pieces.begin(), pieces.end(),
                        [&](std::uint32_t piece) { return may_stand_for(pieces_.pieces[piece], surface); });
        if (!has_closed_piece)
        {
            certificate_.missing.push_back(entry(id, reason_for_missing(id)));
            return;
        }
        ++certificate_.surfaces_meshed;
        if (is_split(surface, pieces))
            certificate_.split.push_back({id, pieces.size(), surface.box});
        judge_handles(id, pieces);
        certificate_.surfaces_inside_out += is_inside_out(surface, pieces) ? 1 : 0;
    }

    [[nodiscard]] bool may_end_at_border(const ScanSurface& surface) const
    {
        return options_.caps == BorderCaps::kLeftOut && surface.touches_border;
    }

    //! The sheets of a surface cut by the border all have a rim.
    [[nodiscard]] bool is_split(const ScanSurface& surface, const std::vector<std::uint32_t>& pieces) const
    {
        return pieces.size() > 1 &&
               (!may_end_at_border(surface) ||
                std::any_of(pieces.begin(), pieces.end(),
                            [&](std::uint32_t piece) { return pieces_.pieces[piece].closed(); }));
    }

    [[nodiscard]] double floor_radius() const
    {
        return options_.floor_radius.value_or(0.25 * options_.reach);
    }

    [[nodiscard]] bool may_stand_for(const MeshPiece& piece, const ScanSurface& surface) const
    {
        return piece.closed() || may_end_at_border(surface);
    }

    //! Of a surface in several pieces some may wind either way: a pocket that is cut off is a hole.
    [[nodiscard]] bool is_inside_out(const ScanSurface& surface,
                                     const std::vector<std::uint32_t>& pieces) const
    {
        double enclosed_volume = 0.0;
        for (const std::uint32_t piece : pieces)
            enclosed_volume += pieces_.pieces[piece].closed() ? pieces_.pieces[piece].enclosed_volume : 0.0;
        return surface.cavity ? enclosed_volume > 0.0 : enclosed_volume < 0.0;
    }

    [[nodiscard]] std::string reason_for_missing(SurfaceId id) const
    {
        const Evidence& evidence = evidence_[static_cast<std::size_t>(id)];
        if (!evidence.pieces.empty())
            return "its piece is not closed: " +
                   std::to_string(pieces_.pieces[evidence.pieces.front()].boundary_edges) +
                   " edges are on one face only";
        if (evidence.swallowed_by)
            return "merged with surface " + std::to_string(surface_of_piece_[*evidence.swallowed_by]);
        return "no vertex of the mesh lies on it";
    }

    //! Only closed surfaces have a number of handles to compare.
    void judge_handles(SurfaceId id, const std::vector<std::uint32_t>& pieces)
    {
        const ScanSurface& surface = surfaces_[static_cast<std::size_t>(id)];
        if (may_end_at_border(surface))
            return;
        long euler_characteristic = 0;
        for (const std::uint32_t piece : pieces)
            euler_characteristic += pieces_.pieces[piece].euler_characteristic;
        if (euler_characteristic != surface.euler_characteristic)
            certificate_.genus_mismatches.push_back(
                {id, surface.euler_characteristic, euler_characteristic, surface.box, {}});
    }

    void find_places_of_mismatches()
    {
        if (certificate_.genus_mismatches.empty())
            return;
        std::map<SurfaceId, GenusMismatch*> mismatch_of;
        for (GenusMismatch& mismatch : certificate_.genus_mismatches)
            mismatch_of[mismatch.id] = &mismatch;
        std::vector<Neck> necks = oracle_.necks();
        std::erase_if(necks,
                      [&](const Neck& neck)
                      {
                          return std::none_of(neck.surfaces.begin(), neck.surfaces.end(),
                                              [&](SurfaceId id) { return mismatch_of.contains(id); });
                      });
        std::vector<Point3> middles;
        for (const Neck& neck : necks)
            middles.push_back(neck.middle);
        const std::vector<std::uint8_t> enclosed = enclosed_by(*tree_, middles);
        for (std::size_t n = 0; n < necks.size(); ++n)
        {
            if ((enclosed[n] != 0) == is_inside(necks[n].region))
                continue;
            for (const SurfaceId id : necks[n].surfaces)
            {
                if (const auto found = mismatch_of.find(id); found != mismatch_of.end())
                    found->second->places.push_back(necks[n].middle);
            }
        }
    }

    void list_foreign_pieces()
    {
        for (std::uint32_t piece = 0; piece < pieces_.pieces.size(); ++piece)
            if (surface_of_piece_[piece] == kNoSurface)
                certificate_.foreign.push_back(
                    {piece, pieces_.pieces[piece].faces, pieces_.pieces[piece].box});
    }

    void list_lost_parts()
    {
        std::vector<SurfaceId> surface_of_face;
        surface_of_face.reserve(mesh_.faces.size());
        for (const std::uint32_t piece : pieces_.piece_of_face)
            surface_of_face.push_back(surface_of_piece_[piece]);
        certificate_.lost_parts =
            find_lost_parts(mesh_, surface_of_face, oracle_, options_.reach, floor_radius());
        std::erase_if(certificate_.lost_parts, [&](const LostPart& part)
                      { return !expected_[static_cast<std::size_t>(part.surface)]; });
    }

    void judge_topology()
    {
        certificate_.topology = analyze_topology(mesh_, *edges_, pieces_.pieces.size());
        certificate_.closed = certificate_.topology.degenerate_faces == 0;
        for (std::size_t piece = 0; piece < pieces_.pieces.size(); ++piece)
        {
            const SurfaceId id = surface_of_piece_[piece];
            const bool rim_is_allowed =
                id != kNoSurface && may_end_at_border(surfaces_[static_cast<std::size_t>(id)]);
            certificate_.closed = certificate_.closed && (pieces_.pieces[piece].closed() || rim_is_allowed);
        }
    }

    void test_self_intersections()
    {
        if (options_.test_self_intersections)
            certificate_.self_intersections = self_intersections(*tree_).size();
    }

    void measure_distance()
    {
        SamplingOptions sampling = options_.sampling;
        sampling.caps = options_.caps;
        std::vector<Point3> surface_points;
        Box3 box;
        for (std::size_t id = 0; id < surfaces_.size(); ++id)
        {
            if (!expected_[id])
                continue;
            box.include(surfaces_[id].box.min);
            box.include(surfaces_[id].box.max);
            if (!may_end_at_border(surfaces_[id])) // its point may be one of a cap
                surface_points.push_back(surfaces_[id].point);
        }
        sampling.box = box.empty() ? std::nullopt : std::optional(box);
        certificate_.distance = surface_distance(*tree_, expected_oracle(), sampling, surface_points);
    }

    void count_criteria_exceptions()
    {
        certificate_.criteria_exceptions = count_exceptions(*tree_, expected_oracle(), options_.criteria);
    }

    //! Without the dropped surfaces.
    [[nodiscard]] const SurfaceOracle& expected_oracle() const
    {
        return certificate_.dropped.empty() ? oracle_ : *kept_;
    }

    [[nodiscard]] MissingSurface entry(SurfaceId id, const std::string& reason) const
    {
        const ScanSurface& surface = surfaces_[static_cast<std::size_t>(id)];
        return {id, surface.enclosed_samples, surface.box, reason};
    }

    const TriangleMesh& mesh_;
    const SurfaceOracle& oracle_;
    std::span<const ScanSurface> surfaces_;
    const CertificateOptions& options_;
    std::optional<FaceTree> tree_; // made side by side with the edges
    std::optional<EdgeTable> edges_;
    MeshPieces pieces_;
    std::vector<SurfaceId> surface_of_piece_;
    std::vector<Evidence> evidence_; //!< by surface
    std::vector<bool> expected_;     //!< by surface
    std::optional<KeptSurfaces> kept_;
    Certificate certificate_;
};

} // namespace

Certificate certify(const TriangleMesh& mesh, const SurfaceOracle& oracle,
                    std::span<const ScanSurface> surfaces, const CertificateOptions& options,
                    std::optional<std::span<const SurfaceId>> surface_of_face)
{
    check_arguments(mesh, surfaces, options, surface_of_face);
    return Certification(mesh, oracle, surfaces, options).run(surface_of_face);
}

std::optional<std::string> broken_promise(const Certificate& certificate)
{
    const MeshTopology& topology = certificate.topology;
    Complaints complaints;
    complaints.add(certificate.missing.size(), "surface missing", "surfaces missing");
    complaints.add(certificate.split.size(), "surface in several pieces", "surfaces in several pieces");
    complaints.add(certificate.foreign.size(), "piece on no surface of the scan",
                   "pieces on no surface of the scan");
    complaints.add(
        static_cast<std::size_t>(std::count_if(certificate.lost_parts.begin(), certificate.lost_parts.end(),
                                               [](const LostPart& part) { return !part.is_hair(); })),
        "surface with a part that the mesh does not come to",
        "surfaces with parts that the mesh does not come to");
    complaints.add(certificate.closed ? 0 : topology.boundary_edges, "edge on one face only",
                   "edges on one face only");
    complaints.add(topology.degenerate_faces, "face that names a vertex twice",
                   "faces that name a vertex twice");
    complaints.add_crowding(topology);
    complaints.add(certificate.surfaces_inside_out, "surface inside out", "surfaces inside out");
    complaints.add(certificate.self_intersections.value_or(0), "pair of faces that cross or overlap",
                   "pairs of faces that cross or overlap");
    return complaints.text();
}

} // namespace voroprobe
