#pragma once

#include <stop_token>
#include <string>

#include "core/mesh/error.h"

namespace wend {

/// The program that meshes is not there, or was ended by somebody else: no surface is to blame.
class MesherLost : public InputError {
  public:
    using InputError::InputError;
};

/// A program beside this one that meshes: what it does may need more memory or time than there is, and can be
/// stopped at any moment.
struct MesherProcess {
    const char* program;
    const char* name;             // in messages
    const char* late;             // the beginning of what is said where its time runs out …
    const char* help;             // … and its end
    double secondsPerPart = 120;  // of computing, for each 50 000 triangles that the surface begins
};

/// What it answers to the request about so many triangles. Throws InputError: why there is none; MesherLost;
/// Cancelled.
std::string answerOf(const MesherProcess& mesher, const std::string& request, int triangles,
                     const std::stop_token& stop);

}  // namespace wend
