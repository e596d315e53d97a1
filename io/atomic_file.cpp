#include "io/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

#include "support/error.h"

namespace voroprobe
{

namespace fs = std::filesystem;

namespace
{

//! Names of files hold at most 255 bytes on all common systems; what we put around the name needs some of
//! them.
constexpr std::size_t kLongestNamePart = 200;

//! Name of the file to remove when a signal ends the process; owned by an AtomicFile.
std::atomic<const char*> unfinished = nullptr;
static_assert(std::atomic<const char*>::is_always_lock_free, "read in the handler of a signal");

void announce_unfinished(const fs::path& temporary)
{
    const char* none = nullptr;
    unfinished.compare_exchange_strong(none, temporary.c_str());
}

void withdraw_unfinished(const fs::path& temporary)
{
    const char* ours = temporary.c_str();
    unfinished.compare_exchange_strong(ours, nullptr);
}

[[noreturn]] void fail(const fs::path& target, const std::string& reason)
{
    throw OutputError("cannot write '" + target.string() + "': " + reason);
}

std::string system_reason(int error_number)
{
    return std::strerror(error_number);
}

fs::path folder_of(const fs::path& target)
{
    return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

//! Refuses, with better words than the system's, what could not be replaced by a file of ours.
void check_target(const fs::path& target)
{
    std::error_code error;
    const fs::path folder = folder_of(target);
    const fs::file_status folder_status = fs::status(folder, error);
    if (!fs::exists(folder_status))
        fail(target, "the folder '" + folder.string() + "' does not exist");
    if (!fs::is_directory(folder_status))
        fail(target, "'" + folder.string() + "' is not a folder");

    const fs::file_status status = fs::status(target, error);
    if (status.type() == fs::file_type::none)
        fail(target, error.message()); // a name too long, a loop of links
    if (!target.has_filename() || fs::is_directory(status))
        fail(target, "it is a folder; a file name is expected");
    if (fs::exists(status) && !fs::is_regular_file(status))
        fail(target, "it exists and is not a regular file");
    if (fs::exists(status) && ::access(target.c_str(), W_OK) != 0)
        fail(target, "it exists and is write-protected (" + system_reason(errno) + ")");
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        fail(target, "the folder '" + folder.string() + "' is not writable (" + system_reason(errno) + ")");
}

//! The file that is to be replaced: where `path` is a symbolic link, what it points to.
fs::path followed(const fs::path& path)
{
    std::error_code error;
    if (!fs::is_symlink(fs::symlink_status(path, error)))
        return path;
    const fs::path target = fs::weakly_canonical(path, error);
    return error ? path : target;
}

fs::path temporary_name(const fs::path& target)
{
    const std::string name = target.filename().string().substr(0, kLongestNamePart);
    return folder_of(target) / ("." + name + ".tmp-" + std::to_string(::getpid()));
}

//! Creates an empty file under a name that only this process uses; one left over from a dead process is
//! replaced.
void create(const fs::path& temporary, const fs::path& target)
{
    ::unlink(temporary.c_str());
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0)
        fail(target, system_reason(errno));
    ::close(descriptor);
}

void keep_permissions(const fs::path& target, const fs::path& temporary)
{
    struct stat status = {};
    if (::stat(target.c_str(), &status) == 0)
        ::chmod(temporary.c_str(), status.st_mode & 0777);
}

} // namespace

AtomicFile::AtomicFile(const fs::path& target)
    : target_(followed(target)), temporary_(temporary_name(target_))
{
    check_target(target_);
    announce_unfinished(temporary_);
    try
    {
        create(temporary_, target_);
    }
    catch (...)
    {
        withdraw_unfinished(temporary_);
        throw;
    }
    keep_permissions(target_, temporary_);
}

AtomicFile::~AtomicFile()
{
    if (!committed_)
        ::unlink(temporary_.c_str());
    withdraw_unfinished(temporary_);
}

void AtomicFile::commit(const std::function<void()>& last_look)
{
    // Some file systems (network, quota) report a full disk only here.
    const int descriptor = ::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        fail(target_, system_reason(errno));
    const int sync_error = ::fsync(descriptor) == 0 ? 0 : errno;
    ::close(descriptor);
    if (sync_error != 0 && sync_error != EINVAL)
        fail(target_, system_reason(sync_error));

    if (last_look)
        last_look();
    if (::rename(temporary_.c_str(), target_.c_str()) != 0)
        fail(target_, system_reason(errno));
    committed_ = true;
}

void remove_unfinished_file() noexcept
{
    if (const char* temporary = unfinished; temporary != nullptr)
        ::unlink(temporary);
}

void write_atomically(const std::filesystem::path& path, const std::function<void()>& last_look,
                      const std::function<void(std::ostream&)>& write)
{
    AtomicFile file(path);
    errno = 0;
    try
    {
        std::ofstream out(file.temporary(), std::ios::binary);
        out.exceptions(std::ios::badbit | std::ios::failbit); // the first write that fails ends it
        write(out);
        out.close();
        file.commit(last_look);
    }
    catch (const std::ios_base::failure&)
    {
        throw OutputError("cannot write '" + path.string() + "': " +
                          (errno != 0 ? std::strerror(errno) : "the file could not be written in full"));
    }
}

} // namespace voroprobe
