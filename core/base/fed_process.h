#pragma once

#include <sys/types.h>

#include <cstddef>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/child_parts.h"

namespace wend {

/// A program of the system that takes its input piece by piece, such as an encoder of films. If this object
/// is destroyed before the program has ended, its process group is killed. One thread uses it at a time.
class FedProcess {
  public:
    FedProcess(const std::string& program, const std::vector<std::string>& arguments);
    ~FedProcess();
    FedProcess(const FedProcess&) = delete;
    FedProcess& operator=(const FedProcess&) = delete;

    /// Waits until the program has taken all bytes. Returns false if it takes no more. Throws Cancelled.
    bool feed(std::span<const std::byte> bytes, const std::stop_token& stop = {});
    /// Ends the input and waits for the end. Returns whether the program succeeded. Throws Cancelled.
    bool finish(const std::stop_token& stop = {});
    /// Returns the beginning of its standard output and error, in the order of writing.
    const std::string& output() const { return m_output; }

  private:
    void exchange();
    void read();
    int wait();

    pid_t m_pid = 0;  // 0: not started, or ended
    Descriptor m_in, m_out;
    std::span<const std::byte> m_left;  // of the bytes to feed
    std::string m_output;
};

/// Returns the path of a program in the folders of the variable PATH; empty if none has it.
std::string programInPath(const std::string& name);

}  // namespace wend
