#include <csignal>
#include <stdexcept>

#include "app/cli/cli.h"
#include "app/cli/terminal.h"
#include "app/window/main_window.h"
#include "core/base/simd_target.h"
#include "kernels/opencl_devices.h"
#include "warp/picture_library.h"

/// Runs subcommands without a display, and opens the window for everything else.
int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error like a full disk
    wend::prepareOpenClEnvironment();
    wend::lookForNoPlugins();
    try {
        wend::useSimdOfEnvironment();
    } catch (const std::invalid_argument& error) {
        wend::Terminal::error(error.what());
        return static_cast<int>(wend::ExitCode::Usage);
    }
    if (argc > 1 && wend::isCommand(argv[1])) return wend::runCommand(argc, argv);
    return wend::runWindow(argc, argv);
}
