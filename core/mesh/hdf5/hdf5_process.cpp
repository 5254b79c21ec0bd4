// The HDF5 library reads and writes in a process of its own, wend-hdf5: it may crash on damaged files, and
// takes time to load.

#include <csignal>

#include "core/base/child_process.h"
#include "core/base/error.h"
#include "core/mesh/hdf5/hdf5_message.h"
#include "core/mesh/hdf5/hdf5_tree.h"

namespace wend {
namespace {

constexpr int kMegabytes = 65536;      // address space
constexpr double kSeconds = 600;       // of computing
constexpr double kLongestWait = 3600;  // on a busy machine

/// Returns the program's answer to a request. Throws InputError.
std::string answerTo(const std::string& request) {
    using End = ChildResult::End;
    ChildResult result =
        runChild(siblingProgram("wend-hdf5"), request, kLongestWait, kMegabytes, {}, kSeconds);
    if (result.end == End::NotStarted)
        throw InputError(
            sentence("Core",
                     "HDF5 files need wend-hdf5, which is missing beside the program: it is built where "
                     "libhdf5-dev is installed"));
    if (result.end == End::Signalled && (result.code == SIGKILL || result.code == SIGTERM))
        throw InputError("the reader of HDF5 files was ended (signal " + std::to_string(result.code) + ")");
    if (result.end != End::Exited || result.code != 0 || result.output.empty())
        throw InputError(sentence("Core", "the HDF5 library fails on it: the file may be damaged"));
    if (result.output[0] == kHdf5Failed) throw InputError(result.output.substr(1));
    return std::move(result.output);
}

}  // namespace

Hdf5Node readHdf5(const std::string& bytes) {
    if (!isHdf5(bytes)) throw InputError(sentence("Core", "is no HDF5 file"));
    return unpackedTree(std::string_view(answerTo(kHdf5Read + bytes)).substr(1));
}

std::string printHdf5(const Hdf5Node& root, bool compressed) {
    return answerTo((compressed ? kHdf5Compress : kHdf5Write) + packed(root)).substr(1);
}

}  // namespace wend
