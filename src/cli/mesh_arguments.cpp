#include "cli/mesh_arguments.h"

#include <CLI/CLI.hpp>

#include "cli/option_group.h"
#include "cli/option_values.h"
#include "cli/read_arguments.h"

namespace voroprobe
{

namespace
{

void add_surface_options(CLI::App& command, MeshArguments& arguments)
{
    OptionGroup group(command, "Surface");
    group.text("--implicit", "FORMULA",
               "In place of INPUT: where a formula in x, y and z, mm, has the\nisovalue, 'x^2+y^2+z^2-100'",
               [&arguments](const std::string& given) { arguments.formula = given; });
    group.text(
        "--domain", "box:x0,y0,z0,x1,y1,z1|ball:cx,cy,cz,r",
        "Where to look for the surface of a formula, mm; it is closed at\nthe border (required with it)",
        [&arguments](const std::string& given) { arguments.domain = given; });
    group.isovalue(arguments.isovalue,
                   "Value of the samples at the surface (default auto: Otsu's\nthreshold; 0 for a formula)");
    group.inside(arguments.inside,
                 "Side of the isovalue the object lies on (default auto: below for\nlevel sets in .vdb "
                 "files and formulas, above otherwise)");
    group.choice(
        "--border", arguments.border,
        Words<BorderFaces>{{"closed", BorderFaces::kClosed}, {"open", BorderFaces::kOpen}},
        "Where the object leaves the volume: close it there, or leave\nthose faces out (default closed)");
}

void add_criteria(CLI::App& command, MeshArguments& arguments)
{
    OptionGroup group(command,
                      "Criteria (v: shortest side of a voxel; m: side of the cube of a voxel's volume; "
                      "without voxels both are 1 % of the diagonal)");
    RequestedCriteria& criteria = arguments.criteria;
    group.number("--size", "MM", criteria.size, kLength, "Largest radius of a face's ball, mm (default 2 m)");
    group.text("--angle", "DEG", "Smallest angle of a face, degrees, 0 to 30 (default 30)",
               [&criteria](const std::string& given)
               { criteria.angle_deg = parse_number("--angle", given, kFacetAngle); });
    group.number("--distance", "MM", criteria.distance, kLength,
                 "Largest distance from a face's circumcenter to the surface, mm\n(default 0.3 v)");
    group.number("--floor", "MM", criteria.floor, kLength,
                 "Balls this small are refined no further, mm (default 0.25 v, at\nmost half of --size)");
    group.number(
        "--reach", "MM", criteria.reach, kLength,
        "What is thinner or closer than this may be missed; sets the\nspacing of probes, mm (default 1 v)");
    group.choice("--isolated", arguments.isolated_vertices,
                 Words<IsolatedVertices>{{"one", IsolatedVertices::kOneAtATime},
                                         {"all", IsolatedVertices::kAllAtOnce}},
                 "Isolated vertices to begin new surfaces at before each\nrefinement: one is leaner, all is "
                 "quicker (default all)");
    group.text("--max-vertices", "N",
               "Stop there, write what there is and exit with 6 (default: what memory holds)",
               [&arguments](const std::string& given)
               { arguments.max_vertices = parse_count("--max-vertices", given, 1); });
}

void add_selection(CLI::App& command, MeshArguments& arguments)
{
    OptionGroup group(command, "Surfaces to leave out, on purpose (default: none; listed in the report)");
    SurfaceSelection& selection = arguments.selection;
    group.number("--min-component-volume", "MM3", selection.min_enclosed_volume, kVolume,
                 "Those that enclose less, by their voxels, mm3");
    group.text("--keep-largest", "N", "All but the N objects that enclose most, and their cavities",
               [&selection](const std::string& given)
               { selection.keep_largest = parse_count("--keep-largest", given, 1); });
    command.add_flag("--drop-cavities", selection.drop_cavities, "Cavities, and what floats in them")
        ->group("Surfaces to leave out, on purpose (default: none; listed in the report)");
}

void add_output_options(CLI::App& command, MeshArguments& arguments)
{
    OptionGroup group(command, "Output");
    group.text("-o,--output", "FILE",
               "Mesh to write: .stl .ply .obj .off .vtp .3mf (required); for several\nlabels a pattern with "
               "{name} or {label}",
               [&arguments](const std::string& given) { arguments.output = given; });
    group.text("--format", "NAME", "stl, stl-ascii, ply, obj, off, vtp or 3mf (default: by the extension)",
               [&arguments](const std::string& given) { arguments.format = given; });
    group.choice("--frame-of-reference", arguments.frame,
                 Words<OutputFrame>{
                     {"lps", OutputFrame::kLps}, {"ras", OutputFrame::kRas}, {"index", OutputFrame::kIndex}},
                 "Coordinates: lps or ras in mm, or voxels of the file (default lps)");
    command.add_flag("--normals", arguments.normals, "Write a normal for each vertex (.ply, .obj, .vtp)")
        ->group("Output");
    group.text("--summary", "FILE.json", "Write what was done and found as JSON",
               [&arguments](const std::string& given) { arguments.summary = given; });
}

void add_run_options(CLI::App& command, MeshArguments& arguments)
{
    OptionGroup group(command, "Run");
    group.choice("--progress", arguments.progress,
                 Words<ProgressMode>{{"auto", ProgressMode::kAuto},
                                     {"bar", ProgressMode::kBar},
                                     {"json", ProgressMode::kJson},
                                     {"none", ProgressMode::kNone}},
                 "How to show progress on stderr (default auto: a bar on a terminal)");
    group.text("--seed", "N", "Of the rays of --seeding random:N; nothing else is random\n(default 0)",
               [&arguments](const std::string& given) { arguments.seed = parse_count("--seed", given, 0); });
    group.text("--threads", "N",
               "Threads that work side by side; any number gives the same bytes\n(default: all processors)",
               [&arguments](const std::string& given)
               { arguments.threads = parse_count("--threads", given, 1); });
    command
        .add_flag("-q,--quiet", arguments.quiet, "No report on stdout and no automatic bar; warnings stay")
        ->group("Run");
}

} // namespace

void add_mesh_arguments(CLI::App& command, MeshArguments& arguments)
{
    command
        .add_option("INPUT", arguments.input,
                    "Volume: a file, or a folder with a DICOM series or TIFF slices; or a closed mesh\n"
                    "(.stl .ply .obj .off .vtp .3mf) or points with normals (.xyz) to mesh anew")
        ->type_name("");
    add_surface_options(command, arguments);
    add_label_options(command, arguments.label_map);
    add_label_mesh_options(command, arguments.label_map);
    add_criteria(command, arguments);
    add_selection(command, arguments);
    add_finish_options(command, arguments.finish, OffersSmoothing::kNo);
    add_seeding_options(command, arguments.finding);
    add_output_options(command, arguments);
    add_read_options(command, arguments.read);
    add_run_options(command, arguments);
}

} // namespace voroprobe
