#include <cstdio>

#include "app/bench/bench.h"
#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/document/text_file.h"
#include "app/session/output_set.h"

namespace wend {

ExitCode runBench(const Arguments& arguments) {
    const std::string output = arguments.text("--output");
    requirePlaces({output});
    const std::string folder = arguments.text("--keep");
    const Interrupt interrupt;
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
