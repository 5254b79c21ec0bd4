#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

namespace wend::test {

/// Limits the address space to the part in use plus a number of megabytes.
class AddressLimit {
  public:
    explicit AddressLimit(int megabytes) {
        getrlimit(RLIMIT_AS, &m_before);
        std::ifstream pages("/proc/self/statm");
        rlim_t used = 0;
        pages >> used;
        rlimit limit = m_before;
        limit.rlim_cur =
            used * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + static_cast<rlim_t>(megabytes) * 1000000;
        setrlimit(RLIMIT_AS, &limit);
    }
    ~AddressLimit() { setrlimit(RLIMIT_AS, &m_before); }
    AddressLimit(const AddressLimit&) = delete;
    AddressLimit& operator=(const AddressLimit&) = delete;

  private:
    rlimit m_before{};
};

}  // namespace wend::test
