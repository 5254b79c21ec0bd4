#pragma once

#include <stop_token>
#include <string>

#include "core/base/error.h"

namespace wend {

/// Thrown if the mesher is missing or was killed from outside: the surface is not the cause.
class MesherLost : public InputError {
  public:
    using InputError::InputError;
};

/// A helper program that meshes: it may exceed memory or time, and can be killed at any moment.
struct MesherProcess {
    const char* program;
    const char* name;             // in messages
    Sentence late;                // the message when its time is over, with the seconds that it had
    double secondsPerPart = 120;  // of computing, for each 50 000 triangles that the surface begins
};

/// Returns the helper's answer to a request with that many triangles. Throws InputError with the reason for
/// none; MesherLost; Cancelled.
std::string answerOf(const MesherProcess& mesher, const std::string& request, int triangles,
                     const std::stop_token& stop);

}  // namespace wend
