#pragma once

#include <string>

namespace wend {

/// First call of a helper program (see runChild): it ends with its parent, and limits itself to the memory in
/// megabytes and the CPU seconds in its arguments.
void beginHelper(int argc, char** argv);

std::string readAll(int fd);
bool writeAll(int fd, const std::string& bytes);

}  // namespace wend
