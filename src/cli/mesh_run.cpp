#include "cli/mesh_run.h"

#include "cli/number_text.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

void complain(std::string& complaints, std::size_t count, const std::string& what)
{
    if (count > 0)
        complaints += (complaints.empty() ? "" : ", ") + count_text(count) + ' ' + what;
}

} // namespace

AffineTransform shown_from_grid(const MeshRun& run)
{
    const OutputFrame frame =
        run.arguments.frame == OutputFrame::kIndex ? OutputFrame::kLps : run.arguments.frame;
    return output_from_grid(frame, run.input.placement);
}

std::optional<std::string> broken_promise(const MeshFacts& facts, BorderFaces border)
{
    const MeshTopology& topology = facts.topology;
    std::string complaints;
    complain(complaints, border == BorderFaces::kClosed ? topology.boundary_edges : 0,
             "edges on one face only");
    complain(complaints, topology.non_manifold_edges, "edges on more than two faces");
    complain(complaints, topology.non_manifold_vertices, "vertices whose faces are not one fan");
    complain(complaints, topology.misoriented_edges, "edges whose faces wind against each other");
    complain(complaints, topology.degenerate_faces, "faces without area");
    complain(complaints, topology.unused_vertices, "vertices on no face");
    complain(complaints, facts.coincident_vertices, "vertices at the place of another");
    if (complaints.empty() && topology.closed() && facts.volume_mm3 <= 0.0)
        complaints = "faces that wind inward";
    return complaints.empty() ? std::nullopt : std::optional(complaints);
}

std::string budget_text(const MeshRun& run)
{
    const std::optional<std::size_t>& vertices = run.arguments.max_vertices;
    const std::optional<double>& seconds = run.arguments.finding.max_seconds;
    const std::string seconds_text = seconds ? "--max-seconds " + number_text(*seconds) : std::string();
    if (vertices)
        return "--max-vertices " + std::to_string(*vertices) + (seconds ? " or " + seconds_text : "");
    if (seconds)
        return seconds_text;
    return "the number of vertices that memory holds, " + count_text(run.options.max_vertices.value_or(0)) +
           ',';
}

void check_promises(const MeshRun& run)
{
    const std::string output = run.arguments.output.string();
    if (run.status == RunStatus::kPartial)
        throw Error(ExitStatus::kBudget,
                    budget_text(run) + " was reached: " + output + " holds a partial result");
    if (const auto broken = broken_promise(run.facts, run.arguments.border))
        throw Error(ExitStatus::kIncomplete, output + " was written but has " + *broken);
    if (!run.certificate)
        return;
    if (const auto broken = broken_promise(*run.certificate))
        throw Error(ExitStatus::kIncomplete, output + " was written but has " + *broken);
}

} // namespace voroprobe
