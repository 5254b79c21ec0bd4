#pragma once

#include <sys/mman.h>
#include <sys/resource.h>

#include <cstddef>

namespace wend {

/// Returns whether the process runs under a limit on its address space (ulimit -v).
inline bool limitsAddresses() {
    rlimit limit{};
    return getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

/// Returns whether that many bytes of address space are available. Under a limit (ulimit -v) libraries end
/// the process during their initialization. Uses system calls only, so it may be called before anything is
/// initialized.
inline bool hasAddressRoom(std::size_t bytes) {
    if (!limitsAddresses()) return true;
    void* room = mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    return room != MAP_FAILED && munmap(room, bytes) == 0;
}

}  // namespace wend
