#include "core/factor/worker_pool.h"

#include <algorithm>
#include <utility>

namespace wend {
namespace {

constexpr std::uint32_t kClosed = 0xffffffffU;
constexpr int kSpins =
    10000;  // a fraction of a millisecond: longer than what one thread does between two loops

std::uint64_t ticketOf(std::uint32_t job, std::uint32_t next) {
    return (std::uint64_t{job} << 32U) | next;
}
std::uint32_t jobOf(std::uint64_t ticket) {
    return static_cast<std::uint32_t>(ticket >> 32U);
}
std::uint32_t nextOf(std::uint64_t ticket) {
    return static_cast<std::uint32_t>(ticket);
}

void relax() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#else
    std::this_thread::yield();
#endif
}

}  // namespace

WorkerPool::WorkerPool(int threads) : m_ticket(ticketOf(0, kClosed)) {
    if (threads <= 0) threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    for (int i = 1; i < threads; ++i)
        m_threads.emplace_back([this](const std::stop_token& stop) { serve(stop); });
}

WorkerPool::~WorkerPool() {
    for (auto& thread : m_threads) thread.request_stop();
    publish(kClosed);
    m_threads.clear();
}

/// Publishes another job, which wakes the threads that sleep. kClosed wakes them without giving them work.
void WorkerPool::publish(std::uint32_t next) {
    m_ticket.store(ticketOf(jobOf(m_ticket.load()) + 1, next));
    m_ticket.notify_all();
}

/// Gives the loop its share of the progress, and adds that to the finished part when it has ended.
void WorkerPool::run(int count, int grain, Function function, void* context) {
    m_share = std::exchange(m_nextShare, 0) * (1 - m_part);
    m_done.store(0);
    shareOut(count, grain, function, context);
    m_part += std::exchange(m_share, 0);
}

// The ticket is closed before the job's fields change: a thread that read the old ticket and a new field then
// fails to claim.
void WorkerPool::shareOut(int count, int grain, Function function, void* context) {
    const int pieces = (count + grain - 1) / grain;
    if (m_threads.empty() || pieces <= 1) {
        m_count = count;
        m_function = function;
        m_context = context;
        for (int begin = 0; begin < count; begin += grain) doPiece(begin, std::min(count, begin + grain));
        return;
    }
    m_ticket.store(ticketOf(jobOf(m_ticket.load()) + 1, kClosed));
    m_finished.store(0);
    m_pieces.store(pieces);
    m_count = count;
    m_grain = grain;
    m_function = function;
    m_context = context;
    publish(0);
    while (claimAndDo()) {
    }
    for (int i = 0; m_finished.load() < pieces; ++i) {
        if (i < kSpins)
            relax();
        else
            std::this_thread::yield();
    }
}

/// Does a piece unless the work was stopped, and reports progress when it passes a hundredth.
void WorkerPool::doPiece(int begin, int end) {
    if (m_stop.stop_requested()) return;
    m_function(m_context, begin, end);
    if (m_share == 0 || !m_progress) return;
    const int before = m_done.fetch_add(end - begin);
    const auto part = [&](int done) { return m_part + m_share * done / m_count; };
    const double now = part(before + end - begin);
    if (static_cast<int>(100 * now) > static_cast<int>(100 * part(before))) m_progress(now);
}

/// Claims the next piece of the current job, and does it. Returns false if there is none. The claim succeeds
/// only while the ticket is still the one from which job and piece were read, so a thread that was suspended
/// meanwhile cannot do a piece of a later job with fields of an earlier one.
bool WorkerPool::claimAndDo() {
    std::uint64_t ticket = m_ticket.load();
    while (true) {
        const std::uint32_t piece = nextOf(ticket);
        if (piece == kClosed || piece >= static_cast<std::uint32_t>(m_pieces.load())) return false;
        if (m_ticket.compare_exchange_weak(ticket, ticket + 1)) {
            const int begin = static_cast<int>(piece) * m_grain;
            doPiece(begin, std::min(m_count, begin + m_grain));
            m_finished.fetch_add(1);
            return true;
        }
    }
}

/// Spins for a short while until another job is published, and then sleeps until that happens.
std::uint64_t WorkerPool::waitForWork(std::uint64_t seen) {
    for (int i = 0; i < kSpins; ++i) {
        const std::uint64_t now = m_ticket.load();
        if (jobOf(now) != jobOf(seen)) return now;
        relax();
    }
    std::uint64_t now = m_ticket.load();
    while (jobOf(now) == jobOf(seen)) {
        m_ticket.wait(now);
        now = m_ticket.load();
    }
    return now;
}

/// Does pieces of one job after another until the pool ends.
void WorkerPool::serve(const std::stop_token& stop) {
    std::uint64_t seen = ticketOf(0, kClosed);
    while (!stop.stop_requested()) {
        seen = waitForWork(seen);
        while (claimAndDo()) {
        }
    }
}

}  // namespace wend
