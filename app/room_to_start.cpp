// Under a limit on addresses (ulimit -v), libraries end the process while they are being initialized:
// OpenBLAS starts threads then, and raises a signal when it gets none. So the program checks whether there is
// room before the first of their constructors runs; only the linker's own failures come earlier. Unneeded
// threads must not take the room later either: each thread of OpenBLAS takes a buffer of 128 MB, and asks for
// it endlessly if there is none; each thread's own arena of malloc reserves as much.

#include <alloca.h>
#include <malloc.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>

#include "core/base/address_room.h"

namespace {

constexpr std::size_t kRoom = std::size_t(256) << 20;

/// Writes with a system call, because nothing is initialized yet, not even the C++ library; needs nothing but
/// what the linker itself uses.
void say(const char* text) {
    if (write(STDERR_FILENO, text, std::strlen(text)) < 0) _exit(1);
}

/// Starts the program again with OpenBLAS limited to one thread. OpenBLAS reads this setting during its
/// initialization, from the environment with which the process was started. If starting again fails, the
/// program continues unchanged.
void useOneBlasThread(char** argv, char** environment) {
    static char setting[] = "OPENBLAS_NUM_THREADS=1";
    const std::size_t nameLength = sizeof setting - 2;
    std::size_t count = 0;
    while (environment[count] != nullptr) ++count;
    auto** next = static_cast<char**>(alloca((count + 2) * sizeof(char*)));
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (std::strcmp(environment[i], setting) == 0) return;
        if (std::strncmp(environment[i], setting, nameLength) != 0) next[kept++] = environment[i];
    }
    next[kept++] = setting;
    next[kept] = nullptr;
    execve("/proc/self/exe", argv, next);
}

void requireRoom(int argc, char** argv, char** environment) {
    if (!wend::limitsAddresses()) return;
    useOneBlasThread(argv, environment);
    mallopt(M_ARENA_MAX, 1);
    if (wend::hasAddressRoom(kRoom)) return;
    say("wend: ");
    if (argc > 1) say(argv[argc > 2 && argv[2][0] != '-' ? 2 : 1]), say(": ");
    say("there is not enough memory to start: 256 MB more are needed (see ulimit -v)\n");
    _exit(5);  // ExitCode::Machine
}

// The dynamic linker calls this function before the libraries' constructors.
__attribute__((section(".preinit_array"), used)) void (*const beforeAll)(int, char**, char**) = requireRoom;

}  // namespace
