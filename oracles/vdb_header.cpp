// This file follows the readers of OpenVDB 10: Archive::readHeader, MetaMap::readMeta, GridDescriptor::read,
// Transform::read.

#include "oracles/vdb_header.h"

#include <cstdint>
#include <string>

#include <openvdb/Metadata.h>
#include <openvdb/io/io.h>
#include <openvdb/math/Transform.h>
#include <openvdb/version.h>

#include "support/error.h"

namespace voroprobe
{
namespace
{

//! Version of the format from which grids are laid out as here: descriptor, metadata, transform, tree.
constexpr std::uint32_t kOldestVersion = openvdb::OPENVDB_FILE_VERSION_GRID_INSTANCING;

template <class Number>
Number read_number(std::istream& file)
{
    Number number{};
    file.read(reinterpret_cast<char*>(&number), sizeof(Number));
    return number;
}

std::uint64_t bytes_left(std::istream& file)
{
    const std::streamoff here = file.tellg();
    file.seekg(0, std::ios::end);
    const std::streamoff end = file.tellg();
    file.seekg(here);
    return static_cast<std::uint64_t>(end - here);
}

void require_bytes(std::istream& file, std::uint64_t count)
{
    if (const std::uint64_t left = bytes_left(file); count > left)
        throw InputError("truncated or damaged VDB file: " + std::to_string(count) +
                         " bytes announced before byte " + std::to_string(std::streamoff{file.tellg()}) +
                         ", expected at most the " + std::to_string(left) + " that are left");
}

std::string read_string(std::istream& file)
{
    const auto length = read_number<std::uint32_t>(file);
    require_bytes(file, length);
    std::string text(length, '\0');
    file.read(text.data(), std::ssize(text));
    return text;
}

//! OpenVDB reads values of fixed size whatever size the file gives for them.
void require_size_of_type(const std::string& type, std::uint32_t size)
{
    if (type == openvdb::StringMetadata::staticTypeName() || !openvdb::Metadata::isRegisteredType(type))
        return;
    if (const std::uint32_t expected = openvdb::Metadata::createMetadata(type)->size(); size != expected)
        throw InputError("damaged VDB file: metadata of type " + type + " with " + std::to_string(size) +
                         " bytes, expected " + std::to_string(expected));
}

//! A transform is the name of its map and the map; a frustum has a second map.
void check_transform_names(std::istream& file)
{
    if (read_string(file) != openvdb::math::NonlinearFrustumMap::mapType())
        return;
    const std::size_t number_size =
        openvdb::io::getFormatVersion(file) < openvdb::OPENVDB_FILE_VERSION_FLOAT_FRUSTUM_BBOX
            ? sizeof(std::int32_t)
            : sizeof(double);
    const std::size_t box_taper_depth = 6 * number_size + 2 * sizeof(double);
    require_bytes(file, box_taper_depth);
    file.seekg(static_cast<std::streamoff>(box_taper_depth), std::ios::cur);
    read_string(file);
}

void skip_transform(std::istream& file)
{
    const auto begin = file.tellg();
    check_transform_names(file);
    file.seekg(begin);
    openvdb::math::Transform().read(file);
}

} // namespace

void check_vdb_version(std::istream& file)
{
    const auto begin = file.tellg();
    read_number<std::int64_t>(file); // the mark of the format
    const auto version = read_number<std::uint32_t>(file);
    file.seekg(begin);
    if (version < kOldestVersion || version > openvdb::OPENVDB_FILE_VERSION)
        throw InputError("VDB file of version " + std::to_string(version) + ", expected " +
                         std::to_string(kOldestVersion) + " to " +
                         std::to_string(openvdb::OPENVDB_FILE_VERSION));
}

void skip_vdb_metadata(std::istream& file)
{
    for (auto count = read_number<std::uint32_t>(file); count > 0; --count)
    {
        read_string(file); // the name
        const std::string type = read_string(file);
        const auto size = read_number<std::uint32_t>(file);
        require_size_of_type(type, size);
        require_bytes(file, size);
        file.seekg(size, std::ios::cur);
    }
}

void check_vdb_descriptor(std::istream& file)
{
    const auto begin = file.tellg();
    for (int name = 0; name < 3; ++name) // of the grid, of its type, of the grid whose tree it shares
        read_string(file);
    file.seekg(begin);
}

void check_vdb_grid_header(std::istream& file, VdbTree tree)
{
    const auto begin = file.tellg();
    if (openvdb::io::getFormatVersion(file) >= openvdb::OPENVDB_FILE_VERSION_NODE_MASK_COMPRESSION)
        read_number<std::uint32_t>(file); // the kind of compression
    skip_vdb_metadata(file);
    skip_transform(file);
    if (tree == VdbTree::kStored)
        if (const auto buffers = read_number<std::int32_t>(file); buffers != 1)
            throw InputError("damaged VDB file: a tree of " + std::to_string(buffers) +
                             " buffers, expected 1");
    file.seekg(begin);
}

} // namespace voroprobe
