#include "app/session/mailbox.h"

namespace wend {

namespace {

/// True if `next` went into `last`, the newest request that waits.
bool mergeInto(Request& last, const Request& next) {
    if (std::holds_alternative<SetShape>(last) && std::holds_alternative<SetShape>(next)) {
        last = next;
        return true;
    }
    auto* first = std::get_if<DragTo>(&last);
    const auto* second = std::get_if<DragTo>(&next);
    if (!first || !second) return false;
    first->amounts.insert(first->amounts.end(), second->amounts.begin(), second->amounts.end());
    first->lastSample = second->lastSample;
    return true;
}

}  // namespace

void Mailbox::post(Request request) {
    {
        const std::lock_guard lock(m_mutex);
        if (m_requests.empty() || !mergeInto(m_requests.back(), request))
            m_requests.push_back(std::move(request));
        m_interruption.request_stop();
    }
    m_arrived.notify_one();
}

std::optional<Request> Mailbox::take(bool wait, std::stop_token stop) {
    std::unique_lock lock(m_mutex);
    if (wait) m_arrived.wait(lock, stop, [this] { return !m_requests.empty(); });
    if (m_requests.empty() || stop.stop_requested()) return {};
    Request request = std::move(m_requests.front());
    m_requests.pop_front();
    return request;
}

std::stop_token Mailbox::interruption() {
    const std::lock_guard lock(m_mutex);
    m_interruption = std::stop_source();
    if (!m_requests.empty()) m_interruption.request_stop();
    return m_interruption.get_token();
}

void Mailbox::interrupt() {
    const std::lock_guard lock(m_mutex);
    m_interruption.request_stop();
}

}  // namespace wend
