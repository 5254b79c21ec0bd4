#include "app/cli/command_table.h"

#include <array>
#include <string_view>

namespace wend {
namespace {

constexpr std::array kCommands{
    Command{"run", "PROJECT [outputs] [options]", "deform as the project says and write what is asked for",
            runRun},
    Command{"mesh", "INPUT -o OUT [options]",
            "mesh a picture, an outline, a project's domain or a closed surface", runMesh},
    Command{"info", "FILE [--json] [--problems OUT]", "tell what Wend sees in a picture, mesh or project",
            runInfo},
    Command{"convert", "IN OUT [options]", "write a mesh or picture in another format, by the extensions",
            runConvert},
    Command{"devices", "", "list the devices that can compute, and which is used", runDevices},
    Command{"bench", "[CASE …]", "measure the speed on this machine", startBench},
    Command{"reference", "[--man FOLDER | --completion SHELL]",
            "print the reference of all settings, or write manual pages and completion", runReference, true},
};

}  // namespace

std::span<const Command> commands() {
    return kCommands;
}

const Command* findCommand(const std::string& name) {
    for (const Command& one : kCommands)
        if (name == one.name) return &one;
    return nullptr;
}

std::string remarksOn(const Command& command) {
    if (std::string_view(command.name) == "bench")
        return "Cases: 2d-5.6k 2d-11k 2d-40k 2d-160k 3d-1.5k 3d-5k 3d-20k window-2d window-parts window-3d "
               "warp kernels "
               "paper;\nwithout any, all but paper, which shows what the figures of the paper show, tells "
               "whether its\nfindings hold, and has its table of times.\n";
    if (std::string_view(command.name) == "run")
        return "A file named - is standard output (one of them). Either all outputs are written, or none; if "
               "the\n"
               "deformation stops early, only the report is, with the last good time (see --partial).\n"
               "`mpirun -q -n N wend-mpi run …` divides a large solid among N processes.\n";
    return {};
}

std::string exitCodeText() {
    return "Exit codes: 0 done, 1 internal error, 2 wrong usage, 3 an input cannot be read or makes no "
           "sense\n"
           "(or an output cannot be written), 4 the deformation could not be completed, 5 the machine has "
           "not the\nmemory or the disk that is needed.\n";
}

}  // namespace wend
