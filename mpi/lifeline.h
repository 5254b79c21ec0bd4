#pragma once

#include <array>
#include <string>
#include <thread>
#include <vector>

#include "mpi/team.h"

namespace wend {

/// Notices processes of a team that are lost, for which MPI would wait for ever: each holds a connection with
/// the first process, and a thread waits for its end. The loss ends all processes with code 137 and one line,
/// which the first process says, or the second one of the first. A process that ends by itself, which says
/// why (endProcess()), ends the others with its own code. Where no connection comes about, as behind a
/// firewall, that process is not watched. One at a time.
class Lifeline {
  public:
    static constexpr int kLost = 137;  // what a shell gives to a process that was killed

    /// All processes must call it at the same time.
    explicit Lifeline(const Team& team);
    /// Announces the end; each process may end afterwards.
    ~Lifeline();
    Lifeline(const Lifeline&) = delete;
    Lifeline& operator=(const Lifeline&) = delete;

  private:
    struct Peer {
        int socket, rank;
        std::string host;
    };
    struct Meeting;
    void listen(bool isNear, Meeting& meeting);
    void accept(int count, const Meeting& meeting);
    bool connect(const Meeting& meeting);
    void watch();
    [[noreturn]] void endFor(const Peer& peer, int code);

    int m_rank, m_size;
    std::string m_host;  // empty if all processes are on one machine
    int m_listener = -1;
    std::vector<Peer> m_peers;  // of the first process all others, of these the first one
    std::array<int, 2> m_wake = {-1, -1};
    std::thread m_thread;
};

}  // namespace wend
