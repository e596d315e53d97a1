#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>
#include <zlib.h>

namespace voroprobe
{

//! Writes a ZIP archive of uncompressed files, the least that readers of packages accept.
class StoredZip
{
public:
    void add(const std::string& name, const std::string& content)
    {
        const auto crc = static_cast<std::uint32_t>(
            crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size())));
        std::string facts;
        number(facts, 20, 2);         // version needed
        number(facts, 0, 2);          // flags
        number(facts, 0, 2);          // stored
        number(facts, 0x00210000, 4); // 1980-01-01
        number(facts, crc, 4);
        number(facts, content.size(), 4);
        number(facts, content.size(), 4);
        number(facts, name.size(), 2);
        number(facts, 0, 2); // extra field
        number(directory_, 0x02014b50, 4);
        number(directory_, 20, 2); // made by
        directory_ += facts;
        number(directory_, 0, 2);               // comment
        number(directory_, 0, 2);               // disk
        number(directory_, 0, 2);               // internal attributes
        number(directory_, 0, 4);               // external attributes
        number(directory_, archive_.size(), 4); // where it is
        directory_ += name;
        number(archive_, 0x04034b50, 4);
        archive_ += facts + name + content;
        ++count_;
    }

    void write(const std::filesystem::path& path) const
    {
        std::string end;
        number(end, 0x06054b50, 4);
        number(end, 0, 4); // disks
        number(end, count_, 2);
        number(end, count_, 2);
        number(end, directory_.size(), 4);
        number(end, archive_.size(), 4);
        number(end, 0, 2); // comment
        std::ofstream(path, std::ios::binary) << archive_ << directory_ << end;
    }

private:
    static void number(std::string& bytes, std::uint64_t value, int width)
    {
        for (int byte = 0; byte < width; ++byte)
            bytes.push_back(static_cast<char>(value >> (8 * byte) & 0xFFU));
    }

    std::string archive_;
    std::string directory_;
    std::size_t count_ = 0;
};

} // namespace voroprobe
