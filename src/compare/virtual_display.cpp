#include "compare/virtual_display.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace voroprobe
{

namespace
{

constexpr int kMillisecondsToStart = 10000;

//! Never returns. Xvfb writes the number of the display it chose to `pipe_end`.
[[noreturn]] void become_server(int pipe_end)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    std::signal(SIGINT, SIG_IGN); // Ctrl-C is for the program; the server ends with it
    const int nothing = open("/dev/null", O_RDWR);
    dup2(nothing, STDIN_FILENO);
    dup2(nothing, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
    const std::string number = std::to_string(pipe_end);
    execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1600x800x24", "-nolisten", "tcp",
           static_cast<char*>(nullptr));
    _exit(127); // as shells do where there is no such command
}

//! Empty where the server ended or took too long.
std::string display_number(int pipe_end)
{
    std::string number;
    char c = 0;
    pollfd end{.fd = pipe_end, .events = POLLIN, .revents = 0};
    while (poll(&end, 1, kMillisecondsToStart) > 0 && read(pipe_end, &c, 1) == 1 && c != '\n')
        number.push_back(c);
    return c == '\n' ? number : "";
}

} // namespace

VirtualDisplay::VirtualDisplay()
{
    if (const char* display = std::getenv("DISPLAY"); display != nullptr && *display != '\0')
        return;
    int ends[2];
    if (pipe(ends) != 0)
    {
        failure_ = std::string("no pipe: ") + std::strerror(errno);
        return;
    }
    const pid_t child = fork();
    if (child == 0)
    {
        close(ends[0]);
        become_server(ends[1]);
    }
    close(ends[1]);
    const std::string number = child > 0 ? display_number(ends[0]) : "";
    close(ends[0]);
    if (child > 0)
        server_ = child;
    if (number.empty())
        failure_ = "there is no X display, and Xvfb could not be started (Debian: apt-get install xvfb)";
    else
        setenv("DISPLAY", (":" + number).c_str(), 1);
}

VirtualDisplay::~VirtualDisplay()
{
    if (!server_)
        return;
    kill(*server_, SIGTERM);
    waitpid(*server_, nullptr, 0);
    unsetenv("DISPLAY");
}

} // namespace voroprobe
