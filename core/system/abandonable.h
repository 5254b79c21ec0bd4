#pragma once

#include <functional>
#include <stop_token>

namespace wend {

/// Runs what cannot be stopped, as a call of a library, and returns true when it has come to its end. As soon
/// as `stop` asks, returns false instead, and the work goes on in a thread of its own: it must own all that
/// it touches. Without anybody who could ask it runs in the caller's thread. Throws what the work throws. The
/// process does not end before such threads do.
bool runAbandonable(std::function<void()> work, const std::stop_token& stop);

}  // namespace wend
