#pragma once

#include <string>

namespace wend {

/// First call of a helper program (see runChild): it ends with its parent, and limits itself to the memory in
/// megabytes and the CPU seconds in its arguments.
void beginHelper(int argc, char** argv);

/// First call of a helper program that a ChildLink starts: it ends with its parent, limits itself to the
/// memory in its argument, and what its libraries print goes nowhere. Returns its end of the socket.
int beginLinkedHelper(int argc, char** argv);

/// Lets the process compute for that many more seconds: then it ends with SIGXCPU.
void allowTime(double seconds);

std::string readAll(int fd);
bool writeAll(int fd, const std::string& bytes);

}  // namespace wend
