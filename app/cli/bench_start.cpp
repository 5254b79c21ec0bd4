#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "app/cli/commands.h"
#include "core/base/child_process.h"
#include "core/base/error.h"

namespace wend {

ExitCode startBench(const Arguments& arguments) {
    const std::string program = siblingProgram("wend-bench");
    std::vector<std::string> words{program};
    words.insert(words.end(), arguments.words().begin(), arguments.words().end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    execv(program.c_str(), pointers.data());
    throw InputError(program, std::string("the benchmark cannot be started: ") + std::strerror(errno));
}

}  // namespace wend
