#pragma once

#include <sys/mman.h>
#include <sys/resource.h>

#include <cstddef>

namespace wend {

/// Whether the process runs under a limit on its addresses (ulimit -v).
inline bool limitsAddresses() {
    rlimit limit{};
    return getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

/// Whether so many bytes of addresses can still be had. Under a limit on them (ulimit -v) libraries end the
/// process while they are being initialized. System calls alone: it may be called before anything is
/// initialized.
inline bool hasAddressRoom(std::size_t bytes) {
    if (!limitsAddresses()) return true;
    void* room = mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    return room != MAP_FAILED && munmap(room, bytes) == 0;
}

}  // namespace wend
