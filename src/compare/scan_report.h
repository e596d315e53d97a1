#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/competition_options.h"
#include "compare/contestant_list.h"
#include "compare/label_contestant.h"
#include "compare/reference_surface.h"

namespace voroprobe
{

//! What the report tells of a scan and of the run beside what comes out.
struct ScanFacts
{
    std::string name;                //!< of the file or folder
    std::string path;                //!< as it was given
    std::string format;              //!< "NRRD", ...
    std::string stored_type;         //!< "int16", ...
    std::array<std::size_t, 3> size; //!< voxels along the axes of the file
    Vec3 spacing;                    //!< mm, likewise
    double min = 0.0;                //!< over the finite samples; not told of label maps, as the next two
    double max = 0.0;
    std::string isovalue_source = {}; //!< "given", "Otsu", ...
    std::vector<std::string> warnings;
    std::string version;                                   //!< of this program
    std::string command;                                   //!< that made the report
    std::string date;                                      //!< YYYY-MM-DD
    std::string stem;                                      //!< names of files beside the page begin with it
    std::optional<std::string> no_pictures = std::nullopt; //!< why there are none, where they were wanted
};

//! Everything that is written of one scan.
struct ScanReport
{
    std::string headline;
    std::string json; //!< all there is; what follows is taken from it
    std::string csv;
    std::string markdown;
    std::string table;                                         //!< for a terminal
    std::string page;                                          //!< HTML
    std::vector<std::pair<std::string, std::string>> pictures; //!< file name and PNG
};

//! Runs the contestants and tells of them. Cost: theirs. \pre as compete().
ScanReport make_scan_report(const ScanFacts& facts, const std::vector<ContestantEntry>& entries,
                            const MeshingTask& task, const ReferenceSurface& reference,
                            const CompetitionOptions& options);

//! The same of a label map, label by label. Equal accuracy is left out: marching cubes gives the staircase of
//! the voxels itself, which nobody wants a label's mesh to come near to.
ScanReport make_label_report(const ScanFacts& facts, const std::vector<LabelContestantEntry>& entries,
                             const LabelTask& task, const CompetitionOptions& options);

//! A page that lists others, with totals: one row for each, given as its file name and its JSON.
std::string report_index(const std::vector<std::pair<std::string, std::string>>& pages);

} // namespace voroprobe
