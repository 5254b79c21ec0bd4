#include "core/base/last_act.h"

#include <unistd.h>

#include <atomic>

namespace wend {
namespace {

std::atomic<void (*)(int)> lastAct = nullptr;

}  // namespace

void setLastAct(void (*act)(int code)) noexcept {
    lastAct = act;
}

void endProcess(int code) noexcept {
    if (const auto act = lastAct.exchange(nullptr)) act(code);
    _exit(code);
}

}  // namespace wend
