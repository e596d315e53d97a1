#include "compare/contest_outcome.h"

#include <algorithm>

#include "compare/picture.h"

namespace voroprobe
{

namespace
{

using Json = nlohmann::ordered_json;

//! Views of fewer faces would show nothing.
constexpr std::size_t kFewestFacesShown = 50000;

//! What a child sends, in this order.
enum Part : std::size_t
{
    kFacts,
    kView,
    kViewFacts,
    kPicture
};

Json entry_json(const ContestantEntry& entry, const char* status)
{
    return {
        {"name", entry.name}, {"title", entry.title}, {"description", entry.description}, {"status", status}};
}

} // namespace

ContestantOutcome failed_outcome(const ContestantEntry& entry, const std::string& reason)
{
    ContestantOutcome outcome{
        .entry = entry, .report = entry_json(entry, "failed"), .view = {}, .picture = {}};
    outcome.report["reason"] = reason;
    return outcome;
}

void send_facts(const nlohmann::ordered_json& facts, ChildOutput& output)
{
    output.send(facts.dump());
}

void send_view(const ViewMesh& view, double voxel, ChildOutput& output)
{
    output.send(pack(view, kLongestDistanceInVoxels * voxel));
    const Json facts = {{"faces", view.mesh.faces.size()},
                        {"faces_of_whole", view.faces_of_whole},
                        {"decimated", view.decimated()}};
    output.send(facts.dump());
}

void send_picture(const TriangleMesh& mesh, const Box3& box, ChildOutput& output)
{
    output.send(draw_picture(mesh, box));
}

ContestantOutcome received_outcome(const ContestantEntry& entry, const ChildResult& result, bool pictures)
{
    const std::string reason = result.failure.value_or("it sent nothing");
    if (result.parts.size() <= kFacts)
        return failed_outcome(entry, reason);
    ContestantOutcome outcome{.entry = entry, .report = entry_json(entry, "done"), .view = {}, .picture = {}};
    outcome.report.update(Json::parse(result.parts[kFacts]));
    if (result.parts.size() > kViewFacts)
    {
        outcome.view = result.parts[kView];
        outcome.report["view"] = Json::parse(result.parts[kViewFacts]);
    }
    else
        outcome.report["view"] = {{"missing", reason}};
    if (result.parts.size() > kPicture)
        outcome.picture = result.parts[kPicture];
    else if (pictures)
        outcome.report["picture_missing"] = reason;
    return outcome;
}

std::size_t file_size_stl(std::size_t faces)
{
    return 84 + 50 * faces; // header and count, 50 bytes a face
}

std::size_t faces_per_view(std::size_t faces_shown, std::size_t views)
{
    return std::max(kFewestFacesShown, faces_shown / std::max<std::size_t>(views, 1));
}

} // namespace voroprobe
