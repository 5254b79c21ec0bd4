#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <thread>
#include <type_traits>
#include <vector>

namespace wend {

/// A few threads that share loops over independent items. The caller works too and never waits for a thread
/// that the system has not woken: chunks are claimed one by one, so a busy machine slows nothing down. Which
/// thread does which chunk must not matter to the result. Idle threads spin for a fraction of a millisecond,
/// then sleep.
class WorkerPool {
  public:
    /// `threads` counts the caller; 0 means as many as the machine has.
    explicit WorkerPool(int threads);
    ~WorkerPool();
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    int threads() const { return static_cast<int>(m_threads.size()) + 1; }

    /// Gets the fraction of long work that is done, in [0, 1], from any thread.
    using Progress = std::function<void(double)>;
    /// Makes long work of several loops stoppable and observable. Once a stop is requested, loops skip the
    /// pieces that have not begun, and their results are invalid. While this object lives, nothing else may
    /// use the pool.
    class Watched {
      public:
        Watched(WorkerPool& pool, std::stop_token stop, Progress progress = {}) : m_pool(pool) {
            pool.m_stop = std::move(stop);
            pool.m_progress = std::move(progress);
            pool.m_part = pool.m_nextShare = 0;
        }
        ~Watched() {
            m_pool.m_stop = {};
            m_pool.m_progress = {};
            m_pool.m_nextShare = 0;
        }
        Watched(const Watched&) = delete;
        Watched& operator=(const Watched&) = delete;

      private:
        WorkerPool& m_pool;
    };
    bool isStopped() const { return m_stop.stop_requested(); }
    const std::stop_token& stop() const { return m_stop; }
    /// Gives the next loop this share of the watched work that is left. Other loops report no progress.
    void measureNext(double share) { m_nextShare = share; }

    /// Calls work(begin, end) on consecutive pieces of [0, count) of at most `grain` items; the pieces do not
    /// depend on the number of threads. `work` must not throw. It returns when all pieces are done; what they
    /// wrote is then visible to the caller. Loops must not be nested, and one thread at a time may start
    /// them. No item: `work` is not called.
    template <typename Work>
    void forPieces(int count, int grain, Work&& work) {
        using Plain = std::remove_reference_t<Work>;
        run(
            count, grain,
            [](void* context, int begin, int end) { (*static_cast<Plain*>(context))(begin, end); },
            const_cast<void*>(static_cast<const void*>(&work)));
    }

  private:
    using Function = void (*)(void*, int, int);
    void run(int count, int grain, Function function, void* context);
    void shareOut(int count, int grain, Function function, void* context);
    void doPiece(int begin, int end);
    void serve(const std::stop_token& stop);
    bool claimAndDo();
    std::uint64_t waitForWork(std::uint64_t seen);
    void publish(std::uint32_t next);

    // High word: number of the job; low word: the next piece of it. kClosed while a job is being set up.
    std::atomic<std::uint64_t> m_ticket;
    std::atomic<int> m_pieces{0};
    std::atomic<int> m_finished{0};
    int m_count = 0, m_grain = 1;
    Function m_function = nullptr;
    void* m_context = nullptr;
    std::stop_token m_stop;
    Progress m_progress;
    double m_part = 0, m_share = 0, m_nextShare = 0;  // before this loop, of this loop, of the next one
    std::atomic<int> m_done{0};                       // items of this loop, if it is measured
    std::vector<std::jthread> m_threads;
};

}  // namespace wend
