#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/base/child_process.h"

namespace wend {

/// A helper program that stays alive and answers requests, one at a time. Its standard input is a socket for
/// messages in both directions. Its argument is the memory limit in megabytes, which it must set for itself
/// (beginLinkedHelper). One thread uses it at a time.
class ChildLink {
  public:
    /// Starts the program at `path`.
    ChildLink(const std::string& path, int megabytes);
    ChildLink(const ChildLink&) = delete;
    ChildLink& operator=(const ChildLink&) = delete;
    /// Kills the program.
    ~ChildLink();

    /// Returns false if the program has ended.
    bool send(const std::string& message);
    /// Returns false if the program has ended, or was killed here because its process group used no CPU time
    /// for `idleSeconds`. `goOn` is called several times a second and may throw.
    bool receive(std::string& message, double idleSeconds, const std::function<void()>& goOn);
    /// Waits for the program to end, which receive() has announced, and returns how it ended, without output.
    ChildResult end();

  private:
    struct Process;
    std::unique_ptr<Process> m_process;
};

/// Sends a message through a socket. Returns false if the other end is closed.
bool sendMessage(int socket, const std::string& message);

/// Receives a message from a socket. Returns false if the other end is closed, or once `isAwaited`, which is
/// called 20 times a second if given, returns false.
bool receiveMessage(int socket, std::string& message, const std::function<bool()>& isAwaited = {});

}  // namespace wend
