#pragma once

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <spawn.h>
#include <sys/shm.h>
#include <sys/types.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <new>
#include <utility>

// Parts that both kinds of child processes share (child_process.h, child_link.h).

namespace wend {

/// A file descriptor that closes itself.
class Descriptor {
  public:
    explicit Descriptor(int fd = -1) : m_fd(fd) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { reset(); }
    void reset(int fd = -1) {
        if (m_fd >= 0) close(m_fd);
        m_fd = fd;
    }
    int get() const { return m_fd; }

  private:
    int m_fd;
};

/// Makes a pipe whose ends no other program inherits.
inline bool makePipe(Descriptor& readEnd, Descriptor& writeEnd) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return false;
    readEnd.reset(ends[0]);
    writeEnd.reset(ends[1]);
    return true;
}

/// Makes writing to a child that has died an error instead of the end of this program.
class IgnoreBrokenPipe {
  public:
    IgnoreBrokenPipe() {
        sigemptyset(&m_set);
        sigaddset(&m_set, SIGPIPE);
        pthread_sigmask(SIG_BLOCK, &m_set, &m_old);
    }
    IgnoreBrokenPipe(const IgnoreBrokenPipe&) = delete;
    IgnoreBrokenPipe& operator=(const IgnoreBrokenPipe&) = delete;
    ~IgnoreBrokenPipe() {
        const timespec now{0, 0};
        while (sigtimedwait(&m_set, nullptr, &now) > 0) continue;
        pthread_sigmask(SIG_SETMASK, &m_old, nullptr);
    }

  private:
    sigset_t m_set{}, m_old{};
};

/// Memory that two processes share until both have detached it. It is System V shared memory, because a
/// memory file would count against the limit of file sizes (ulimit -f).
class SharedMemory {
  public:
    SharedMemory() = default;
    SharedMemory(const SharedMemory&) = delete;
    SharedMemory& operator=(const SharedMemory&) = delete;
    ~SharedMemory() { reset(); }

    /// Detaches the memory.
    void reset() {
        if (m_at) shmdt(m_at);
        m_at = nullptr;
    }
    /// Allocates and attaches memory. Throws bad_alloc.
    std::byte* make(std::size_t size) {
        const int made = shmget(IPC_PRIVATE, size, 0600);
        if (made < 0) throw std::bad_alloc();
        try {
            attach(made);
        } catch (...) {
            shmctl(made, IPC_RMID, nullptr);
            throw;
        }
        shmctl(made, IPC_RMID,
               nullptr);  // takes effect when nobody has it attached; Linux lets others attach it until then
        return static_cast<std::byte*>(m_at);
    }
    /// Attaches memory that another process has allocated. Throws bad_alloc.
    std::byte* attach(int id) {
        reset();
        void* at = shmat(id, nullptr, 0);
        if (at == reinterpret_cast<void*>(-1)) throw std::bad_alloc();
        m_at = at, m_id = id;
        return static_cast<std::byte*>(m_at);
    }
    /// Returns the number by which another process attaches the memory.
    int id() const { return m_id; }

  private:
    void* m_at = nullptr;
    int m_id = -1;
};

/// Detaches a child from the terminal (Ctrl-C reaches this program alone, which then stops the child), with
/// no signal blocked or ignored.
class Attributes {
  public:
    Attributes() {
        sigset_t none, usual;
        sigemptyset(&none);
        sigemptyset(&usual);
        for (int signal : {SIGPIPE, SIGXFSZ, SIGXCPU, SIGINT, SIGTERM}) sigaddset(&usual, signal);
        posix_spawnattr_init(&m_attributes);
        posix_spawnattr_setpgroup(&m_attributes, 0);
        posix_spawnattr_setsigmask(&m_attributes, &none);
        posix_spawnattr_setsigdefault(&m_attributes, &usual);
        posix_spawnattr_setflags(&m_attributes,
                                 POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    }
    Attributes(const Attributes&) = delete;
    Attributes& operator=(const Attributes&) = delete;
    ~Attributes() { posix_spawnattr_destroy(&m_attributes); }
    const posix_spawnattr_t* get() const { return &m_attributes; }

  private:
    posix_spawnattr_t m_attributes{};
};

/// Detects whether a child has become idle: its process group has neither produced output nor used CPU time
/// for that many seconds. With 0 seconds it never becomes idle.
class IdleWatch {
  public:
    IdleWatch(pid_t group, double seconds) : m_group(group), m_seconds(seconds) {}

    /// Returns whether the child is idle; `said` is how many bytes it has written so far. Reads /proc at most
    /// five times a second.
    bool isIdle(std::size_t said);

  private:
    using Clock = std::chrono::steady_clock;

    pid_t m_group;
    double m_seconds;
    std::pair<unsigned long, std::size_t> m_state;
    Clock::time_point m_since = Clock::now(), m_next = m_since;
};

}  // namespace wend
