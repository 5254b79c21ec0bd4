#pragma once

#include <functional>
#include <stop_token>

namespace wend {

/// Runs work that cannot be stopped, such as a call of a library, and returns true when it is done. When a
/// stop is requested, it returns false at once, and the work continues in a thread of its own; it must own
/// everything that it uses. If no stop can be requested, it runs in the caller's thread. Throws what the work
/// throws. The process does not end before such threads do.
bool runAbandonable(std::function<void()> work, const std::stop_token& stop);

}  // namespace wend
