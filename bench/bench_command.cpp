#include "bench/bench_command.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/terminal.h"
#include "app/output/output_set.h"
#include "app/project/file/text_file.h"
#include "bench/bench.h"
#include "core/base/error.h"

namespace wend {

ExitCode runBench(const Arguments& arguments) {
    const std::string output = arguments.text("--output");
    requirePlaces({output});
    const std::string folder = arguments.text("--keep");
    if (!folder.empty() && std::ranges::find(arguments.files(), "paper") == arguments.files().end())
        throw UsageError("--keep is for the case paper");
    if (!folder.empty() && !std::filesystem::is_directory(folder))
        throw InputError(folder, "is no folder that is there");
    const Interrupt interrupt([] { Terminal::error(kCancelled); });
    BenchOptions options;
    options.cases = arguments.files();
    options.folder = folder;
    options.repeats = arguments.integer("--repeats");
    options.stop = interrupt.token();
    options.say = [](const std::string& line) {
        std::puts(line.c_str());
        std::fflush(stdout);
    };
    const BenchTable table = runBenchmarks(options);
    if (!output.empty()) writeTextFile(output, jsonOf(table));
    return print(textOf(growthOf(table)));
}

}  // namespace wend
