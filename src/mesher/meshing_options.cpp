#include "mesher/meshing_options.h"

#include <cmath>
#include <string>

#include "support/error.h"
#include "support/number_text.h"

namespace voroprobe
{
namespace
{

void require(bool condition, const std::string& name, double value, const std::string& range)
{
    if (!condition)
        throw UsageError(name + " is " + number_text(value) + "; it must be " + range);
}

} // namespace

void check_options(const MeshingOptions& options)
{
    const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
    require(positive(options.max_facet_radius), "max_facet_radius", options.max_facet_radius,
            "finite and above 0");
    require(positive(options.floor_radius), "floor_radius", options.floor_radius, "finite and above 0");
    require(positive(options.reach_lower_bound), "reach_lower_bound", options.reach_lower_bound,
            "finite and above 0");
    require(options.min_facet_angle_deg >= 0.0 && options.min_facet_angle_deg <= 30.0, "min_facet_angle_deg",
            options.min_facet_angle_deg, "in [0, 30] degrees");
    const double component_radius = options.component_radius.value_or(options.reach_lower_bound);
    require(component_radius >= options.reach_lower_bound && std::isfinite(component_radius),
            "component_radius", component_radius, "finite and at least reach_lower_bound");
    require(!options.max_seconds || *options.max_seconds >= 0.0, "max_seconds",
            options.max_seconds.value_or(0.0), "at least 0");
    if (options.domain_ball)
        require(positive(options.domain_ball->radius) && is_finite(options.domain_ball->center),
                "the radius of domain_ball", options.domain_ball->radius, "finite and above 0");
    if (options.max_facet_distance)
        require(positive(*options.max_facet_distance), "max_facet_distance", *options.max_facet_distance,
                "finite and above 0");
}

} // namespace voroprobe
