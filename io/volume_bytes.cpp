#include "io/volume_bytes.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>

#include <zlib.h>

#include "support/error.h"

namespace voroprobe
{

namespace
{

//! No deflate stream holds more than this many bytes for each byte of its own (zlib's technical notes: 1032).
constexpr std::uint64_t kMaxDeflateRatio = 1032;

constexpr unsigned kReadChunk = 1U << 20U;
constexpr std::size_t kPassedOverAtOnce = 4096;

struct CloseGzip
{
    void operator()(gzFile_s* file) const { gzclose(file); }
};
struct CloseFile
{
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using Gzip = std::unique_ptr<gzFile_s, CloseGzip>;
using File = std::unique_ptr<std::FILE, CloseFile>;

[[noreturn]] void throw_unreadable(const std::filesystem::path& path)
{
    throw InputError("cannot read " + path.filename().string() + ": " + std::strerror(errno));
}

[[noreturn]] void throw_truncated(std::uint64_t found, std::uint64_t expected,
                                  const std::filesystem::path& path)
{
    throw InputError("truncated: " + path.filename().string() + " holds " + std::to_string(found) +
                     " bytes of samples, expected " + std::to_string(expected));
}

Gzip open_gzip(const std::filesystem::path& path)
{
    Gzip file(gzopen(path.c_str(), "rb"));
    if (!file)
        throw_unreadable(path);
    gzbuffer(file.get(), kReadChunk);
    return file;
}

//! Reads up to to.size() bytes; fewer only at the end of the content or where it is damaged.
std::size_t read_up_to(gzFile_s* file, std::span<std::byte> to)
{
    std::size_t done = 0;
    while (done < to.size())
    {
        const auto chunk = static_cast<unsigned>(std::min<std::size_t>(to.size() - done, 1U << 30U));
        const int count = gzread(file, to.data() + done, chunk);
        if (count <= 0)
            break;
        done += static_cast<std::size_t>(count);
    }
    return done;
}

void read_plain(const std::filesystem::path& path, std::uint64_t start, std::span<std::byte> to)
{
    const File file(std::fopen(path.c_str(), "rb"));
    if (!file || fseeko(file.get(), static_cast<off_t>(start), SEEK_SET) != 0)
        throw_unreadable(path);
    if (const std::size_t found = std::fread(to.data(), 1, to.size(), file.get()); found != to.size())
        throw_truncated(found, to.size(), path);
}

[[noreturn]] void throw_damaged(const std::filesystem::path& path, const std::string& what)
{
    throw InputError("damaged: the compressed content of " + path.filename().string() + " " + what);
}

int error_of(gzFile_s* file)
{
    int error = Z_OK;
    gzerror(file, &error);
    return error;
}

bool is_damaged(gzFile_s* file)
{
    return error_of(file) == Z_DATA_ERROR;
}

//! The checksum comes after the content, and zlib looks at it there only. What is longer than expected, as
//! files of many frames are, is read on as far again and then taken as it is.
void require_checksum(gzFile_s* file, std::size_t most, const std::filesystem::path& path)
{
    if (gzdirect(file) != 0)
        return;
    std::array<std::byte, kPassedOverAtOnce> passed_over;
    for (std::size_t passed = 0; passed <= most; passed += passed_over.size())
    {
        if (read_up_to(file, passed_over) == passed_over.size())
            continue;
        if (is_damaged(file))
            throw_damaged(path, "does not agree with its checksum");
        if (error_of(file) == Z_BUF_ERROR)
            throw_damaged(path, "ends before its checksum");
        return;
    }
}

void read_plain_or_gzip(const std::filesystem::path& path, std::uint64_t start, std::span<std::byte> to)
{
    const Gzip file = open_gzip(path);
    const bool started = gzseek(file.get(), static_cast<z_off_t>(start), SEEK_SET) >= 0;
    const std::size_t found = started ? read_up_to(file.get(), to) : 0;
    if (found == to.size())
        return require_checksum(file.get(), to.size(), path);
    if (is_damaged(file.get()))
        throw_damaged(path, "cannot be unpacked after " + std::to_string(found) +
                                " bytes of samples, expected " + std::to_string(to.size()));
    throw_truncated(found, to.size(), path);
}

//! A zlib or gzip stream somewhere in a file.
class InflateStream
{
public:
    InflateStream(const std::filesystem::path& path, std::uint64_t start)
        : path_(path), file_(std::fopen(path.c_str(), "rb"))
    {
        if (!file_ || fseeko(file_.get(), static_cast<off_t>(start), SEEK_SET) != 0)
            throw_unreadable(path);
        constexpr int kZlibOrGzipHeader = 32 + MAX_WBITS;
        if (inflateInit2(&stream_, kZlibOrGzipHeader) != Z_OK)
            throw InputError("cannot unpack " + path.filename().string());
    }
    ~InflateStream() { inflateEnd(&stream_); }
    InflateStream(const InflateStream&) = delete;
    InflateStream& operator=(const InflateStream&) = delete;

    //! Reads up to to.size() bytes; fewer only at the end of the stream or of the file.
    std::size_t read(std::span<std::byte> to)
    {
        std::size_t done = 0;
        while (done < to.size() && !ended_)
        {
            if (stream_.avail_in == 0)
                refill();
            const auto chunk = static_cast<unsigned>(std::min<std::size_t>(to.size() - done, 1U << 30U));
            stream_.next_out = reinterpret_cast<Bytef*>(to.data() + done);
            stream_.avail_out = chunk;
            const int status = inflate(&stream_, Z_NO_FLUSH);
            done += chunk - stream_.avail_out;
            if (status == Z_DATA_ERROR || status == Z_NEED_DICT || status == Z_MEM_ERROR)
                throw InputError("damaged: the compressed samples of " + path_.filename().string() +
                                 " cannot be unpacked");
            ended_ = status == Z_STREAM_END || (status == Z_BUF_ERROR && stream_.avail_in == 0 && at_end_);
        }
        return done;
    }

private:
    void refill()
    {
        stream_.next_in = buffer_.data();
        stream_.avail_in = static_cast<unsigned>(std::fread(buffer_.data(), 1, buffer_.size(), file_.get()));
        at_end_ = stream_.avail_in == 0;
    }

    std::filesystem::path path_;
    File file_;
    z_stream stream_{};
    std::vector<Bytef> buffer_ = std::vector<Bytef>(kReadChunk);
    bool at_end_ = false;
    bool ended_ = false;
};

void read_zlib(const std::filesystem::path& path, const ByteSource& source, std::span<std::byte> to)
{
    InflateStream stream(path, source.offset);
    std::array<std::byte, kPassedOverAtOnce> passed_over;
    for (std::uint64_t left = source.skip; left > 0;)
    {
        const std::size_t chunk = std::min<std::uint64_t>(left, passed_over.size());
        if (stream.read({passed_over.data(), chunk}) != chunk)
            throw_truncated(0, to.size(), path);
        left -= chunk;
    }
    if (const std::size_t found = stream.read(to); found != to.size())
        throw_truncated(found, to.size(), path);
    for (std::size_t passed = 0; passed <= to.size(); passed += passed_over.size())
    {
        if (stream.read(passed_over) < passed_over.size())
            break; // the checksum has been looked at
    }
}

bool is_gzip(const std::filesystem::path& path)
{
    const File file(std::fopen(path.c_str(), "rb"));
    if (!file)
        throw_unreadable(path);
    return std::fgetc(file.get()) == 0x1f && std::fgetc(file.get()) == 0x8b;
}

} // namespace

void require_bytes(const ByteSource& source, std::uint64_t byte_count)
{
    const std::uint64_t part = byte_count / source.files.size();
    for (const std::filesystem::path& path : source.files)
    {
        std::error_code error;
        const std::uint64_t file_bytes = std::filesystem::file_size(path, error);
        if (error)
            throw InputError("cannot read " + path.filename().string() + ": " + error.message());
        if (source.packing == Packing::kZlib || (source.packing == Packing::kPlainOrGzip && is_gzip(path)))
        {
            if (file_bytes < part / kMaxDeflateRatio)
                throw InputError("truncated: " + path.filename().string() + " has " +
                                 std::to_string(file_bytes) + " compressed bytes, too few for " +
                                 std::to_string(part) + " bytes of samples");
            continue;
        }
        const std::uint64_t start = std::min(file_bytes, source.offset + source.skip);
        if (file_bytes - start < part)
            throw_truncated(file_bytes - start, part, path);
    }
}

void read_bytes(const ByteSource& source, std::span<std::byte> to)
{
    const std::size_t part = to.size() / source.files.size();
    for (std::size_t i = 0; i < source.files.size(); ++i)
    {
        const std::span<std::byte> to_part = to.subspan(i * part, part);
        switch (source.packing)
        {
        case Packing::kPlain:
            read_plain(source.files[i], source.offset + source.skip, to_part);
            break;
        case Packing::kPlainOrGzip:
            read_plain_or_gzip(source.files[i], source.offset + source.skip, to_part);
            break;
        case Packing::kZlib:
            read_zlib(source.files[i], source, to_part);
            break;
        }
    }
}

std::string read_head(const std::filesystem::path& path, std::size_t count)
{
    const Gzip file = open_gzip(path);
    std::string head(count, '\0');
    head.resize(read_up_to(file.get(), std::as_writable_bytes(std::span(head))));
    if (head.size() < count && is_damaged(file.get()))
        throw_damaged(path, "cannot be unpacked after " + std::to_string(head.size()) + " bytes");
    return head;
}

} // namespace voroprobe
