#include "postprocess/relaxation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "certificate/self_intersections.h"
#include "postprocess/editable_mesh.h"
#include "postprocess/face_patch.h"
#include "postprocess/face_shape.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

using Face = TriangleMesh::Face;

//! Angles above this are no reason to leave a vertex where it is, degrees: the others of its star gain.
constexpr double kGoodAngleDeg = 42.0;

//! A flip or a repair has to gain as much, degrees, and squared degrees: rounding is no gain.
constexpr double kLeastGainDeg = 0.01;
constexpr double kLeastGain = 0.01;

//! Faces turn by less than 60 degrees when a vertex moves, and stay within 75 of the surface's own direction.
constexpr double kCosLargestTurn = 0.5;
constexpr double kCosLargestTilt = 0.26;

//! Faces that lean by more than 60 degrees from their vertex make a fold.
constexpr double kCosFold = 0.5;

//! Creases as fine as the mesh have no direction of their own; faces there may look along the surface, and
//! are checked exactly.
constexpr double kCosLargestTiltAtCreases = -0.2;

//! Rounds of repair; each deals with all faces below the goal.
constexpr int kRepairRounds = 8;
constexpr int kRoundsOnSurface = 6; // the slow ones
constexpr int kRoundsOfPositions = 2;

//! Repair after repair, with sweeps between them.
constexpr int kCycles = 3;
constexpr int kSweepsBetween = 2;

//! Times that all is begun anew with more vertices marked.
constexpr int kMostAttempts = 6;

//! What surrounds a crossing is delicate as well, to so many edges from it.
constexpr int kDelicateRings = 2;

void check_options(const RelaxationOptions& options)
{
    if (!(options.max_distance > 0.0) || !std::isfinite(options.max_distance))
        throw UsageError("relaxation: the largest distance is " + std::to_string(options.max_distance) +
                         "; allowed: a number > 0");
    if (!(options.goal_angle_deg >= 0.0 && options.goal_angle_deg <= 40.0))
        throw UsageError("relaxation: the angle aimed at is " + std::to_string(options.goal_angle_deg) +
                         " degrees; allowed: 0 to 40");
}

//! A few faces with vertices of their own.
struct LocalMesh
{
    TriangleMesh mesh;
    std::map<std::uint32_t, std::uint32_t> index;

    template <typename PointOf>
    void add(const Face& face, PointOf point_of)
    {
        Face renamed = face;
        for (std::uint32_t& v : renamed)
        {
            const auto [entry, is_new] =
                index.try_emplace(v, static_cast<std::uint32_t>(mesh.vertices.size()));
            if (is_new)
                mesh.vertices.push_back(point_of(v));
            v = entry->second;
        }
        mesh.faces.push_back(renamed);
    }
};

//! One attempt, with the delicate vertices that the last ones found.
class Relaxation
{
public:
    Relaxation(const TriangleMesh& mesh, const SurfaceProjection& projection,
               const RelaxationOptions& options, const std::vector<bool>& delicate)
        : mesh_(mesh), projection_(projection), options_(options), delicate_(delicate),
          has_moved_(mesh.vertices.size(), false)
    {
    }

    void run()
    {
        sweep(options_.sweeps);
        repair_faces(kRepairRounds, nullptr);
        for (int cycle = 0; cycle < kCycles && count_below_goal() > 0; ++cycle)
        {
            sweep(kSweepsBetween); // room for another try
            repair_faces(kRepairRounds, nullptr);
        }
        repair_faces(kRoundsOnSurface, &projection_);
    }

    [[nodiscard]] const EditableMesh& mesh() const { return mesh_; }

    [[nodiscard]] RelaxationResult result() const
    {
        RelaxationResult result = counts_;
        result.mesh = mesh_.mesh();
        result.vertices_moved =
            static_cast<std::size_t>(std::count(has_moved_.begin(), has_moved_.end(), true));
        result.faces_below_goal = count_below_goal();
        return result;
    }

private:
    [[nodiscard]] double angle_of(const Face& face) const
    {
        return smallest_angle_deg(mesh_.point(face[0]), mesh_.point(face[1]), mesh_.point(face[2]));
    }

    [[nodiscard]] Vec3 normal_of(const Face& face) const
    {
        return unit_normal(mesh_.point(face[0]), mesh_.point(face[1]), mesh_.point(face[2]));
    }

    [[nodiscard]] bool is_below_goal(std::uint32_t f) const
    {
        return angle_of(mesh_.face(f)) < options_.goal_angle_deg;
    }

    [[nodiscard]] std::size_t count_below_goal() const
    {
        std::size_t count = 0;
        for (std::uint32_t f = 0; f < mesh_.face_count(); ++f)
            count += mesh_.is_alive(f) && is_below_goal(f) ? 1 : 0;
        return count;
    }

    // ---- Sweeps ----

    void sweep(int times)
    {
        for (int i = 0; i < times; ++i)
        {
            flip_edges();
            move_vertices();
        }
    }

    void flip_edges()
    {
        const auto count = static_cast<std::uint32_t>(mesh_.face_count());
        for (std::uint32_t f = 0; f < count; ++f)
            for (std::size_t i = 0; i < 3 && mesh_.is_alive(f); ++i)
            {
                const std::uint32_t a = mesh_.face(f)[i];
                const std::uint32_t b = mesh_.face(f)[(i + 1) % 3];
                if (a < b)
                    try_flip(f, a, b);
            }
    }

    void try_flip(std::uint32_t f, std::uint32_t a, std::uint32_t b)
    {
        constexpr std::size_t kFewestFaces = 4; // with three, no angle can be good
        const std::uint32_t g = mesh_.face_along(b, a);
        const std::uint32_t c = opposite_corner(mesh_.face(f), a, b);
        const std::uint32_t d = opposite_corner(mesh_.face(g), a, b);
        if (is_delicate(a) || is_delicate(b) || is_delicate(c) || is_delicate(d) ||
            mesh_.faces_of(a).size() <= kFewestFaces || mesh_.faces_of(b).size() <= kFewestFaces ||
            mesh_.are_neighbours(c, d))
            return;
        const std::array<Face, 2> added{Face{a, d, c}, Face{d, b, c}};
        const double before = std::min(angle_of(mesh_.face(f)), angle_of(mesh_.face(g)));
        const double after = std::min(angle_of(added[0]), angle_of(added[1]));
        if (after <= before + kLeastGainDeg)
            return;
        const Vec3 out = normalized(normal_of(mesh_.face(f)) + normal_of(mesh_.face(g)));
        if (dot(normal_of(added[0]), out) < kCosLargestTurn ||
            dot(normal_of(added[1]), out) < kCosLargestTurn ||
            !is_near(0.5 * (mesh_.point(c) + mesh_.point(d)), 0.5 * (mesh_.point(a) + mesh_.point(b))))
            return;
        mesh_.replace(std::array{f, g}, added);
        ++counts_.edges_flipped;
    }

    //! Is `p` as near to the surface as is asked for, or as `replaced` was?
    [[nodiscard]] bool is_near(const Point3& p, const Point3& replaced) const
    {
        const double distance_to_it = distance_to_surface(p);
        return distance_to_it <= options_.max_distance || distance_to_it <= distance_to_surface(replaced);
    }

    [[nodiscard]] double distance_to_surface(const Point3& p) const
    {
        const auto near = projection_(p);
        return near ? distance(p, near->point) : std::numeric_limits<double>::infinity();
    }

    void move_vertices()
    {
        for (std::uint32_t v = 0; v < mesh_.vertex_count(); ++v)
            if (!mesh_.faces_of(v).empty() && !is_delicate(v))
                try_move(v);
    }

    [[nodiscard]] bool is_delicate(std::uint32_t v) const { return v >= delicate_.size() || delicate_[v]; }

    //! Along the surface, towards the middle of the neighbours.
    void try_move(std::uint32_t v)
    {
        Vec3 normal;
        Point3 middle;
        const auto& star = mesh_.faces_of(v);
        for (const std::uint32_t f : star)
        {
            const Face& face = mesh_.face(f);
            normal += cross(mesh_.point(face[1]) - mesh_.point(face[0]),
                            mesh_.point(face[2]) - mesh_.point(face[0]));
            middle += mesh_.point(next_corner(face, v)) / static_cast<double>(star.size());
        }
        normal = normalized(normal);
        const Point3 here = mesh_.point(v);
        const Vec3 way = middle - here;
        const auto target = projection_(here + way - dot(way, normal) * normal);
        if (target && dot(target->normal, normal) > kCosLargestTilt && improves(v, target->point) &&
            keeps_fold(v, target->point, normal))
        {
            mesh_.move(v, target->point);
            note_move(v);
        }
    }

    //! Where faces fold around a vertex, moving it along one side may take it off the other.
    [[nodiscard]] bool keeps_fold(std::uint32_t v, const Point3& to, const Vec3& normal) const
    {
        const auto& star = mesh_.faces_of(v);
        if (std::all_of(star.begin(), star.end(),
                        [&](std::uint32_t f) { return dot(normal_of(mesh_.face(f)), normal) > kCosFold; }))
            return true;
        return std::all_of(star.begin(), star.end(),
                           [&](std::uint32_t f)
                           {
                               const Face& face = mesh_.face(f);
                               const Vec3 middle =
                                   (mesh_.point(face[0]) + mesh_.point(face[1]) + mesh_.point(face[2])) / 3.0;
                               return is_near(middle + (to - mesh_.point(v)) / 3.0, middle);
                           });
    }

    [[nodiscard]] bool improves(std::uint32_t v, const Point3& to) const
    {
        double before = kGoodAngleDeg;
        double after = kGoodAngleDeg;
        for (const std::uint32_t f : mesh_.faces_of(v))
        {
            const Face& face = mesh_.face(f);
            const Point3& b = mesh_.point(next_corner(face, v));
            const Point3& c = mesh_.point(next_corner(face, next_corner(face, v)));
            if (dot(unit_normal(to, b, c), normal_of(face)) < kCosLargestTurn)
                return false;
            before = std::min(before, angle_of(face));
            after = std::min(after, smallest_angle_deg(to, b, c));
        }
        return after >= before;
    }

    void note_move(std::uint32_t v)
    {
        if (v >= has_moved_.size())
            has_moved_.resize(v + 1, false);
        has_moved_[v] = true;
    }

    // ---- Repair ----

    void repair_faces(int rounds, const SurfaceProjection* onto)
    {
        search_onto_ = onto;
        for (int round = 0; round < rounds; ++round)
            if (!repair_faces())
                break;
    }

    //! Whether anything was gained.
    bool repair_faces()
    {
        bool gained = false;
        look_for_delicate_faces();
        const auto count = static_cast<std::uint32_t>(mesh_.face_count());
        for (std::uint32_t f = 0; f < count; ++f)
            if (mesh_.is_alive(f) && is_below_goal(f) && repair(f))
                gained = true;
        return gained;
    }

    enum class Change
    {
        kNone,
        kFlip,
        kCollapse,
        kSplit
    };

    struct Trial
    {
        FacePatch patch;
        Change change;
        double shortfall;
    };

    //! The face's corners and those across its edges.
    [[nodiscard]] std::vector<std::uint32_t> surroundings(std::uint32_t f) const
    {
        const Face& face = mesh_.face(f);
        std::vector<std::uint32_t> vertices(face.begin(), face.end());
        for (std::size_t i = 0; i < 3; ++i)
        {
            const std::uint32_t a = face[i];
            const std::uint32_t b = face[(i + 1) % 3];
            const std::uint32_t across = opposite_corner(mesh_.face(mesh_.face_along(b, a)), a, b);
            if (std::find(vertices.begin(), vertices.end(), across) == vertices.end())
                vertices.push_back(across);
        }
        return vertices;
    }

    bool repair(std::uint32_t f)
    {
        const FacePatch before(mesh_, surroundings(f));
        std::optional<Trial> best;
        attempt(before, Change::kNone, 0, 0, best);
        const Face face = mesh_.face(f);
        for (std::size_t i = 0; i < 3; ++i)
            for (const Change change : {Change::kFlip, Change::kCollapse, Change::kSplit})
                attempt(before, change, face[i], face[(i + 1) % 3], best);
        if (!best)
            return false;
        accept(*best);
        return true;
    }

    static bool apply(FacePatch& patch, Change change, std::uint32_t a, std::uint32_t b)
    {
        switch (change)
        {
        case Change::kNone:
            return true;
        case Change::kFlip:
            return patch.flip(a, b);
        case Change::kCollapse:
            return patch.collapse(a, b);
        case Change::kSplit:
            return patch.split(a, b);
        }
        return false;
    }

    //! Keeps the change as `best` where it gains more than the best so far.
    void attempt(const FacePatch& before, Change change, std::uint32_t a, std::uint32_t b,
                 std::optional<Trial>& best)
    {
        FacePatch after = before;
        if (!apply(after, change, a, b))
            return;
        after.improve_positions(search_onto_ != nullptr ? 1 : kRoundsOfPositions, search_onto_);
        const double to_beat = best ? best->shortfall : before.shortfall(options_.goal_angle_deg);
        if (after.shortfall(options_.goal_angle_deg) > to_beat - kLeastGain || !project(after))
            return;
        const double shortfall = after.shortfall(options_.goal_angle_deg);
        if (shortfall < to_beat - kLeastGain && after.smallest_angle_deg() >= before.smallest_angle_deg() &&
            is_sound(after, before))
            best.emplace(Trial{std::move(after), change, shortfall});
    }

    //! Back onto the surface; false where that is not near.
    [[nodiscard]] bool project(FacePatch& patch) const
    {
        for (const std::uint32_t v : patch.inner())
            if (patch.has_moved(v))
            {
                const auto target = projection_(patch.point(v));
                if (!target)
                    return false;
                patch.move(v, target->point);
            }
        return true;
    }

    //! Do the faces lie as near to the surface as is asked for, or as they did, and look the way it does?
    //! Where they do not quite, as at creases as fine as the mesh, they must at least cross nothing.
    [[nodiscard]] bool is_sound(const FacePatch& after, const FacePatch& before) const
    {
        const auto [distance_before, tilt_before] = worst_fit(before);
        const auto [distance_after, tilt_after] = worst_fit(after);
        if (distance_after > std::max(options_.max_distance, distance_before))
            return false;
        if (tilt_after >= kCosLargestTilt)
            return !is_delicate(after) || crosses_nothing(after, delicate_faces_, looked_until_);
        return tilt_after >= std::min(kCosLargestTiltAtCreases, tilt_before) && crosses_nothing(after, {}, 0);
    }

    //! Over the faces of a patch: the largest distance of their middles to the surface, and the least cosine
    //! between the ways out of both.
    [[nodiscard]] std::pair<double, double> worst_fit(const FacePatch& patch) const
    {
        double farthest = 0.0;
        double tilt = 1.0;
        for (const Face& face : patch.faces())
        {
            const Point3 a = patch.point(face[0]);
            const Point3 b = patch.point(face[1]);
            const Point3 c = patch.point(face[2]);
            const Point3 middle = (a + b + c) / 3.0;
            const auto near = projection_(middle);
            if (!near)
                return {std::numeric_limits<double>::infinity(), -1.0};
            farthest = std::max(farthest, distance(middle, near->point));
            tilt = std::min(tilt, dot(unit_normal(a, b, c), near->normal));
        }
        return {farthest, tilt};
    }

    // ---- Where the surface all but touches itself ----

    [[nodiscard]] bool is_delicate(const Face& face) const
    {
        return is_delicate(face[0]) || is_delicate(face[1]) || is_delicate(face[2]);
    }

    void look_for_delicate_faces()
    {
        delicate_faces_.clear();
        looked_until_ = static_cast<std::uint32_t>(mesh_.face_count());
        for (std::uint32_t f = 0; f < looked_until_; ++f)
            if (mesh_.is_alive(f) && is_delicate(mesh_.face(f)))
                delicate_faces_.push_back(f);
    }

    //! Elsewhere it is not asked what crosses: that makes the place delicate at the next attempt.
    [[nodiscard]] bool is_delicate(const FacePatch& patch) const
    {
        return std::any_of(patch.faces().begin(), patch.faces().end(),
                           [this](const Face& face) { return is_delicate(face); });
    }

    //! Asked of the faces that are named, and of those from a number on. Exact.
    [[nodiscard]] bool crosses_nothing(const FacePatch& patch, const std::vector<std::uint32_t>& faces,
                                       std::uint32_t first) const
    {
        LocalMesh local;
        Box3 box;
        for (const Face& face : patch.faces())
        {
            local.add(face, [&patch](std::uint32_t v) { return patch.point(v); });
            for (const std::uint32_t v : face)
                box.include(patch.point(v));
        }
        const auto add_near = [&](std::uint32_t f)
        {
            if (mesh_.is_alive(f) && !patch.replaces(f) && overlaps(mesh_.face(f), box))
                local.add(mesh_.face(f), [&patch](std::uint32_t v) { return patch.point(v); });
        };
        std::for_each(faces.begin(), faces.end(), add_near);
        for (std::uint32_t f = first; f < mesh_.face_count(); ++f)
            add_near(f);
        return self_intersections(local.mesh).empty();
    }

    [[nodiscard]] bool overlaps(const Face& face, const Box3& box) const
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            const auto [low, high] = std::minmax(
                {mesh_.point(face[0])[axis], mesh_.point(face[1])[axis], mesh_.point(face[2])[axis]});
            if (high < box.min[axis] || low > box.max[axis])
                return false;
        }
        return true;
    }

    void accept(const Trial& trial)
    {
        trial.patch.commit(mesh_);
        for (const std::uint32_t v : trial.patch.inner())
            if (trial.patch.has_moved(v))
                note_move(v);
        counts_.edges_flipped += trial.change == Change::kFlip ? 1 : 0;
        counts_.edges_collapsed += trial.change == Change::kCollapse ? 1 : 0;
        counts_.edges_split += trial.change == Change::kSplit ? 1 : 0;
    }

    EditableMesh mesh_;
    const SurfaceProjection& projection_;
    const RelaxationOptions& options_;
    const std::vector<bool>& delicate_;
    std::vector<std::uint32_t> delicate_faces_; //!< as of the last look, and all that were made since
    std::uint32_t looked_until_ = 0;
    const SurfaceProjection* search_onto_ = nullptr; //!< of the rounds of repair under way
    std::vector<bool> has_moved_;
    RelaxationResult counts_;
};

//! Holds what lies near faces that cross: their corners, and what is next to those in the mesh that
//! relaxation began with. \return how many vertices were not marked before.
std::size_t mark_around(const std::vector<FacePair>& pairs, const TriangleMesh& relaxed,
                        const TriangleMesh& original, std::vector<bool>& delicate)
{
    const auto before = std::count(delicate.begin(), delicate.end(), true);
    std::vector<Point3> crossing;
    double reach = 0.0;
    for (const auto& [f, g] : pairs)
        for (const std::uint32_t face : {f, g})
            for (std::size_t i = 0; i < 3; ++i)
            {
                crossing.push_back(relaxed.corner(relaxed.faces[face], i));
                reach = std::max(reach,
                                 distance(crossing.back(), relaxed.corner(relaxed.faces[face], (i + 1) % 3)));
            }
    std::vector<bool> near(original.vertices.size(), false);
    for (std::size_t v = 0; v < original.vertices.size(); ++v)
        near[v] = std::any_of(crossing.begin(), crossing.end(),
                              [&](const Point3& p) { return distance(p, original.vertices[v]) <= reach; });
    for (int ring = 0; ring < kDelicateRings; ++ring)
    {
        std::vector<bool> grown = near;
        for (const Face& face : original.faces)
            if (near[face[0]] || near[face[1]] || near[face[2]])
                for (const std::uint32_t v : face)
                    grown[v] = true;
        near = std::move(grown);
    }
    for (std::size_t v = 0; v < delicate.size(); ++v)
        delicate[v] = delicate[v] || near[v];
    return static_cast<std::size_t>(std::count(delicate.begin(), delicate.end(), true) - before);
}

} // namespace

RelaxationResult relax(const TriangleMesh& mesh, const SurfaceProjection& projection,
                       const RelaxationOptions& options)
{
    check_options(options);
    std::vector<bool> delicate(mesh.vertices.size(), false);
    const std::size_t crossings_before = self_intersections(mesh).size();
    for (int attempt = 1;; ++attempt)
    {
        Relaxation relaxation(mesh, projection, options, delicate);
        relaxation.run();
        RelaxationResult result = relaxation.result();
        const std::vector<FacePair> crossings = self_intersections(result.mesh);
        result.vertices_delicate =
            static_cast<std::size_t>(std::count(delicate.begin(), delicate.end(), true));
        result.self_intersections = crossings.size();
        if (crossings.size() <= crossings_before || attempt == kMostAttempts ||
            mark_around(crossings, result.mesh, mesh, delicate) == 0)
            return result;
    }
}

} // namespace voroprobe
