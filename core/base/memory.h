#pragma once

#include <new>
#include <string>

namespace wend {

/// Thrown before memory is taken that the machine does not have. what() is "needs about 7.9 GB of memory; 5.1
/// GB are free", one line.
class NotEnoughMemory : public std::bad_alloc {
  public:
    NotEnoughMemory(double needed, double free);
    const char* what() const noexcept override { return m_what.c_str(); }

    /// Return the bytes that are needed, and those that are free.
    double needed() const { return m_needed; }
    double free() const { return m_free; }

  private:
    double m_needed, m_free;
    std::string m_what;
};

/// Returns how many bytes this process can still take: the least of what the system has available, of the
/// addresses that a limit (ulimit -v) leaves, and of what the process's control groups leave; infinite where
/// nothing of this is known. Files of the system are looked for below `root`.
double freeMemory(const std::string& root = "");

/// Throws NotEnoughMemory if so many bytes are not free. Other programs may take the memory afterwards:
/// allocations may still fail.
void requireMemory(double bytes);

/// Returns "7.9 GB", "512 MB" or "12 kB". Units are powers of 1000; GB have one decimal place, the others
/// none.
std::string byteText(double bytes);

}  // namespace wend
