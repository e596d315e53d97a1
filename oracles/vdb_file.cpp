#include "oracles/vdb_file.h"

#include <array>
#include <fstream>
#include <new>

#include <openvdb/io/Stream.h>

#include "support/error.h"

namespace voroprobe
{
namespace
{

//! The first bytes of every VDB file: OPENVDB_MAGIC, little endian.
constexpr std::array<char, 4> kMagic{' ', 'B', 'D', 'V'};

InputError input_error(const std::filesystem::path& path, const std::string& reason)
{
    return InputError(path.string() + ": " + reason);
}

std::ifstream open_vdb_file(const std::filesystem::path& path)
{
    std::error_code status;
    if (!std::filesystem::exists(path, status))
        throw input_error(path, "no such file");
    std::ifstream file(path, std::ios::binary);
    std::array<char, kMagic.size()> start{};
    if (std::filesystem::is_directory(path, status) || !file.read(start.data(), start.size()) ||
        start != kMagic)
        throw input_error(path, "not a VDB file");
    file.seekg(0);
    return file;
}

//! By io::Stream, not io::File: the latter takes bytes beyond the end of a truncated file for data without a
//! word.
openvdb::GridPtrVec read_grids(const std::filesystem::path& path)
{
    openvdb::initialize();
    std::ifstream file = open_vdb_file(path);
    try
    {
        file.exceptions(std::ios::failbit | std::ios::badbit | std::ios::eofbit);
        constexpr bool kDelayLoading = false;
        return *openvdb::io::Stream(file, kDelayLoading).getGrids();
    }
    catch (const std::ios::failure&)
    {
        throw input_error(path, "truncated VDB file, its last bytes are missing");
    }
    catch (const openvdb::Exception& error)
    {
        throw input_error(path, std::string("damaged VDB file (") + error.what() + ")");
    }
    catch (const std::length_error&)
    {
        throw input_error(path, "damaged VDB file (absurd sizes)");
    }
}

//! "density [float], v [vec3s]": for messages.
std::string list_of(const openvdb::GridPtrVec& grids)
{
    std::string list;
    for (const auto& grid : grids)
        list += (list.empty() ? "" : ", ") + grid->getName() + " [" + grid->valueType() + "]";
    return list.empty() ? "none" : list;
}

} // namespace

openvdb::FloatGrid::Ptr read_float_grid(const std::filesystem::path& path,
                                        const std::optional<std::string>& name)
{
    const openvdb::GridPtrVec grids = read_grids(path);
    std::vector<openvdb::FloatGrid::Ptr> candidates;
    for (const auto& grid : grids)
        if (const auto float_grid = openvdb::gridPtrCast<openvdb::FloatGrid>(grid))
            if (!name || *name == grid->getName())
                candidates.push_back(float_grid);

    if (candidates.size() == 1)
        return candidates.front();
    if (candidates.empty())
        throw input_error(path,
                          (name ? "no float grid named \"" + *name + "\"" : std::string("no float grid")) +
                              "; grids: " + list_of(grids));
    if (name)
        throw input_error(path, "several float grids named \"" + *name + "\"; grids: " + list_of(grids));
    throw input_error(path, "several float grids, name one with --grid; grids: " + list_of(grids));
}

} // namespace voroprobe
