#pragma once

namespace wend {

/// Sets what endProcess() does first, with the exit code. It may run in any thread and in a signal handler;
/// null: nothing.
void setLastAct(void (*act)(int code)) noexcept;

/// Ends the process at once, without any clean-up.
[[noreturn]] void endProcess(int code) noexcept;

}  // namespace wend
