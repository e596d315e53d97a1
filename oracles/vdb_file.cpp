#include "oracles/vdb_file.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <new>

#include <openvdb/io/Archive.h>
#include <openvdb/io/DelayedLoadMetadata.h>
#include <openvdb/io/GridDescriptor.h>

#include "oracles/vdb_header.h"
#include "support/error.h"
#include "support/memory.h"

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
    if (!file)
        throw input_error(path, std::strerror(errno));
    std::array<char, kMagic.size()> start{};
    if (std::filesystem::is_directory(path, status) || !file.read(start.data(), start.size()) ||
        start != kMagic)
        throw input_error(path, "not a VDB file");
    file.seekg(0);
    return file;
}

//! Takes metadata that serve delayed loading for bytes of an unknown type, while an object of this kind
//! lives: OpenVDB unpacks them as they say, and we load at once.
class NoDelayedLoading
{
public:
    NoDelayedLoading() { Metadata::unregisterType(); }
    NoDelayedLoading(const NoDelayedLoading&) = delete;
    NoDelayedLoading& operator=(const NoDelayedLoading&) = delete;
    ~NoDelayedLoading()
    {
        if (was_registered_)
            Metadata::registerType();
    }

private:
    using Metadata = openvdb::io::DelayedLoadMetadata;
    bool was_registered_ = Metadata::isRegisteredType();
};

//! OpenVDB's reading from the first byte to the last, piece by piece, so that each is checked before it is
//! believed. Not io::File: that takes bytes beyond the end of a truncated file for data without a word.
class FloatGridReader : public openvdb::io::Archive
{
public:
    explicit FloatGridReader(std::istream& file) : file_(file)
    {
        check_vdb_version(file_);
        readHeader(file_);
        openvdb::io::setStreamMetadataPtr(file_, stream_metadata_, /*transfer=*/false);
        setFormatVersion(file_);
        setLibraryVersion(file_);
        setDataCompression(file_);
    }

    //! All grids; those of other types have a name only, where the file tells how to pass over them.
    openvdb::GridPtrVec read()
    {
        skip_vdb_metadata(file_);
        openvdb::GridPtrVec grids;
        std::vector<openvdb::io::GridDescriptor> descriptors;
        NamedGridMap by_name;
        for (int count = readGridCount(file_); count > 0; --count)
        {
            grids.push_back(read_grid(descriptors.emplace_back()));
            by_name[descriptors.back().uniqueName()] = grids.back();
        }
        for (const auto& descriptor : descriptors)
            connectInstance(descriptor, by_name); // with the grid whose tree it shares
        return grids;
    }

private:
    openvdb::GridBase::Ptr read_grid(openvdb::io::GridDescriptor& descriptor)
    {
        check_vdb_descriptor(file_);
        openvdb::GridBase::Ptr grid = descriptor.read(file_);
        if (inputHasGridOffsets() && !grid->isType<openvdb::FloatGrid>())
        {
            grid->setName(descriptor.gridName());
            skip_to(descriptor.getEndPos());
            return grid;
        }
        check_vdb_grid_header(file_, descriptor.isInstance() ? VdbTree::kOfAnotherGrid : VdbTree::kStored);
        readGrid(grid, descriptor, file_);
        return grid;
    }

    //! To just behind the byte before, which must be there.
    void skip_to(std::int64_t position)
    {
        if (position <= file_.tellg())
            throw InputError("damaged VDB file: a grid ends at byte " + std::to_string(position) +
                             ", before its data at byte " + std::to_string(std::streamoff{file_.tellg()}));
        file_.seekg(position - 1);
        file_.get();
    }

    std::istream& file_;
    openvdb::io::StreamMetadata::Ptr stream_metadata_ = std::make_shared<openvdb::io::StreamMetadata>();
};

//! Whether a sound file of this size can be read into the memory of this machine, whatever it holds.
bool surely_fits_in_memory(const std::filesystem::path& path)
{
    constexpr std::uintmax_t kMaxDeflateRatio = 1032; // zlib's technical notes; nothing else expands as much
    return std::filesystem::file_size(path) < total_memory_bytes() / kMaxDeflateRatio;
}

openvdb::GridPtrVec read_grids(const std::filesystem::path& path)
{
    openvdb::initialize();
    std::ifstream file = open_vdb_file(path);
    try
    {
        const NoDelayedLoading at_once;
        file.exceptions(std::ios::failbit | std::ios::badbit | std::ios::eofbit);
        return FloatGridReader(file).read();
    }
    catch (const InputError& error)
    {
        throw input_error(path, error.what());
    }
    catch (const std::ios::failure&)
    {
        throw input_error(path, file.eof() ? "truncated VDB file, its last bytes are missing"
                                           : "damaged VDB file (unreadable header)");
    }
    catch (const openvdb::Exception& error)
    {
        throw input_error(path, std::string("damaged VDB file (") + error.what() + ")");
    }
    catch (const std::length_error&)
    {
        throw input_error(path, "damaged VDB file (absurd sizes)");
    }
    catch (const std::bad_alloc&)
    {
        if (!surely_fits_in_memory(path))
            throw;
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

//! \throw InputError where a linear transform has no inverse.
void check_transform(const openvdb::FloatGrid& grid, const std::filesystem::path& path)
{
    try
    {
        if (grid.transform().isLinear())
            grid.transform().baseMap()->getAffineMap();
    }
    catch (const openvdb::ArithmeticError&)
    {
        throw input_error(path, "the transform of \"" + grid.getName() +
                                    "\" flattens space, expected one that can be inverted");
    }
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
    {
        check_transform(*candidates.front(), path);
        return candidates.front();
    }
    if (candidates.empty())
        throw input_error(path,
                          (name ? "no float grid named \"" + *name + "\"" : std::string("no float grid")) +
                              "; grids: " + list_of(grids));
    if (name)
        throw input_error(path, "several float grids named \"" + *name + "\"; grids: " + list_of(grids));
    throw input_error(path, "several float grids, name one with --grid; grids: " + list_of(grids));
}

} // namespace voroprobe
