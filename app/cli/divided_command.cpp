#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/guarded.h"
#include "app/output/run.h"

namespace wend {
namespace {

std::string help() {
    return "wend-mpi is `wend run` divided among processes, by MPI: for solids that one machine does not "
           "hold.\n\n"
           "Usage:\n  mpirun -q -n N wend-mpi run PROJECT [outputs] [options]\n"
           "  srun --mpi=pmix -n N -K wend-mpi run PROJECT [outputs] [options]\n\n"
           "Velocities are solved for by multigrid; --threads N are those of each process, one unless "
           "given.\n"
           "All else is as `wend run --help` says, exit codes included.\n";
}

ExitCode dispatch(const std::vector<std::string>& words, const RunSolvers& solvers) {
    if (words.empty()) return print(help());
    for (const std::string& word : words)
        if (word == "--help" || word == "-h") return print(help());
    if (words[0] == "--version") return print("wend-mpi " WEND_VERSION "\n");
    if (words[0] != "run") throw UsageError("wend-mpi knows the command run only: take wend " + words[0]);
    return runDivided(Arguments("run", {words.begin() + 1, words.end()}), solvers);
}

}  // namespace

int runDividedCommand(int argc, char** argv, const RunSolvers& solvers, const std::function<void()>& finish) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    return runToTheEnd([&] { return dispatch(words, solvers); }, finish);
}

}  // namespace wend
