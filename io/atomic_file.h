#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>

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
    //! closed. `last_look` is called when only the renaming is left; whatever it throws leaves the target as
    //! it was. \throw OutputError
    void commit(const std::function<void()>& last_look = {});

private:
    std::filesystem::path target_;
    std::filesystem::path temporary_;
    bool committed_ = false;
};

//! Calls `write` with a stream that throws where it fails, then lets the file take its place. \throw
//! OutputError with the reason; whatever `write` throws, the target being as it was.
void write_atomically(const std::filesystem::path& path, const std::function<void()>& last_look,
                      const std::function<void(std::ostream&)>& write);

//! Removes the temporary file of an AtomicFile that lives and is not committed: for the handler of a signal
//! that ends the process. Safe in one. Where several live at once, only that of the oldest is removed.
void remove_unfinished_file() noexcept;

} // namespace voroprobe
