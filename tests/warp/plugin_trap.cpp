// A plug-in in the folder that OpenImageIO searches: a process that loads it leaves a file.
#include <cstdio>
#include <cstdlib>

namespace {

bool spring() {
    const char* path = std::getenv("WEND_TEST_PLUGIN");
    std::FILE* file = path ? std::fopen(path, "w") : nullptr;
    return file && std::fclose(file) == 0;
}

const bool sprung = spring();

}  // namespace
