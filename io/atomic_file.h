#pragma once

#include <filesystem>

namespace voroprobe
{

//! A file that is written under a temporary name beside its target and takes the target's place only when it
//! is whole. Whatever goes wrong before, the target stays as it was and the temporary file is removed.
class AtomicFile
{
public:
    //! Creates the temporary file, empty. A target that is a symbolic link is followed; the permissions of an
    //! existing target are kept. \throw OutputError with the reason where that fails or the target is not a
    //! regular file.
    explicit AtomicFile(const std::filesystem::path& target);

    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    ~AtomicFile();

    //! Where to write: ".NAME.tmp-PID" in the folder of the target.
    [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }

    //! Forces what was written onto the disk, then renames. To be called once, when the temporary file is
    //! closed. \throw OutputError
    void commit();

private:
    std::filesystem::path target_;
    std::filesystem::path temporary_;
    bool committed_ = false;
};

} // namespace voroprobe
