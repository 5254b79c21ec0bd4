#pragma once

#include <string>
#include <string_view>

namespace wend {

/// Writes to what is no regular file: a pipe, a terminal, a device. `name` is for messages. It waits for a
/// reader that is slow, and stops waiting when reading stops, too (stopReading()). Throws InputError(name,
/// reason) and Cancelled.
void writeStream(int descriptor, std::string_view bytes, const std::string& name);
/// The same by its path. A pipe that nobody reads from is refused at once.
void writeStream(const std::string& path, std::string_view bytes, const std::string& name);

}  // namespace wend
