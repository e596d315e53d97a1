#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

//! Runs the built program the way a shell does.
namespace voroprobe::program
{

struct Outcome
{
    int status = -1; //!< exit status; 128 + signal where a signal ended it, as shells say
    std::string out; //!< what it wrote to standard output
    std::string err; //!< and to standard error
};

//! What the system allows the program, bytes; 0: no limit.
struct Limits
{
    std::size_t address_space = 0;
    std::size_t file_size = 0; //!< of each file it writes, its standard output and error too
};

//! Runs it to its end.
Outcome run(const std::vector<std::string>& arguments, const Limits& limits = {});

//! Runs it and sends `signal` once `ready` holds for what it has written to standard error so far.
Outcome run_and_signal(const std::vector<std::string>& arguments, int signal,
                       const std::function<bool(const std::string& err)>& ready);

//! A folder of its own for one test, removed at the end with all it holds.
class ScratchFolder
{
public:
    ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }

    //! Names in the folder, sorted.
    [[nodiscard]] std::vector<std::string> names() const;

private:
    std::filesystem::path path_;
};

std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);

} // namespace voroprobe::program
