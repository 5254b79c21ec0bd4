// Under a limit on addresses (ulimit -v), libraries end the process while they are being initialized:
// OpenBLAS starts threads then, and what it does when it gets none is a signal. So whether
// there is room is tried before the first of their constructors runs; only the linker's own failures come
// earlier. Threads share one arena of malloc then: each of their own would reserve 128 MB of addresses, at a
// time that nobody knows.

#include <malloc.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>

#include "core/system/address_room.h"

namespace {

constexpr std::size_t kRoom = std::size_t(256) << 20;

/// Nothing is initialized yet, not even the C++ library: system calls, and what the linker itself needs.
void say(const char* text) {
    if (write(STDERR_FILENO, text, std::strlen(text)) < 0) _exit(1);
}

void requireRoom(int argc, char** argv, char**) {
    if (!wend::limitsAddresses()) return;
    mallopt(M_ARENA_MAX, 1);
    if (wend::hasAddressRoom(kRoom)) return;
    say("wend: ");
    if (argc > 1) say(argv[argc > 2 && argv[2][0] != '-' ? 2 : 1]), say(": ");
    say("there is not enough memory to start: 256 MB more are needed (see ulimit -v)\n");
    _exit(1);
}

// The dynamic linker calls what stands here before the libraries' constructors.
__attribute__((section(".preinit_array"), used)) void (*const beforeAll)(int, char**, char**) = requireRoom;

}  // namespace
