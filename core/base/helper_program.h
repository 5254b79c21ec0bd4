#pragma once

#include <string>

namespace wend {

/// Is called first in a helper program (see runChild): the helper ends with its parent, and limits itself to
/// the memory in megabytes and the CPU seconds in its arguments.
void beginHelper(int argc, char** argv);

/// Is called first in a helper program that a ChildLink starts: the helper ends with its parent, limits
/// itself to the memory in its argument, and discards what its libraries print. Returns its end of the
/// socket.
int beginLinkedHelper(int argc, char** argv);

/// Lets the process compute for that many more seconds, after which it ends with SIGXCPU.
void allowTime(double seconds);

/// Returns all bytes up to the end of a file or pipe.
std::string readAll(int fd);
/// Writes all bytes; returns false if that fails.
bool writeAll(int fd, const std::string& bytes);

}  // namespace wend
