#include <unistd.h>

#include <csignal>
#include <optional>
#include <stdexcept>

#include "app/cli/cli.h"
#include "app/cli/terminal.h"
#include "app/output/run.h"
#include "core/base/simd_target.h"
#include "kernels/opencl_devices.h"
#include "mpi/divided_solver.h"
#include "mpi/lifeline.h"
#include "warp/picture_library.h"

namespace {

/// Serves until the first process ends; only that one reacts to interrupts.
[[noreturn]] void serveToTheEnd(std::optional<wend::Team>& team, std::optional<wend::Lifeline>& lifeline) {
    std::signal(SIGINT, SIG_IGN);
    std::signal(SIGTERM, SIG_IGN);
    try {
        wend::serve(*team);
        lifeline.reset();
        team.reset();
    } catch (const std::bad_alloc&) {
        wend::Terminal::lastWord("a process has not enough memory",
                                 static_cast<int>(wend::ExitCode::Machine));
    } catch (const std::exception& error) {
        wend::Terminal::lastWord(error.what(), static_cast<int>(wend::ExitCode::Internal));
    }
    _exit(0);
}

}  // namespace

/// `wend run` in many processes that mpirun or srun starts together: the first one runs the program.
int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error like a full disk
    wend::prepareOpenClEnvironment();
    wend::lookForNoPlugins();
    std::optional<wend::Team> team;
    team.emplace(argc, argv);
    std::optional<wend::Lifeline> lifeline;
    lifeline.emplace(*team);
    const auto finish = [&] {
        wend::dismiss(*team);
        lifeline.reset();
        team.reset();
    };
    try {
        wend::useSimdOfEnvironment();
    } catch (const std::invalid_argument& error) {
        if (team->isFirst()) wend::Terminal::error(error.what());
        lifeline.reset();
        team.reset();
        _exit(static_cast<int>(wend::ExitCode::Usage));
    }
    if (!team->isFirst()) serveToTheEnd(team, lifeline);
    const wend::RunSolvers solvers{wend::dividedSolvers<2>(*team), wend::dividedSolvers<3>(*team)};
    return wend::runDividedCommand(argc, argv, solvers, finish);
}
