// wend-hdf5: reads a message (hdf5_message.h) from standard input, and writes its answer to standard output.
// It is a program of its own because the HDF5 library may crash or never end on damaged files.

#include <fcntl.h>
#include <hdf5.h>
#include <unistd.h>

#include <new>
#include <stdexcept>

#include "core/base/error.h"
#include "core/base/helper_program.h"
#include "core/mesh/hdf5/hdf5_message.h"
#include "core/mesh/hdf5/hdf5_reading.h"

namespace {

/// The library may print: the answer keeps the pipe, and what is printed is discarded.
int takeStandardOutput() {
    const int pipe = dup(STDOUT_FILENO), nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    return pipe;
}

std::string answerTo(std::string request) {
    if (request.empty()) return wend::kHdf5Failed + std::string("is empty");
    const char wish = request[0];
    request.erase(0, 1);
    try {
        if (wish == wend::kHdf5Read) return wend::kHdf5Done + wend::packed(wend::treeOfFile(request));
        return wend::kHdf5Done + wend::fileOfTree(wend::unpackedTree(request), wish == wend::kHdf5Compress);
    } catch (const std::bad_alloc&) {
        return wend::kHdf5Failed + std::string("there is not enough memory for it");
    } catch (const std::exception& error) {
        return wend::kHdf5Failed + std::string(error.what());
    }
}

}  // namespace

int main(int argc, char** argv) {
    wend::beginHelper(argc, argv);
    const int pipe = takeStandardOutput();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    const bool written = wend::writeAll(pipe, answerTo(wend::readAll(STDIN_FILENO)));
    _exit(written ? 0 : 1);
}
