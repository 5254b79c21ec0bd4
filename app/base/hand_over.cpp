#include "app/base/hand_over.h"

#include <QCoreApplication>
#include <QEvent>
#include <utility>

namespace wend {

namespace {

const QEvent::Type kCall = static_cast<QEvent::Type>(QEvent::registerEventType());

}  // namespace

void HandOver::call(std::function<void()> call) {
    const std::lock_guard lock(m_mutex);
    m_calls.push_back(std::move(call));
    QCoreApplication::postEvent(this, new QEvent(kCall));
}

bool HandOver::isEmpty() const {
    const std::lock_guard lock(m_mutex);
    return m_calls.empty();
}

bool HandOver::event(QEvent* event) {
    if (event->type() != kCall) return QObject::event(event);
    std::function<void()> call;
    {
        const std::lock_guard lock(m_mutex);
        call = std::move(m_calls.front());
        m_calls.pop_front();
    }
    call();
    return true;
}

}  // namespace wend
