#include "program.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace voroprobe::program
{

namespace fs = std::filesystem;

namespace
{

using namespace std::chrono_literals;

//! Nothing a test does takes longer; a program that hangs must not hang the tests.
constexpr auto kLongestRun = 120s;
constexpr auto kPollInterval = 2ms;

void redirect(int descriptor, const fs::path& path)
{
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (file < 0 || dup2(file, descriptor) < 0)
        _exit(126);
    close(file);
}

template <typename Resource>
void limit(Resource resource, std::size_t most)
{
    const rlimit allowed{most, most};
    if (most > 0 && setrlimit(resource, &allowed) != 0)
        _exit(126);
}

[[noreturn]] void become_program(std::vector<std::string> arguments, const Limits& limits,
                                 const fs::path& out, const fs::path& err)
{
    redirect(STDOUT_FILENO, out);
    redirect(STDERR_FILENO, err);
    limit(RLIMIT_AS, limits.address_space);
    limit(RLIMIT_FSIZE, limits.file_size);
    arguments.insert(arguments.begin(), VOROPROBE_EXECUTABLE);
    std::vector<char*> argv;
    argv.reserve(arguments.size() + 1);
    for (std::string& argument : arguments)
        argv.push_back(argument.data());
    argv.push_back(nullptr);
    execv(VOROPROBE_EXECUTABLE, argv.data());
    _exit(127);
}

int shell_status(int wait_status)
{
    return WIFEXITED(wait_status) ? WEXITSTATUS(wait_status) : 128 + WTERMSIG(wait_status);
}

//! Calls `watch` until the process ends.
int wait_for(pid_t process, const std::function<void()>& watch)
{
    const auto deadline = std::chrono::steady_clock::now() + kLongestRun;
    for (int status = 0;;)
    {
        if (waitpid(process, &status, WNOHANG) == process)
            return shell_status(status);
        if (std::chrono::steady_clock::now() > deadline)
            kill(process, SIGKILL);
        watch();
        std::this_thread::sleep_for(kPollInterval);
    }
}

Outcome run_watched(const std::vector<std::string>& arguments, const Limits& limits,
                    const std::function<void(pid_t, const fs::path& err)>& watch)
{
    const ScratchFolder folder;
    const fs::path out = folder / "out";
    const fs::path err = folder / "err";
    const pid_t process = fork();
    if (process < 0)
        throw std::runtime_error("fork failed");
    if (process == 0)
        become_program(arguments, limits, out, err);
    const int status = wait_for(process, [&] { watch(process, err); });
    return {status, read_text(out), read_text(err)};
}

} // namespace

Outcome run(const std::vector<std::string>& arguments, const Limits& limits)
{
    return run_watched(arguments, limits, [](pid_t, const fs::path&) {});
}

Outcome run_and_signal(const std::vector<std::string>& arguments, int signal,
                       const std::function<bool(const std::string& err)>& ready)
{
    bool sent = false;
    return run_watched(arguments, {},
                       [&](pid_t process, const fs::path& err)
                       {
                           if (!sent && ready(read_text(err)))
                               sent = kill(process, signal) == 0;
                       });
}

ScratchFolder::ScratchFolder()
{
    std::string name = (fs::temp_directory_path() / "voroprobe_test_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
        throw std::runtime_error("cannot make a folder for the test");
    path_ = name;
}

ScratchFolder::~ScratchFolder()
{
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::vector<std::string> ScratchFolder::names() const
{
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(path_))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string read_text(const fs::path& path)
{
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

void write_text(const fs::path& path, const std::string& text)
{
    std::ofstream(path, std::ios::binary) << text;
}

} // namespace voroprobe::program
