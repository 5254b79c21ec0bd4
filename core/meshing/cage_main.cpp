// wend-cage: reads a CageRequest from standard input, fits the cage, writes a CageReply to standard output.
// A program of its own so that it can be stopped at any moment, and that it alone ends where memory or time
// do not suffice.

#include <unistd.h>

#include <new>

#include "core/base/helper_program.h"
#include "core/meshing/cage_fitter.h"
#include "core/meshing/cage_protocol.h"

namespace {

wend::CageReply replyTo(const std::string& bytes) {
    wend::CageRequest request;
    if (!unpack(bytes, request)) return {"the cage mesher got an incomplete request", {}};
    return {{}, cageAround(request.surface, request.options)};
}

/// Answers the request on standard input.
std::string answer() {
    try {
        return pack(replyTo(wend::readAll(STDIN_FILENO)));
    } catch (const wend::InputError& error) {
        return pack(wend::CageReply{error.message(), {}});
    } catch (const std::bad_alloc&) {
        return pack(wend::CageReply{
            wend::sentence(
                "Core",
                "there is no memory for a cage of so many cells; fewer vertices or larger cells may help"),
            {}});
    }
}

}  // namespace

int main(int argc, char** argv) {
    wend::beginHelper(argc, argv);
    return wend::writeAll(STDOUT_FILENO, answer()) ? 0 : 1;
}
