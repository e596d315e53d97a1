#include <cmath>
#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "io/mesh_reader.h"
#include "mesh/measures.h"
#include "mesh/topology.h"
#include "program_fixture.h"

namespace voroprobe
{
namespace
{

using program::Outcome;
using program::run;

//! Label 1: a ball; label 2: one next to it, and a speck of one voxel; label 7: a bar from border to border.
double label_at(const Point3& p)
{
    if (distance(p, {8, 12, 12}) <= 5.0)
        return 1;
    if (distance(p, {18, 12, 12}) <= 5.0 || p == Point3{2, 2, 2})
        return 2;
    return std::abs(p.y - 21.0) <= 1.0 && std::abs(p.z - 21.0) <= 1.0 ? 7 : 0;
}

class LabelsTest : public ProgramTest
{
protected:
    LabelsTest()
    {
        Phantom labels = ball_phantom();
        labels.field = label_at;
        write_phantom(labels, folder_ / "labels.mha");
    }

    Outcome mesh(std::vector<std::string> more, const std::string& output = "out/{name}.stl")
    {
        std::vector<std::string> arguments{"mesh", folder_ / "labels.mha", "-o", folder_ / output};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }

    void expect_refused(const std::vector<std::string>& more, const std::vector<std::string>& words,
                        const std::string& output = "out/{name}.stl")
    {
        const Outcome outcome = mesh(more, output);
        EXPECT_EQ(outcome.status, 2) << outcome.err;
        EXPECT_TRUE(is_one_error_line(outcome.err)) << outcome.err;
        for (const std::string& word : words)
            EXPECT_NE(outcome.err.find(word), std::string::npos) << word << " is not in: " << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
    }
};

TEST_F(LabelsTest, each_label_becomes_a_closed_mesh_of_its_own_with_its_volume)
{
    for (const std::string smoothing : {"none", "gaussian:1", "antialias"})
    {
        const Outcome outcome =
            mesh({"--labels", "all", "--smooth", smoothing, "--summary", folder_ / "s.json"});
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        const auto summary = nlohmann::json::parse(program::read_text(folder_ / "s.json"));
        EXPECT_EQ(summary.at("status"), "done");
        ASSERT_EQ(summary.at("labels").size(), 3U);
        EXPECT_EQ(summary.at("labels")[1].at("parts_expected"), 2);
        for (const auto& label : summary.at("labels"))
        {
            EXPECT_EQ(label.at("parts_meshed"), label.at("parts_expected"));
            EXPECT_LT(std::abs(label.at("volume_change_percent").get<double>()), 2.0);
            const TriangleMesh read = weld(read_mesh(label.at("path").get<std::string>()));
            EXPECT_TRUE(is_closed_manifold(read));
            EXPECT_EQ(count_components(read), label.at("parts_expected"));
            EXPECT_NEAR(enclosed_volume(read), label.at("voxel_volume_mm3"),
                        0.02 * label.at("voxels").get<double>());
        }
    }
}

TEST_F(LabelsTest, a_mesh_lies_where_its_label_is)
{
    ASSERT_EQ(mesh({"--labels", "1"}, "one.stl").status, 0);
    const Box3 box = bounding_box(read_mesh(folder_ / "one.stl"));
    EXPECT_LT(norm(box.center() - Point3{8, 12, 12}), 0.3);
}

TEST_F(LabelsTest, labels_are_chosen_and_left_out_by_number)
{
    ASSERT_EQ(mesh({"--labels", "1-2,7", "--exclude", "2"}, "{label}.stl").status, 0);
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"1.stl", "7.stl", "ball.mha", "labels.mha"}));
}

TEST_F(LabelsTest, names_come_from_a_table)
{
    program::write_text(folder_ / "names.txt", "1 left/ball\n7 bar\n");
    ASSERT_EQ(mesh({"--labels", "all", "--names", folder_ / "names.txt"}, "{name}.stl").status, 0);
    for (const std::string name : {"left_ball.stl", "label_2.stl", "bar.stl"})
        EXPECT_TRUE(std::filesystem::exists(folder_ / name)) << name;
}

TEST_F(LabelsTest, what_cannot_be_meant_is_refused_before_anything_is_written)
{
    expect_refused({"--labels", "3"}, {"label 3", "1, 2, 7"});
    expect_refused({"--labels", "all", "--exclude", "1-9"}, {"--exclude", "none"});
    expect_refused({"--labels", "one"}, {"--labels", "'one'", "1,5,7-9"});
    expect_refused({"--labels", "all", "--isovalue", "0.5"}, {"--isovalue", "--labels"});
    expect_refused({"--labels", "all", "--smooth", "gaussian:0"}, {"gaussian", "'0'"});
    expect_refused({"--labels", "all", "--smooth", "soft"}, {"--smooth", "'soft'", "antialias"});
    expect_refused({"--labels", "all", "--shared-interfaces", "--smooth", "none"}, {"--smooth", "joint"});
    expect_refused({"--labels", "all", "--size", "1e-6"}, {"--size is 1e-06", "vertices", "at least"});
    expect_refused({"--labels", "all", "--normals"}, {"--normals", "--labels"});
    expect_refused({"--smooth", "none", "--isovalue", "1"}, {"--smooth", "--labels"});
    expect_refused({"--labels", "all"}, {"3 labels", "{name}"}, "out/mesh.stl");
    program::write_text(folder_ / "names.txt", "1 twin\n2 twin\n");
    expect_refused({"--labels", "all", "--names", folder_ / "names.txt"}, {"overwrite", "{label}"});
}

TEST_F(LabelsTest, names_in_latin_1_come_out_right_in_meshes_and_summary)
{
    program::write_text(folder_ / "names.txt", "1 C\xF4te\n2 Sp\xE4ne\n7 bar\n");
    const std::vector<std::string> all{
        "--labels", "all", "--names", folder_ / "names.txt", "--summary", folder_ / "s.json"};
    ASSERT_EQ(mesh(all, "all.3mf").status, 0);
    const std::vector<MeshPart> parts = read_parts(folder_ / "all.3mf");
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_EQ(parts[0].name, "C\xC3\xB4te");
    EXPECT_EQ(nlohmann::json::parse(program::read_text(folder_ / "s.json")).at("labels")[1].at("name"),
              "Sp\xC3\xA4ne");
    ASSERT_EQ(mesh(all, "all.obj").status, 0);
    EXPECT_NE(program::read_text(folder_ / "all.obj").find("g label_1 C\xC3\xB4te\n"), std::string::npos);
}

TEST_F(LabelsTest, no_file_of_a_pattern_overwrites_what_is_read_or_the_summary)
{
    program::write_text(folder_ / "names.txt", "1 labels\n2 names\n7 bar\n");
    const std::vector<std::string> all{"--labels", "all", "--names", folder_ / "names.txt"};
    const auto with = [&](std::vector<std::string> more)
    {
        more.insert(more.begin(), all.begin(), all.end());
        return more;
    };
    const std::string before = program::read_text(folder_ / "labels.mha");
    expect_refused(with({"--format", "stl"}), {"OUTPUT for label 1 and INPUT"}, "{name}.mha");
    expect_refused(with({"--format", "stl"}), {"OUTPUT for label 2 and --names"}, "{name}.txt");
    expect_refused(with({"--summary", folder_ / "bar.stl"}), {"--summary and OUTPUT for label 7"},
                   "{name}.stl");
    expect_refused(with({"--summary", folder_ / "labels.mha"}), {"--summary and INPUT"}, "{name}.stl");
    EXPECT_EQ(program::read_text(folder_ / "labels.mha"), before);
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"ball.mha", "labels.mha", "names.txt"}));
}

TEST_F(LabelsTest, all_labels_go_to_one_file_of_a_format_that_keeps_them_apart)
{
    for (const std::string output : {"all.obj", "all.ply", "all.3mf"})
    {
        ASSERT_EQ(mesh({"--labels", "all"}, output).status, 0);
        const TriangleMesh read = weld(read_mesh(folder_ / output));
        EXPECT_EQ(count_components(read), 4U) << output;
    }
    EXPECT_NE(program::read_text(folder_ / "all.obj").find("g label_7 label_7\n"), std::string::npos);
}

TEST_F(LabelsTest, neighbours_can_share_their_triangles)
{
    const Outcome outcome = mesh({"--labels", "all", "--shared-interfaces", "--summary", folder_ / "s.json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto summary = nlohmann::json::parse(program::read_text(folder_ / "s.json"));
    for (const auto& label : summary.at("labels"))
    {
        EXPECT_TRUE(analyze_topology(weld(read_mesh(label.at("path").get<std::string>()))).closed());
        EXPECT_LT(std::abs(label.at("volume_change_percent").get<double>()), 2.0);
        EXPECT_EQ(label.at("cavities_meshed"), label.at("cavities_expected"));
    }
    EXPECT_EQ(summary.at("totals").at("labels_beyond_2_percent"), 0);
}

//! A 3D Slicer segmentation of two balls that overlap, each in a layer of its own.
void write_overlapping_segments(const std::filesystem::path& path)
{
    std::ofstream file(path, std::ios::binary);
    file << "NRRD0004\ntype: unsigned char\ndimension: 4\nspace: left-posterior-superior\n"
            "sizes: 2 20 16 16\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\n"
            "kinds: list domain domain domain\nencoding: raw\nspace origin: (0,0,0)\n"
            "Segment0_Name:=first\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n"
            "Segment1_Name:=second\nSegment1_LabelValue:=1\nSegment1_Layer:=1\n\n";
    for (int k = 0; k < 16; ++k)
        for (int j = 0; j < 16; ++j)
            for (int i = 0; i < 20; ++i)
                for (const double middle : {7.0, 11.0})
                    file.put(distance({1.0 * i, 1.0 * j, 1.0 * k}, {middle, 8, 8}) <= 5.0 ? 1 : 0);
}

TEST_F(LabelsTest, segments_that_overlap_are_meshed_whole_and_share_no_interfaces)
{
    write_overlapping_segments(folder_ / "s.seg.nrrd");
    std::vector<std::string> arguments{"mesh", folder_ / "s.seg.nrrd",    "--labels", "all",
                                       "-o",   folder_ / "out/{name}.stl"};
    ASSERT_EQ(run(arguments).status, 0);
    const double first = enclosed_volume(read_mesh(folder_ / "out/first.stl"));
    EXPECT_NEAR(first, enclosed_volume(read_mesh(folder_ / "out/second.stl")), 0.01 * first);
    EXPECT_NEAR(first, 515.0, 0.02 * 515.0); // voxels within 5 of the middle one
    arguments.push_back("--shared-interfaces");
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find("2 layers"), std::string::npos) << outcome.err;
    arguments.insert(arguments.end(), {"--frame", "1"});
    EXPECT_EQ(run(arguments).status, 0);
}

TEST_F(LabelsTest, a_scan_is_not_taken_for_a_label_map)
{
    const Outcome outcome =
        run({"mesh", folder_ / "ball.mha", "--labels", "all", "-o", folder_ / "{label}.stl"});
    EXPECT_EQ(outcome.status, 3) << outcome.err;
    EXPECT_NE(outcome.err.find("whole numbers"), std::string::npos) << outcome.err;
}

//! Whole numbers that differ from voxel to voxel: 13,824 of them.
double number_of_voxel(const Point3& p)
{
    return 1.0 + p.x + 24.0 * (p.y + 24.0 * p.z);
}

TEST_F(LabelsTest, a_scan_of_whole_numbers_or_too_many_labels_are_refused_with_their_count_and_the_way_on)
{
    Phantom scan = ball_phantom();
    scan.field = [](const Point3& p) { return std::fmod(number_of_voxel(p) * 7919.0, 1000.0); };
    write_phantom(scan, folder_ / "labels.mha");
    expect_refused({"--labels", "all"},
                   {"999 labels", "gray-level scan", "--isovalue", "100 labels", "--max-labels 999"});
    expect_refused({"--labels", "1-101"}, {"101 labels", "--max-labels 101"});
    EXPECT_EQ(mesh({"--labels", "1-3"}).status, 0); // few are soon meshed
    std::filesystem::remove_all(folder_ / "out");

    Phantom pairs = ball_phantom();
    pairs.size[0] = 48;
    pairs.field = [](const Point3& p) { return number_of_voxel({std::floor(p.x / 2), p.y, p.z}); };
    write_phantom(pairs, folder_ / "labels.mha");
    expect_refused({"--labels", "all"}, {"13,824 labels", "10,000 labels", "--max-labels 13824"});
    // Columns along x, so that neighbours are equal.
    Phantom columns = ball_phantom();
    columns.field = [](const Point3& p) { return 1.0 + p.y + 24.0 * p.z; };
    write_phantom(columns, folder_ / "labels.mha");
    expect_refused({"--labels", "all", "--max-labels", "500"},
                   {"576 labels", "500 labels", "--max-labels 576"});
    expect_refused({"--labels", "all", "--max-labels", "0"}, {"--max-labels", "'0'"});
    expect_refused({"--isovalue", "1", "--max-labels", "5"}, {"--max-labels", "--labels"});
    EXPECT_EQ(mesh({"--labels", "all", "--max-labels", "576"}, "all.ply").status, 0);
}

TEST_F(LabelsTest, any_number_of_threads_gives_the_same_bytes)
{
    ASSERT_EQ(mesh({"--labels", "all", "--threads", "1"}, "a{label}.stl").status, 0);
    ASSERT_EQ(mesh({"--labels", "all", "--threads", "3"}, "b{label}.stl").status, 0);
    for (const std::string label : {"1", "2", "7"})
        EXPECT_EQ(program::read_text(folder_ / ("a" + label + ".stl")),
                  program::read_text(folder_ / ("b" + label + ".stl")));
}

TEST_F(LabelsTest, a_map_without_labels_is_an_empty_surface)
{
    Phantom empty = ball_phantom();
    empty.field = [](const Point3&) { return 0.0; };
    write_phantom(empty, folder_ / "labels.mha");
    EXPECT_EQ(mesh({"--labels", "all"}).status, 4);
}

} // namespace
} // namespace voroprobe
