#include "python/interruptible.h"

#include <chrono>

namespace wend::python {
namespace {

// How often Ctrl-C is looked for while nothing is reported.
constexpr std::chrono::milliseconds kLook(20);

/// Passes calls from the thread that works to the one that waits.
class Mailbox {
  public:
    void report(double value) {
        const std::scoped_lock lock(m_mutex);
        m_value = value;
        m_changed.notify_one();
    }
    void end(std::exception_ptr error) {
        const std::scoped_lock lock(m_mutex);
        m_error = std::move(error);
        m_ended = true;
        m_changed.notify_one();
    }
    /// Waits for news, and a little while at most.
    void wait() {
        std::unique_lock lock(m_mutex);
        m_changed.wait_for(lock, kLook, [this] { return m_ended || m_value; });
    }
    std::optional<double> take() {
        const std::scoped_lock lock(m_mutex);
        return std::exchange(m_value, std::nullopt);
    }
    bool hasEnded() {
        const std::scoped_lock lock(m_mutex);
        return m_ended;
    }
    std::exception_ptr error() const { return m_error; }

  private:
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::optional<double> m_value;
    std::exception_ptr m_error;
    bool m_ended = false;
};

}  // namespace

void runInterruptibly(const std::function<void(double)>& progress, const Work& work) {
    Mailbox mailbox;
    std::jthread worker([&](const std::stop_token& stop) {
        std::exception_ptr error;
        try {
            work(stop, [&](double value) { mailbox.report(value); });
        } catch (...) {
            error = std::current_exception();
        }
        mailbox.end(error);
    });
    const auto leave = [&] {  // with an error of Python's, once the work has stopped
        worker.request_stop();
        const py::gil_scoped_release released;
        worker.join();
    };
    for (bool ended = false; !ended;) {
        {
            const py::gil_scoped_release released;
            mailbox.wait();
        }
        ended = mailbox.hasEnded();
        try {
            if (const auto value = mailbox.take(); value && progress) progress(*value);
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        } catch (...) {
            leave();
            throw;
        }
    }
    leave();
    if (mailbox.error()) std::rethrow_exception(mailbox.error());
}

}  // namespace wend::python
