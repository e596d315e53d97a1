#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

#include "../mesh/sample_meshes.h"
#include "io/atomic_file.h"
#include "io/mesh_reader.h"
#include "io/mesh_writer.h"
#include "support/error.h"
#include "temporary_folder.h"

namespace voroprobe
{
namespace
{

namespace fs = std::filesystem;

using sample::icosphere;
using sample::tetrahedron;

constexpr MeshFormat kAllFormats[] = {MeshFormat::kStlBinary, MeshFormat::kStlAscii, MeshFormat::kPly,
                                      MeshFormat::kObj,       MeshFormat::kOff,      MeshFormat::kVtp,
                                      MeshFormat::k3mf};

std::size_t count_files(const fs::path& folder)
{
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

//! The message of the error that `action` throws; empty when it throws none of that type.
template <typename ErrorType, typename Action>
std::string message_of(Action action)
{
    try
    {
        action();
    }
    catch (const ErrorType& error)
    {
        return error.what();
    }
    return "";
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

//! The last three of the numbers in each line that begins with a word.
std::vector<Vec3> vectors_in_lines(const fs::path& path, const std::string& word)
{
    std::vector<Vec3> result;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);)
        if (line.starts_with(word + ' '))
        {
            Vec3 v;
            std::istringstream(line.substr(word.size())) >> v.x >> v.y >> v.z;
            result.push_back(v);
        }
    return result;
}

// ---- Formats ----

TEST(MeshFormat, is_told_by_the_extension_in_any_case)
{
    EXPECT_EQ(mesh_format("a/b.stl"), MeshFormat::kStlBinary);
    EXPECT_EQ(mesh_format("B.STL"), MeshFormat::kStlBinary);
    EXPECT_EQ(mesh_format("b.Ply"), MeshFormat::kPly);
    EXPECT_EQ(mesh_format("b.obj"), MeshFormat::kObj);
    EXPECT_EQ(mesh_format("b.off"), MeshFormat::kOff);
    EXPECT_EQ(mesh_format("b.x.vtp"), MeshFormat::kVtp);
}

TEST(MeshFormat, a_name_overrides_the_extension)
{
    EXPECT_EQ(mesh_format("b.stl", "stl-ascii"), MeshFormat::kStlAscii);
    EXPECT_EQ(mesh_format("b.dat", "OFF"), MeshFormat::kOff);
}

TEST(MeshFormat, an_unknown_one_is_a_usage_error_that_lists_the_known)
{
    for (const auto& message : {message_of<UsageError>([] { mesh_format("mesh.xyz"); }),
                                message_of<UsageError>([] { mesh_format("mesh"); }),
                                message_of<UsageError>([] { mesh_format("mesh.stl", "gltf"); })})
        for (const char* name : {"stl", "stl-ascii", "ply", "obj", "off", "vtp"})
            EXPECT_TRUE(contains(message, name)) << message;
    EXPECT_TRUE(contains(message_of<UsageError>([] { mesh_format("mesh.stl", "gltf"); }), "'gltf'"));
    EXPECT_TRUE(contains(message_of<UsageError>([] { mesh_format("mesh.xyz"); }), "'.xyz'"));
    EXPECT_THROW(mesh_format("mesh.stl", ""), UsageError);
}

// ---- Contents ----

TEST(MeshWriter, a_binary_stl_says_its_size_and_does_not_pose_as_text)
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "mesh.stl";
    write_mesh(icosphere(1), path, MeshFormat::kStlBinary, {"solid work", "units: mm"});

    const std::string content = content_of(path);
    ASSERT_EQ(content.size(), 84U + 50U * 80U);
    EXPECT_FALSE(content.starts_with("solid"));
    EXPECT_TRUE(contains(content.substr(0, 80), "units: mm"));
    std::uint32_t faces = 0;
    std::memcpy(&faces, content.data() + 80, 4);
    EXPECT_EQ(faces, 80U);
}

TEST(MeshWriter, a_face_without_area_has_the_normal_0_0_0_in_a_binary_stl)
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "mesh.stl";
    TriangleMesh mesh = tetrahedron();
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const double x : {5.0, 6.0, 7.0})
        mesh.vertices.push_back({x, 0, 0});
    mesh.faces.push_back({first, first + 1, first + 2});
    write_mesh(mesh, path, MeshFormat::kStlBinary);

    const std::string content = content_of(path);
    ASSERT_EQ(content.size(), 84U + 50U * 5U);
    for (std::size_t face = 0; face < 5; ++face)
    {
        std::array<float, 3> normal{};
        std::memcpy(normal.data(), content.data() + 84 + 50 * face, sizeof normal);
        const float length = std::hypot(normal[0], normal[1], normal[2]);
        EXPECT_NEAR(length, face < 4 ? 1.0 : 0.0, 1e-6);
    }
}

TEST(MeshWriter, an_ascii_stl_is_one_named_solid)
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "mesh.stl";
    write_mesh(tetrahedron(), path, MeshFormat::kStlAscii, {"voroprobe 1.0", "units: mm"});
    EXPECT_TRUE(content_of(path).starts_with("solid voroprobe 1.0; units: mm\nfacet normal "));
    EXPECT_TRUE(contains(content_of(path), "endsolid"));
}

TEST(MeshWriter, comments_are_where_ply_obj_and_vtp_have_them)
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "mesh";
    const std::vector<std::string> comments{"units: mm", "two\nlines"};
    write_mesh(tetrahedron(), path, MeshFormat::kPly, comments);
    EXPECT_TRUE(content_of(path).starts_with(
        "ply\nformat binary_little_endian 1.0\ncomment units: mm\ncomment two lines\nelement vertex 4\n"));
    write_mesh(tetrahedron(), path, MeshFormat::kObj, comments);
    EXPECT_TRUE(content_of(path).starts_with("# units: mm\n# two lines\n"));
    write_mesh(tetrahedron(), path, MeshFormat::kVtp, comments);
    EXPECT_TRUE(contains(content_of(path), "Name=\"comments\""));
}

TEST(MeshWriter, normals_are_written_where_the_format_has_them_and_the_mesh_stays)
{
    const TemporaryFolder folder;
    const TriangleMesh ball = icosphere(2, 10.0);
    for (const MeshFormat format : kAllFormats)
    {
        const fs::path path = folder.path() / "ball.mesh";
        const auto write = [&] { write_mesh(ball, path, format, {}, {}, VertexNormals::kWritten); };
        if (!holds_normals(format))
        {
            EXPECT_TRUE(contains(message_of<UsageError>(write), "normals"));
            continue;
        }
        write();
        const fs::path named = folder.path() / (format == MeshFormat::kPly   ? "ball.ply"
                                                : format == MeshFormat::kObj ? "ball.obj"
                                                                             : "ball.vtp");
        fs::rename(path, named);
        const TriangleMesh read = read_mesh(named);
        EXPECT_EQ(read.vertices.size(), ball.vertices.size());
        EXPECT_EQ(read.faces.size(), ball.faces.size());
    }
    const std::vector<Vec3> normals = vectors_in_lines(folder.path() / "ball.obj", "vn");
    ASSERT_EQ(normals.size(), ball.vertices.size());
    for (std::size_t v = 0; v < normals.size(); ++v) // of a ball: away from its middle
        EXPECT_LT(norm(normals[v] - normalized(ball.vertices[v])), 0.02);
}

TEST(MeshWriter, the_same_mesh_gives_the_same_bytes)
{
    const TemporaryFolder folder;
    for (const MeshFormat format : kAllFormats)
    {
        write_mesh(icosphere(2), folder.path() / "a", format, {"units: mm"});
        write_mesh(icosphere(2), folder.path() / "b", format, {"units: mm"});
        EXPECT_EQ(content_of(folder.path() / "a"), content_of(folder.path() / "b"));
    }
}

TEST(MeshWriter, nothing_is_printed)
{
    const TemporaryFolder folder;
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    for (const MeshFormat format : kAllFormats)
        write_mesh(icosphere(1), folder.path() / "mesh", format);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(MeshWriter, numbers_are_written_with_points_whatever_the_locale)
{
    struct CommaPoint : std::numpunct<char>
    {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const TemporaryFolder folder;
    TriangleMesh mesh = tetrahedron();
    mesh.vertices[1].x = 12345.5;
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaPoint));
    for (const MeshFormat format : {MeshFormat::kStlAscii, MeshFormat::kObj, MeshFormat::kOff})
    {
        write_mesh(mesh, folder.path() / "mesh", format);
        EXPECT_TRUE(contains(content_of(folder.path() / "mesh"), "12345.5 0 0\n"));
    }
    std::locale::global(before);
}

TEST(MeshWriter, the_number_of_nudged_vertices_is_reported)
{
    const TemporaryFolder folder;
    TriangleMesh mesh = icosphere(2, 10.0);
    sample::append(mesh, mesh, {0, 0, 20.0 + 1e-9});
    EXPECT_EQ(write_mesh(mesh, folder.path() / "mesh", MeshFormat::kStlBinary).vertices_nudged, 1U);
    EXPECT_EQ(write_mesh(mesh, folder.path() / "mesh", MeshFormat::kVtp).vertices_nudged,
              0U); // 64-bit floats
}

// ---- Whole or not at all ----

TEST(MeshWriter, an_older_file_is_replaced_and_nothing_is_left_beside_it)
{
    const TemporaryFolder folder;
    const auto path = folder.file("mesh.obj", "old");
    fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
    write_mesh(tetrahedron(), path, MeshFormat::kObj);
    EXPECT_TRUE(contains(content_of(path), "f 1 3 2"));
    EXPECT_EQ(count_files(folder.path()), 1U);
    EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(MeshWriter, a_symbolic_link_stays_a_link)
{
    const TemporaryFolder folder;
    const auto path = folder.file("mesh.obj", "old");
    fs::create_symlink("mesh.obj", folder.path() / "link.obj");
    write_mesh(tetrahedron(), folder.path() / "link.obj", MeshFormat::kObj);
    EXPECT_TRUE(fs::is_symlink(folder.path() / "link.obj"));
    EXPECT_TRUE(contains(content_of(path), "f 1 3 2"));
}

//! Files of this process may not grow beyond a size while an object of this kind lives: a full disk, as far
//! as we can tell.
class FileSizeLimit
{
public:
    explicit FileSizeLimit(rlim_t bytes)
    {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit()
    {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit before_{};
    void (*handler_)(int) = nullptr;
};

TEST(MeshWriter, a_full_disk_is_told_and_leaves_the_older_file_alone)
{
    const TemporaryFolder folder;
    const TriangleMesh mesh = icosphere(4);
    for (const MeshFormat format : kAllFormats)
        for (const rlim_t bytes : {0, 100, 10'000, 50'000})
        {
            const auto path = folder.file("mesh", "old");
            testing::internal::CaptureStderr();
            const std::string message = [&]
            {
                const FileSizeLimit limit(bytes);
                return message_of<OutputError>([&] { write_mesh(mesh, path, format); });
            }();
            EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
            EXPECT_TRUE(contains(message, path.string() + "': File too large")) << message;
            EXPECT_EQ(content_of(path), "old");
            EXPECT_EQ(count_files(folder.path()), 1U);
        }
}

TEST(MeshWriter, a_mesh_that_cannot_be_written_leaves_the_older_file_alone)
{
    const TemporaryFolder folder;
    const auto path = folder.file("mesh", "old");
    TriangleMesh not_finite = tetrahedron();
    not_finite.vertices[2].y = std::numeric_limits<double>::quiet_NaN();
    TriangleMesh out_of_range = tetrahedron();
    out_of_range.faces[3][2] = 4;
    for (const MeshFormat format : kAllFormats)
    {
        EXPECT_THROW(write_mesh(not_finite, path, format), OutputError);
        EXPECT_THROW(write_mesh(out_of_range, path, format), OutputError);
    }
    EXPECT_EQ(content_of(path), "old");
    EXPECT_EQ(count_files(folder.path()), 1U);
}

TEST(MeshWriter, a_last_look_that_throws_leaves_the_older_file_alone)
{
    const TemporaryFolder folder;
    const fs::path path = folder.file("m.ply", "precious");
    const auto change_of_mind = [&]
    {
        EXPECT_EQ(count_files(folder.path()), 2U) << "the new file is there, whole";
        throw UsageError("no, thanks");
    };
    EXPECT_THROW(write_mesh(icosphere(1), path, MeshFormat::kPly, {}, change_of_mind), UsageError);
    EXPECT_EQ(content_of(path), "precious");
    EXPECT_EQ(count_files(folder.path()), 1U);
}

TEST(AtomicFile, an_unfinished_one_can_be_removed_and_a_finished_one_cannot)
{
    const TemporaryFolder folder;
    {
        AtomicFile file(folder.path() / "m.ply");
        EXPECT_TRUE(fs::exists(file.temporary()));
        remove_unfinished_file();
        EXPECT_EQ(count_files(folder.path()), 0U);
    }
    AtomicFile file(folder.path() / "m.ply");
    file.commit();
    remove_unfinished_file();
    EXPECT_TRUE(fs::exists(folder.path() / "m.ply"));
}

// ---- Told before ----

TEST(CheckWritable, a_usable_path_passes_and_nothing_is_left)
{
    const TemporaryFolder folder;
    check_writable(folder.path() / "mesh.stl");
    EXPECT_EQ(count_files(folder.path()), 0U);
    check_writable(folder.file("old.stl", "old"));
    EXPECT_EQ(content_of(folder.path() / "old.stl"), "old");
    EXPECT_EQ(count_files(folder.path()), 1U);
    check_writable(folder.path() / (std::string(250, 'x') + ".stl"));
}

TEST(CheckWritable, every_obstacle_has_its_reason)
{
    const TemporaryFolder folder;
    const auto reason = [](const fs::path& path)
    { return message_of<OutputError>([&] { check_writable(path); }); };
    const fs::path file = folder.file("a_file", "");
    fs::create_directory(folder.path() / "a_folder.stl");
    EXPECT_TRUE(contains(reason(folder.path() / "missing" / "mesh.stl"), "does not exist"));
    EXPECT_TRUE(contains(reason(file / "mesh.stl"), "is not a folder"));
    EXPECT_TRUE(contains(reason(folder.path() / "a_folder.stl"), "it is a folder"));
    EXPECT_TRUE(contains(reason(folder.path() / ""), "it is a folder"));
    EXPECT_TRUE(contains(reason("/dev/null"), "not a regular file"));
    EXPECT_TRUE(contains(reason(folder.path() / (std::string(300, 'x') + ".stl")), "File name too long"));
}

TEST(CheckWritable, protected_folders_and_files_are_refused)
{
    if (::geteuid() == 0)
        GTEST_SKIP() << "permissions do not bind root";
    const TemporaryFolder folder;
    const auto path = folder.file("old.stl", "old");
    fs::permissions(path, fs::perms::owner_read);
    EXPECT_THROW(check_writable(path), OutputError);
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_THROW(check_writable(folder.path() / "mesh.stl"), OutputError);
    fs::permissions(folder.path(), fs::perms::owner_all);
}

} // namespace
} // namespace voroprobe
