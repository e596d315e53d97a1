// The program: reads the command line, runs a command, and turns whatever went wrong into one line and an
// exit status.

#include <algorithm>
#include <iostream>
#include <new>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/check_command.h"
#include "cli/compare_command.h"
#include "cli/info_command.h"
#include "cli/interrupt.h"
#include "cli/mesh_command.h"
#include "cli/process_command.h"
#include "cli/unknown_argument.h"
#include "support/error.h"

namespace
{

using voroprobe::ExitStatus;

int fail(ExitStatus status, std::string message)
{
    std::replace(message.begin(), message.end(), '\n', ' ');
    std::cerr << "voroprobe: error: " + message + '\n';
    return static_cast<int>(status);
}

//! Help and version are printed; everything else CLI11 refuses is wrong usage.
int conclude_parsing(const CLI::App& app, const CLI::ParseError& error)
{
    constexpr int kSuccess = static_cast<int>(CLI::ExitCodes::Success);
    if (error.get_exit_code() == kSuccess)
        return app.exit(error);
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError))
        return fail(ExitStatus::kUsage, voroprobe::unknown_argument_text(app));
    return fail(ExitStatus::kUsage, std::string(error.what()) + " (see voroprobe --help)");
}

//! \throw voroprobe::Error and whatever the libraries throw.
int run(int argc, const char* const* argv)
{
    CLI::App app("Closed, well-shaped meshes of 3D scans by self-seeding Delaunay refinement.", "voroprobe");
    app.set_version_flag("--version", "voroprobe " VOROPROBE_VERSION, "Print the version and exit");
    app.require_subcommand(0,
                           1); // more than one is refused; none is told below, after what was not understood
    app.footer(
        "Exit status: 0 done, 1 internal error or output not writable, 2 usage, 3 input, 4 empty surface,\n"
        "5 mesh not as promised, 6 out of memory or budget, 130 interrupted.");

    voroprobe::MeshArguments mesh_arguments;
    CLI::App& mesh = *app.add_subcommand("mesh", "Mesh the surface of a volume at an isovalue");
    voroprobe::add_mesh_arguments(mesh, mesh_arguments);
    voroprobe::InfoArguments info_arguments;
    CLI::App& info = *app.add_subcommand("info", "Tell what a volume holds and which isovalues suit it");
    voroprobe::add_info_arguments(info, info_arguments);
    voroprobe::CheckArguments check_arguments;
    CLI::App& check = *app.add_subcommand("check", "Check a mesh made by anyone, alone or against its scan");
    voroprobe::add_check_arguments(check, check_arguments);
    voroprobe::CompareArguments compare_arguments;
    CLI::App& compare =
        *app.add_subcommand("compare", "Hold our mesh of a scan against marching cubes and others: a page");
    voroprobe::add_compare_arguments(compare, compare_arguments);
    voroprobe::ProcessArguments process_arguments;
    CLI::App& process =
        *app.add_subcommand("process", "Mend, smooth, decimate, relax, place a mesh made by anyone");
    voroprobe::add_process_arguments(process, process_arguments);

    try
    {
        app.parse(argc, argv);
    }
    catch (const CLI::ParseError& error)
    {
        return conclude_parsing(app, error);
    }
    if (mesh.parsed())
        voroprobe::run_mesh_command(mesh_arguments);
    if (info.parsed())
        voroprobe::run_info_command(info_arguments);
    if (check.parsed())
        voroprobe::run_check_command(check_arguments);
    if (compare.parsed())
    {
        compare_arguments.command.assign(argv, argv + argc);
        compare_arguments.command.front() = "voroprobe";
        voroprobe::run_compare_command(compare_arguments);
    }
    if (process.parsed())
        voroprobe::run_process_command(process_arguments);
    if (app.get_subcommands().empty())
        throw voroprobe::UsageError(
            "a command is required: mesh, info, check, compare or process (see voroprobe --help)");
    return static_cast<int>(ExitStatus::kDone);
}

} // namespace

int main(int argc, char** argv)
{
    try
    {
        voroprobe::install_interrupt_handlers();
        const int status = run(argc, argv);
        if (!std::cout.flush())
            return fail(ExitStatus::kInternal, "cannot write to standard output");
        return status;
    }
    catch (const voroprobe::Error& error)
    {
        return fail(error.status(), error.what());
    }
    catch (const std::bad_alloc&)
    {
        return fail(ExitStatus::kBudget, "out of memory");
    }
    catch (const std::exception& error)
    {
        return fail(ExitStatus::kInternal, error.what());
    }
    catch (...)
    {
        return fail(ExitStatus::kInternal, "unknown exception");
    }
}
