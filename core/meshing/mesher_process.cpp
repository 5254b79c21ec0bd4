#include "core/meshing/mesher_process.h"

#include <csignal>

#include "core/base/child_process.h"
#include "core/base/number_text.h"

namespace wend {
namespace {

constexpr int kMegabytes = 8192;         // address space
constexpr int kTrianglesInPart = 50000;  // see MesherProcess::secondsPerPart

/// Describes why the helper gave no answer. Throws MesherLost if it is missing or was killed from outside.
Message failureOf(const MesherProcess& mesher, const ChildResult& result, double seconds) {
    using End = ChildResult::End;
    const std::string name = mesher.name, signal = "(signal " + std::to_string(result.code) + ")";
    switch (result.end) {
        case End::NotStarted:
            throw MesherLost(name + " " + mesher.program + " is missing beside the program");
        case End::TimedOut:
        case End::Idle:
            return {mesher.late, numberText(seconds)};
        case End::Stopped:
            throw Cancelled();
        case End::Signalled:
            // These signals come from outside: the surface is not the cause.
            if (result.code == SIGKILL || result.code == SIGTERM)
                throw MesherLost(name + " was ended " + signal);
            return name + " failed inside " + signal;
        case End::Exited:
            return result.code == 0 ? "" : name + " failed (exit code " + std::to_string(result.code) + ")";
    }
    return {};
}

}  // namespace

std::string answerOf(const MesherProcess& mesher, const std::string& request, int triangles,
                     const std::stop_token& stop) {
    // The load of the machine must not decide what can be meshed: the wall-clock limit is generous.
    const double seconds = mesher.secondsPerPart * (1 + triangles / kTrianglesInPart);
    const ChildResult result =
        runChild(siblingProgram(mesher.program), request, 10 * seconds, kMegabytes, stop, seconds);
    const Message reason = failureOf(mesher, result, seconds);
    if (!reason.isEmpty()) throw InputError(reason);
    return result.output;
}

}  // namespace wend
