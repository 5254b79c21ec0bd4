#pragma once

#include <string>
#include <string_view>

namespace wend {

/// Writes to a special file: a pipe, a terminal, a device. `name` is for messages. Waits for slow readers
/// until stopReading(). Throws InputError(name, reason) and Cancelled.
void writeStream(int descriptor, std::string_view bytes, const std::string& name);
/// Writes to a special file by its path. A pipe without a reader is refused at once.
void writeStream(const std::string& path, std::string_view bytes, const std::string& name);

}  // namespace wend
