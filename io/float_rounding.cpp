#include "io/float_rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <tuple>
#include <vector>

#include "support/error.h"
#include "support/random.h"

namespace voroprobe
{

namespace
{

//! Every round deals with all conflicts once. A scan needs one or two; the rest is for meshes about as fine
//! as the floats.
constexpr int kMaxRounds = 64;

//! Moves by one unit first; after this many rounds by up to two, and so on.
constexpr int kRoundsPerUnit = 6;

//! A vertex is never moved by more than this many units in the last place of its largest coordinate, per
//! axis.
constexpr int kMaxUnits = 3;

//! From this round on a move that leaves as many conflicts as it found is taken too, to get out of dead ends.
constexpr int kFirstSidewaysRound = 2;

constexpr std::uint64_t kSeed = 1; // of the choice among sideways moves

//! The float nearest to x; -0 becomes 0, since a reader cannot tell them apart. Volatile, because GCC 12
//! takes two such conversions side by side for one vector conversion there and back, and leaves both out.
double to_float(double x)
{
    const volatile float nearest = static_cast<float>(x);
    return static_cast<double>(nearest) + 0.0;
}

//! Distance from |x| to the next larger of the numbers.
double unit_of(const StoredNumbers& numbers, double x);

double to_stored(const StoredNumbers& numbers, double x)
{
    const double nearest = to_float(x);
    if (numbers.binary_digits >= std::numeric_limits<float>::digits && numbers.step == 0.0)
        return nearest;
    const double unit = unit_of(numbers, nearest); // a power of two: the division is exact
    return to_float(std::nearbyint(nearest / unit) * unit);
}

Point3 to_stored(const StoredNumbers& numbers, const Point3& p)
{
    return {to_stored(numbers, p.x), to_stored(numbers, p.y), to_stored(numbers, p.z)};
}

bool before(const Point3& a, const Point3& b)
{
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

double largest_coordinate(const Point3& p)
{
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

//! Distance from |x| to the next larger float.
double unit_in_last_place(double x)
{
    const float magnitude = std::abs(static_cast<float>(x));
    return static_cast<double>(std::nextafter(magnitude, std::numeric_limits<float>::infinity())) - magnitude;
}

double unit_of(const StoredNumbers& numbers, double x)
{
    const int digits_left_out = std::numeric_limits<float>::digits - numbers.binary_digits;
    return std::max(std::ldexp(unit_in_last_place(x), digits_left_out), numbers.step);
}

Vec3 normal(const Point3& a, const Point3& b, const Point3& c)
{
    return cross(b - a, c - a);
}

//! The faces at each vertex.
class Stars
{
public:
    explicit Stars(const TriangleMesh& mesh)
        : first_(mesh.vertices.size() + 1, 0), faces_(3 * mesh.faces.size())
    {
        for (const TriangleMesh::Face& face : mesh.faces)
            for (const std::uint32_t v : face)
                ++first_[v + 1];
        for (std::size_t v = 1; v < first_.size(); ++v)
            first_[v] += first_[v - 1];
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
            for (const std::uint32_t v : mesh.faces[f])
                faces_[next[v]++] = f;
    }

    [[nodiscard]] const std::uint32_t* begin(std::uint32_t v) const { return faces_.data() + first_[v]; }
    [[nodiscard]] const std::uint32_t* end(std::uint32_t v) const { return faces_.data() + first_[v + 1]; }

private:
    std::vector<std::size_t> first_;
    std::vector<std::uint32_t> faces_;
};

//! Which vertices lie at a place: a sorted list made once, and what has moved since.
class Places
{
public:
    explicit Places(const std::vector<Point3>& vertices)
    {
        sorted_.reserve(vertices.size());
        for (std::uint32_t v = 0; v < vertices.size(); ++v)
            sorted_.push_back({static_cast<float>(vertices[v].x), static_cast<float>(vertices[v].y),
                               static_cast<float>(vertices[v].z), v});
        std::sort(sorted_.begin(), sorted_.end());
    }

    //! Neighbours in the sorted list that lie at one place.
    [[nodiscard]] std::vector<std::array<std::uint32_t, 2>> coinciding_pairs() const
    {
        std::vector<std::array<std::uint32_t, 2>> pairs;
        for (std::size_t i = 1; i < sorted_.size(); ++i)
            if (same_place(sorted_[i - 1], sorted_[i]))
                pairs.push_back({sorted_[i - 1].vertex, sorted_[i].vertex});
        return pairs;
    }

    //! Is a vertex other than v at `place`? `vertices` are the current positions.
    [[nodiscard]] bool taken(const Point3& place, std::uint32_t v, const std::vector<Point3>& vertices) const
    {
        const auto is_other = [&](std::uint32_t u) { return u != v && vertices[u] == place; };
        const Entry wanted{static_cast<float>(place.x), static_cast<float>(place.y),
                           static_cast<float>(place.z), 0};
        for (auto it = std::lower_bound(sorted_.begin(), sorted_.end(), wanted);
             it != sorted_.end() && same_place(*it, wanted); ++it)
            if (is_other(it->vertex))
                return true;
        const auto [first, last] = moved_.equal_range(place);
        return std::any_of(first, last, [&](const auto& entry) { return is_other(entry.second); });
    }

    void note_move(const Point3& place, std::uint32_t v) { moved_.emplace(place, v); }

private:
    struct Entry
    {
        float x, y, z;
        std::uint32_t vertex;

        friend auto operator<=>(const Entry&, const Entry&) = default;
    };

    static bool same_place(const Entry& a, const Entry& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

    std::vector<Entry> sorted_;
    std::multimap<Point3, std::uint32_t, decltype(&before)> moved_{&before};
};

//! A step on the grid of floats, in units in the last place.
struct Step
{
    int x, y, z;

    [[nodiscard]] int units() const { return std::max({std::abs(x), std::abs(y), std::abs(z)}); }
};

//! All steps up to `units` along each axis, short ones first.
std::vector<Step> steps_up_to(int units)
{
    std::vector<Step> steps;
    for (int x = -units; x <= units; ++x)
        for (int y = -units; y <= units; ++y)
            for (int z = -units; z <= units; ++z)
                steps.push_back({x, y, z});
    std::stable_sort(steps.begin(), steps.end(),
                     [](const Step& a, const Step& b) { return a.units() < b.units(); });
    return steps;
}

//! A place a vertex could move to. Better ones compare less.
struct Move
{
    int conflicts_added;     //!< negative: the move solves more than it makes
    std::uint64_t draw;      //!< random for sideways moves, 0 for others
    int units;               //!< along the axis with the largest step
    bool away_from_own_side; //!< away from the middle of its neighbours
    double squared_error;    //!< squared distance to the unrounded vertex
    std::uint32_t vertex;
    Point3 place;

    friend bool operator<(const Move& a, const Move& b)
    {
        const auto key = [](const Move& m) {
            return std::tie(m.conflicts_added, m.draw, m.units, m.away_from_own_side, m.squared_error,
                            m.vertex);
        };
        return key(a) < key(b) || (key(a) == key(b) && before(a.place, b.place));
    }
};

//! Local search for a rounding without conflicts: each conflict in turn is solved by the best move of one of
//! its vertices.
class ConflictSearch
{
public:
    ConflictSearch(const TriangleMesh& exact, TriangleMesh& rounded, const StoredNumbers& numbers)
        : exact_(exact), rounded_(rounded), numbers_(numbers)
    {
    }

    void run()
    {
        for (int round = 0; round < kMaxRounds; ++round)
        {
            Places places(rounded_.vertices);
            const auto pairs = places.coinciding_pairs();
            const auto faces = bad_faces();
            if (pairs.empty() && faces.empty())
                return;
            if (!stars_)
                stars_.emplace(exact_);
            begin_round(round, places);
            for (const auto& [u, v] : pairs)
                if (rounded_.vertices[u] == rounded_.vertices[v])
                    solve(std::array{u, v});
            for (const std::uint32_t f : faces)
                if (is_bad(rounded_.vertices, f))
                    solve(exact_.faces[f]);
        }
        fail();
    }

private:
    //! Is the face folded over, or without area, with its corners at `vertices`?
    [[nodiscard]] bool is_bad(const std::vector<Point3>& vertices, std::uint32_t f) const
    {
        const auto& [a, b, c] = exact_.faces[f];
        const Vec3 exact = normal(exact_.vertices[a], exact_.vertices[b], exact_.vertices[c]);
        if (exact == Vec3{})
            return false;
        // Differences of neighbouring floats are exact in double, so the sign below is that of the rounded
        // face.
        return !(dot(normal(vertices[a], vertices[b], vertices[c]), exact) > 0.0);
    }

    [[nodiscard]] std::vector<std::uint32_t> bad_faces() const
    {
        std::vector<std::uint32_t> bad;
        for (std::uint32_t f = 0; f < exact_.faces.size(); ++f)
            if (is_bad(rounded_.vertices, f))
                bad.push_back(f);
        return bad;
    }

    void begin_round(int round, Places& places)
    {
        places_ = &places;
        sideways_ = round >= kFirstSidewaysRound;
        steps_ = steps_up_to(std::min(1 + round / kRoundsPerUnit, kMaxUnits));
    }

    [[nodiscard]] int count_bad_faces(std::uint32_t v) const
    {
        return static_cast<int>(std::count_if(stars_->begin(v), stars_->end(v),
                                              [&](std::uint32_t f) { return is_bad(rounded_.vertices, f); }));
    }

    template <typename Vertices>
    void solve(const Vertices& vertices)
    {
        std::optional<Move> best;
        for (const std::uint32_t v : vertices)
            consider_moves(v, best);
        if (!best || best->conflicts_added > 0 || (best->conflicts_added == 0 && !sideways_))
            return;
        rounded_.vertices[best->vertex] = best->place;
        places_->note_move(best->place, best->vertex);
    }

    void consider_moves(std::uint32_t v, std::optional<Move>& best)
    {
        const Point3 here = rounded_.vertices[v];
        const Point3 nearest = to_stored(numbers_, exact_.vertices[v]);
        const auto [unit, towards_neighbours] = surroundings(v);
        const int conflicts_here = count_bad_faces(v) + (places_->taken(here, v, rounded_.vertices) ? 1 : 0);
        for (const Step& step : steps_)
        {
            if (best && best->conflicts_added <= -conflicts_here && step.units() > best->units)
                break; // nothing is left to solve here, and steps only get longer
            const Point3 place =
                to_stored(numbers_, nearest + Vec3{step.x * unit, step.y * unit, step.z * unit});
            if (place == here || !is_finite(place) || places_->taken(place, v, rounded_.vertices))
                continue;
            rounded_.vertices[v] = place; // on trial
            const int added = count_bad_faces(v) - conflicts_here;
            const Move move{added,
                            added == 0 ? random_.next() : 0,
                            step.units(),
                            dot(place - nearest, towards_neighbours) < 0.0,
                            squared_distance(place, exact_.vertices[v]),
                            v,
                            place};
            if (!best || move < *best)
                best = move;
        }
        rounded_.vertices[v] = here;
    }

    struct Surroundings
    {
        double unit;             //!< in the last place of the largest coordinate nearby
        Vec3 towards_neighbours; //!< from the vertex to the middle of its neighbours
    };
    [[nodiscard]] Surroundings surroundings(std::uint32_t v) const
    {
        double largest = 0.0;
        Vec3 towards_neighbours;
        for (const std::uint32_t* f = stars_->begin(v); f != stars_->end(v); ++f)
            for (const std::uint32_t u : exact_.faces[*f])
            {
                largest = std::max(largest, largest_coordinate(exact_.vertices[u]));
                towards_neighbours += exact_.vertices[u] - exact_.vertices[v];
            }
        return {unit_of(numbers_, largest), towards_neighbours};
    }

    [[noreturn]] void fail() const
    {
        const auto pairs = Places(rounded_.vertices).coinciding_pairs();
        const auto faces = bad_faces();
        const Point3 p = exact_.vertices[pairs.empty() ? exact_.faces[faces[0]][0] : pairs[0][0]];
        std::ostringstream message;
        message << "the mesh is too fine for 32-bit floats as the format stores them: rounding leaves "
                << pairs.size() << " coinciding vertices and " << faces.size() << " folded faces, one near ("
                << p.x << ", " << p.y << ", " << p.z << ") where its numbers are "
                << unit_of(numbers_, largest_coordinate(p))
                << " apart; choose .vtp, which stores 64-bit floats, or a larger size";
        throw OutputError(message.str());
    }

    const TriangleMesh& exact_;
    TriangleMesh& rounded_;
    StoredNumbers numbers_;
    std::optional<Stars> stars_; //!< made when the first conflict shows up
    Places* places_ = nullptr;   //!< of this round
    std::vector<Step> steps_;    //!< of this round
    bool sideways_ = false;
    Random random_{kSeed};
};

void check_range(const Point3& p)
{
    if (!(largest_coordinate(p) <= std::numeric_limits<float>::max()))
    {
        std::ostringstream message;
        message << "the vertex (" << p.x << ", " << p.y << ", " << p.z
                << ") is outside the range of 32-bit floats, +-" << std::numeric_limits<float>::max();
        throw OutputError(message.str());
    }
}

} // namespace

FloatRounding round_to_float(const TriangleMesh& mesh, const StoredNumbers& numbers)
{
    FloatRounding rounding{.mesh = mesh};
    for (Point3& p : rounding.mesh.vertices)
    {
        check_range(p);
        p = to_stored(numbers, p);
    }
    ConflictSearch(mesh, rounding.mesh, numbers).run();
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        rounding.vertices_nudged += rounding.mesh.vertices[v] != to_stored(numbers, mesh.vertices[v]) ? 1 : 0;
    return rounding;
}

} // namespace voroprobe
