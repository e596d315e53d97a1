#include "labels/interface_fitting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "certificate/self_intersections.h"
#include "mesh/measures.h"

namespace voroprobe
{
namespace
{

constexpr int kMostRounds = 16;

//! Rounds end when one leaves more than this of what was missing, in sum over the labels' shares.
constexpr double kWorthwhile = 0.95;

//! What a round moves a vertex at most, as a share of the largest shift.
constexpr double kStepShare = 0.25;

//! Gauss-Seidel sweeps over the pressures of a round: the next round has the rest.
constexpr int kSweeps = 100;

//! Damps moves along directions that no face of a vertex looks in, as a share of the trace.
constexpr double kDamping = 0.02;

//! Faces turn by less than 60 degrees in a round.
constexpr double kCosLargestTurn = 0.5;

//! Angles do not fall below this, degrees, or below what they were.
constexpr double kLeastAngleDeg = 20.0;

//! Times that a round puts vertices back before it gives up all of itself.
constexpr int kMostRetreats = 30;

//! A symmetric 3 x 3 system, gathered face by face.
struct LeastSquares
{
    double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
    Vec3 right;

    void add(const Vec3& n, double weight, double wanted)
    {
        xx += weight * n.x * n.x;
        xy += weight * n.x * n.y;
        xz += weight * n.x * n.z;
        yy += weight * n.y * n.y;
        yz += weight * n.y * n.z;
        zz += weight * n.z * n.z;
        right += weight * wanted * n;
    }

    [[nodiscard]] Vec3 solution() const
    {
        const double damping = kDamping * (xx + yy + zz);
        const Vec3 a{xx + damping, xy, xz};
        const Vec3 b{xy, yy + damping, yz};
        const Vec3 c{xz, yz, zz + damping};
        const double determinant = dot(a, cross(b, c));
        if (!(determinant > 0.0))
            return {};
        return (right.x * cross(b, c) + right.y * cross(c, a) + right.z * cross(a, b)) / determinant;
    }
};

class VolumeFitting
{
public:
    VolumeFitting(InterfaceMesh& interfaces, std::span<const double> wanted,
                  const InterfaceFittingOptions& options)
        : mesh_(interfaces), wanted_(wanted), options_(options), begin_(interfaces.vertices),
          pressure_(wanted.size(), 0.0)
    {
    }

    void run()
    {
        double missing_before = std::numeric_limits<double>::infinity();
        for (int round = 0; round < kMostRounds && !fits(); ++round)
        {
            const double missing = total_missing();
            if (missing > kWorthwhile * missing_before)
                break; // what is left is held by its neighbours
            missing_before = missing;
            find_pressures();
            move();
        }
    }

private:
    //! Twice the area times the unit normal, which looks into `front`.
    [[nodiscard]] Vec3 twice_area(const InterfaceFace& face) const
    {
        const Point3& a = mesh_.vertices[face.vertices[0]];
        return cross(mesh_.vertices[face.vertices[1]] - a, mesh_.vertices[face.vertices[2]] - a);
    }

    //! Measures what is missing of each label. \return whether it is little for all.
    [[nodiscard]] bool fits()
    {
        missing_.assign(wanted_.begin(), wanted_.end());
        for (const InterfaceFace& face : mesh_.faces)
        {
            const Point3& a = mesh_.vertices[face.vertices[0]];
            const Point3& b = mesh_.vertices[face.vertices[1]];
            const Point3& c = mesh_.vertices[face.vertices[2]];
            const double volume = dot(a, cross(b, c)) / 6.0;
            missing_[face.behind] -= volume;
            missing_[face.front] += volume;
        }
        bool fits = true;
        for (std::size_t label = 1; label < wanted_.size(); ++label)
            fits = fits && std::abs(missing_[label]) <= options_.tolerance * wanted_[label];
        return fits;
    }

    //! In sum over the labels, each as a share of what it should have: specks count as much as what is large.
    [[nodiscard]] double total_missing() const
    {
        double sum = 0.0;
        for (std::size_t label = 1; label < wanted_.size(); ++label)
            sum += std::abs(missing_[label]) / wanted_[label];
        return sum;
    }

    //! To the first order: a label gains the areas of its interfaces times the differences of pressure.
    void find_pressures()
    {
        std::map<std::pair<PartitionLabel, PartitionLabel>, double> area;
        for (const InterfaceFace& face : mesh_.faces)
            area[std::minmax(face.front, face.behind)] += 0.5 * norm(twice_area(face));
        std::vector<std::vector<std::pair<PartitionLabel, double>>> neighbours(wanted_.size());
        for (const auto& [pair, shared] : area)
        {
            neighbours[pair.first].emplace_back(pair.second, shared);
            neighbours[pair.second].emplace_back(pair.first, shared);
        }
        std::fill(pressure_.begin(), pressure_.end(), 0.0);
        for (int sweep = 0; sweep < kSweeps; ++sweep)
            for (std::size_t label = 1; label < wanted_.size(); ++label)
            {
                double areas = 0.0;
                double sum = missing_[label];
                for (const auto& [other, shared] : neighbours[label])
                {
                    areas += shared;
                    sum += shared * pressure_[other];
                }
                pressure_[label] = areas > 0.0 ? sum / areas : 0.0;
            }
    }

    void move()
    {
        const double step = kStepShare * options_.max_shift;
        std::vector<LeastSquares> systems(mesh_.vertices.size());
        for (const InterfaceFace& face : mesh_.faces)
        {
            const Vec3 normal = twice_area(face);
            const double shift = std::clamp(pressure_[face.behind] - pressure_[face.front], -step, step);
            for (const std::uint32_t v : face.vertices)
                systems[v].add(normalized(normal), norm(normal), shift);
        }
        const std::vector<Point3> before = mesh_.vertices;
        std::vector<FaceShape> shapes;
        for (const InterfaceFace& face : mesh_.faces)
            shapes.push_back(shape_of(face));
        for (std::size_t v = 0; v < mesh_.vertices.size(); ++v)
        {
            Vec3 move = systems[v].solution();
            if (const double length = norm(move); length > step)
                move = (step / length) * move;
            if (const Point3 to = before[v] + move; distance(to, begin_[v]) <= options_.max_shift)
                mesh_.vertices[v] = to;
        }
        if (!retreat(before, shapes))
            mesh_.vertices = before;
    }

    struct FaceShape
    {
        Vec3 normal; //!< unit
        double smallest_angle_deg;
    };

    [[nodiscard]] FaceShape shape_of(const InterfaceFace& face) const
    {
        const auto angles =
            triangle_angles_deg(mesh_.vertices[face.vertices[0]], mesh_.vertices[face.vertices[1]],
                                mesh_.vertices[face.vertices[2]]);
        return {normalized(twice_area(face)), std::min({angles[0], angles[1], angles[2]})};
    }

    //! Puts vertices back until no faces cross, turn over or get slim.
    [[nodiscard]] bool retreat(const std::vector<Point3>& before, const std::vector<FaceShape>& shapes)
    {
        for (int i = 0; i < kMostRetreats; ++i)
        {
            bool is_sound = true;
            const auto put_back = [&](std::uint32_t f)
            {
                is_sound = false;
                for (const std::uint32_t v : mesh_.faces[f].vertices)
                    mesh_.vertices[v] = before[v];
            };
            for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f)
            {
                const FaceShape now = shape_of(mesh_.faces[f]);
                if (dot(now.normal, shapes[f].normal) < kCosLargestTurn ||
                    now.smallest_angle_deg < std::min(kLeastAngleDeg, shapes[f].smallest_angle_deg))
                    put_back(f);
            }
            if (!is_sound)
                continue; // the dear test last
            for (const auto& [f, g] : self_intersections(all_faces()))
            {
                put_back(f);
                put_back(g);
            }
            if (is_sound)
                return true;
        }
        return false;
    }

    [[nodiscard]] TriangleMesh all_faces() const
    {
        TriangleMesh mesh{mesh_.vertices, {}};
        mesh.faces.reserve(mesh_.faces.size());
        for (const InterfaceFace& face : mesh_.faces)
            mesh.faces.push_back(face.vertices);
        return mesh;
    }

    InterfaceMesh& mesh_;
    std::span<const double> wanted_;
    const InterfaceFittingOptions& options_;
    std::vector<Point3> begin_;
    std::vector<double> pressure_; //!< by label
    std::vector<double> missing_;  //!< by label
};

} // namespace

void fit_volumes(InterfaceMesh& interfaces, std::span<const double> wanted,
                 const InterfaceFittingOptions& options)
{
    VolumeFitting(interfaces, wanted, options).run();
}

} // namespace voroprobe
