#pragma once

#include <string>

namespace wend {

/// What a program that computes for this one does first (see runChild): it ends when its parent does, and
/// keeps to the memory in megabytes and the seconds of the processor's time that its arguments give.
void beginHelper(int argc, char** argv);

std::string readAll(int fd);
bool writeAll(int fd, const std::string& bytes);

}  // namespace wend
