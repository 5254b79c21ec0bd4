#include "app/engine/motion/mailbox.h"

namespace wend {

namespace {

/// Returns whether `next` supersedes `last`, the newest waiting request.
bool replaces(const Request& next, const Request& last) {
    return next.index() == last.index() &&
           (std::holds_alternative<SetShape>(next) || std::holds_alternative<DragTo>(next) ||
            std::holds_alternative<AskField>(next));
}

}  // namespace

void Mailbox::post(Request request) {
    {
        const std::lock_guard lock(m_mutex);
        if (!m_requests.empty() && replaces(request, m_requests.back())) m_requests.pop_back();
        m_requests.push_back(std::move(request));
        m_interruption.request_stop();
    }
    m_arrived.notify_one();
}

std::optional<Request> Mailbox::take(bool wait, std::stop_token stop) {
    std::unique_lock lock(m_mutex);
    m_isAwaited = wait;
    if (wait) m_arrived.wait(lock, stop, [this] { return !m_requests.empty(); });
    m_isAwaited = false;
    if (m_requests.empty() || stop.stop_requested()) return {};
    Request request = std::move(m_requests.front());
    m_requests.pop_front();
    return request;
}

bool Mailbox::isAwaited() const {
    const std::lock_guard lock(m_mutex);
    return m_isAwaited && m_requests.empty();
}

std::stop_token Mailbox::interruption() {
    const std::lock_guard lock(m_mutex);
    m_interruption = std::stop_source();
    if (m_closed || !m_requests.empty()) m_interruption.request_stop();
    return m_interruption.get_token();
}

void Mailbox::close() {
    const std::lock_guard lock(m_mutex);
    m_closed = true;
    m_interruption.request_stop();
}

}  // namespace wend
