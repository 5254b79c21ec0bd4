#include "core/base/abandonable.h"

#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>

namespace wend {
namespace {

/// The threads for which no caller waits any more. What a library needs must not be destroyed before they
/// end.
class AbandonedThreads {
  public:
    ~AbandonedThreads() {
        std::unique_lock lock(m_mutex);
        m_ended.wait(lock, [this] { return m_count == 0; });
    }
    void begin() {
        const std::lock_guard lock(m_mutex);
        ++m_count;
    }
    void end() {
        const std::lock_guard lock(m_mutex);
        --m_count;
        m_ended.notify_all();
    }
    static AbandonedThreads& all() {
        static AbandonedThreads threads;
        return threads;
    }

  private:
    std::mutex m_mutex;
    std::condition_variable m_ended;
    int m_count = 0;
};

struct Attempt {
    std::mutex mutex;
    std::condition_variable_any changed;
    bool done = false;
    std::exception_ptr failure;
};

void attempt(const std::function<void()>& work, Attempt& attempt) {
    std::exception_ptr failure;
    try {
        work();
    } catch (...) {
        failure = std::current_exception();
    }
    const std::lock_guard lock(attempt.mutex);
    attempt.failure = failure;
    attempt.done = true;
    attempt.changed.notify_all();
}

}  // namespace

bool runAbandonable(std::function<void()> work, const std::stop_token& stop) {
    if (!stop.stop_possible()) {
        work();
        return true;
    }
    if (stop.stop_requested()) return false;
    struct Shared : Attempt {
        std::function<void()> work;
    };
    const auto shared = std::make_shared<Shared>();
    shared->work = std::move(work);
    AbandonedThreads& threads = AbandonedThreads::all();
    threads.begin();
    try {
        std::thread([own = shared, &threads]() mutable {
            attempt(own->work, *own);
            own->work = nullptr;  // with all that it owns, before the process may end
            own.reset();
            threads.end();
        }).detach();
    } catch (const std::system_error&) {  // there is no thread to be had
        threads.end();
        shared->work();
        return true;
    }
    std::unique_lock lock(shared->mutex);
    if (!shared->changed.wait(lock, stop, [&] { return shared->done; })) return false;
    if (shared->failure) std::rethrow_exception(shared->failure);
    return true;
}

}  // namespace wend
