#include <csignal>
#include <stdexcept>

#include "app/cli/guarded.h"
#include "app/cli/terminal.h"
#include "bench/bench_command.h"
#include "core/base/simd_target.h"
#include "kernels/opencl_devices.h"
#include "warp/picture_library.h"

/// Takes the arguments of `wend bench`, which starts this program.
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
    const std::vector<std::string> words(argv + 1, argv + argc);
    return wend::runToTheEnd([&] { return wend::runBench(wend::Arguments("bench", words)); });
}
