//! Files whose numbers lie: each is read or refused in one line, without output and without the memory it
//! asks for.

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetSphere.h>

#include "oracles/vdb_oracle.h"
#include "support/error.h"
#include "support/memory.h"

namespace voroprobe
{
namespace
{

using openvdb::FloatGrid;

class DamagedVdb : public testing::Test
{
protected:
    void SetUp() override
    {
        openvdb::initialize();
        std::string folder = (std::filesystem::temp_directory_path() / "voroprobe_vdb_XXXXXX").string();
        ASSERT_NE(mkdtemp(folder.data()), nullptr);
        folder_ = folder;
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    //! The bytes of a file with these grids.
    [[nodiscard]] std::string file_of(const openvdb::GridPtrVec& grids) const
    {
        const auto path = folder_ / "whole.vdb";
        openvdb::io::File(path.string()).write(grids);
        std::ostringstream bytes;
        bytes << std::ifstream(path, std::ios::binary).rdbuf();
        return bytes.str();
    }

    //! What reading these bytes is refused with, "" where it is not; fails where anything is printed.
    [[nodiscard]] std::string refusal(const std::string& bytes, const VdbOptions& options = {}) const
    {
        const auto path = folder_ / "damaged.vdb";
        std::ofstream(path, std::ios::binary) << bytes;
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        std::string message;
        try
        {
            read_vdb_surface(path, options);
        }
        catch (const InputError& error)
        {
            message = error.what();
        }
        catch (const std::exception& error)
        {
            ADD_FAILURE() << "not an InputError: " << error.what();
        }
        EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        return message;
    }

private:
    std::filesystem::path folder_;
};

//! Away from the origin, where eight branches of the tree meet.
FloatGrid::Ptr ball(const std::string& name)
{
    const auto grid = openvdb::tools::createLevelSetSphere<FloatGrid>(6.0F, {30, 31, 32}, 1.0F);
    grid->setName(name);
    grid->insertMeta("author", openvdb::StringMetadata("nobody"));
    return grid;
}

template <class Number>
std::string with_number(std::string bytes, std::size_t at, Number number)
{
    std::memcpy(bytes.data() + at, &number, sizeof(Number));
    return bytes;
}

//! Where the tree of a file's only grid begins: behind the map of its transform, five vectors of doubles.
std::size_t start_of_tree(const std::string& bytes)
{
    const std::string map = "UniformScaleMap";
    return bytes.find(map) + map.size() + 5 * 3 * sizeof(double);
}

void expect_has(const std::string& message, const std::string& part)
{
    EXPECT_NE(message.find(part), std::string::npos) << "\"" << part << "\" is not in: " << message;
}

TEST_F(DamagedVdb, any_number_of_the_header_may_lie_without_costing_memory)
{
    const std::string whole = file_of({ball("ball")});
    ASSERT_EQ(refusal(whole), "");
    const std::size_t end = start_of_tree(whole);
    ASSERT_LT(end, whole.size());
    const std::size_t before = peak_memory_bytes();
    std::size_t refused = 0;
    for (const std::uint32_t lie : {0x7fffffffU, 0xffffffffU, 0U, 0x00100000U})
        for (std::size_t at = 0; at < end; ++at)
        {
            SCOPED_TRACE(std::to_string(lie) + " at byte " + std::to_string(at));
            refused += !refusal(with_number(whole, at, lie)).empty();
        }
    EXPECT_GT(refused, end);
    // A quarter of what the largest lies ask for; sanitizers keep freed memory for a while.
    constexpr std::size_t kAllowedGrowth = std::size_t{512} << 20U;
    EXPECT_LT(peak_memory_bytes(), before + kAllowedGrowth);
}

TEST_F(DamagedVdb, a_length_beyond_the_end_is_told_with_its_place)
{
    const std::string whole = file_of({ball("ball")});
    const std::size_t author = whole.find("nobody") - sizeof(std::uint32_t);
    const std::string message = refusal(with_number(whole, author, 0x7fffffffU));
    expect_has(message, "2147483647 bytes announced before byte " + std::to_string(author + 4));
    expect_has(message, "expected at most the " + std::to_string(whole.size() - author - 4));
}

TEST_F(DamagedVdb, an_unknown_version_is_refused)
{
    const std::string whole = file_of({ball("ball")});
    expect_has(refusal(with_number(whole, sizeof(std::int64_t), 1000U)), "version 1000, expected 216 to 224");
}

TEST_F(DamagedVdb, a_tree_of_several_buffers_is_refused)
{
    const std::string whole = file_of({ball("ball")});
    expect_has(refusal(with_number(whole, start_of_tree(whole), 7)), "7 buffers, expected 1");
}

TEST_F(DamagedVdb, a_fixed_size_is_that_of_its_type)
{
    const std::string whole = file_of({ball("ball")});
    const std::size_t size = whole.find("vec3i") + std::strlen("vec3i");
    expect_has(refusal(with_number(whole, size, 16)), "type vec3i with 16 bytes, expected 12");
}

TEST_F(DamagedVdb, grids_of_other_types_are_passed_over_unread)
{
    const auto velocity = openvdb::Vec3SGrid::create();
    velocity->setName("velocity");
    velocity->insertMeta("author", openvdb::StringMetadata("somebody"));
    const std::string whole = file_of({velocity, ball("ball")});
    const std::size_t author = whole.find("somebody") - sizeof(std::uint32_t);
    EXPECT_EQ(refusal(with_number(whole, author, 0x7fffffffU)), "");
    expect_has(refusal(whole, {.grid = "heat"}), "grids: velocity [vec3s], ball [float]");
}

TEST_F(DamagedVdb, grids_that_share_a_tree_are_both_read)
{
    const auto first = ball("first");
    const FloatGrid::Ptr second = first->copy();
    second->setName("second");
    const std::string whole = file_of({first, second});
    EXPECT_EQ(refusal(whole, {.grid = "first"}), "");
    EXPECT_EQ(refusal(whole, {.grid = "second"}), "");
}

TEST_F(DamagedVdb, files_without_offsets_and_frustums_are_read_too)
{
    const auto frustum = ball("frustum");
    frustum->setTransform(openvdb::math::Transform::createFrustumTransform(
        openvdb::BBoxd(openvdb::Vec3d(0, 0, 0), openvdb::Vec3d(10, 10, 10)), 0.5, 2.0, 1.0));
    std::ostringstream stream;
    openvdb::io::Stream(stream).write(
        openvdb::GridCPtrVec{openvdb::Vec3SGrid::create(), frustum, ball("ball")});
    EXPECT_EQ(refusal(stream.str(), {.grid = "ball"}), "");
}

} // namespace
} // namespace voroprobe
