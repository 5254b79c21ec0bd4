#include "bench/window_drag.h"

#include <QCoreApplication>
#include <QMouseEvent>
#include <QTimer>
#include <QWidget>
#include <cmath>
#include <stdexcept>

#include "app/session/shape_session.h"
#include "core/base/error.h"

namespace wend {
namespace {

constexpr double kMovesEvery = 8;       // milliseconds: 125 a second, as most mice
constexpr double kMostWaited = 120000;  // for the first frame

}  // namespace

WindowDrag::WindowDrag(Parts parts) : m_parts(std::move(parts)) {
    m_parts.view.installEventFilter(this);
}

void WindowDrag::send(QEvent::Type type, const QPointF& at) {
    const bool moves = type == QEvent::MouseMove, ends = type == QEvent::MouseButtonRelease;
    QMouseEvent event(type, at, m_parts.view.mapToGlobal(at), moves ? Qt::NoButton : Qt::LeftButton,
                      ends ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&m_parts.view, &event);
}

/// Notes when a frame is on the screen, which is when the window has been painted completely: a call that is
/// queued now follows that.
bool WindowDrag::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Paint && watched == &m_parts.view && m_parts.session.motion().isDragging()) {
        const FramePtr frame = m_parts.drawn();
        if (frame && frame->live && frame != m_before && frame->sample > m_shown) {
            const int sample = frame->sample;
            QMetaObject::invokeMethod(
                this, [this, sample] { takeShown(sample); }, Qt::QueuedConnection);
        }
    }
    return QObject::eventFilter(watched, event);
}

void WindowDrag::takeShown(int sample) {
    if (sample <= m_shown || sample >= static_cast<int>(m_sent.size())) return;
    m_shown = sample;
    if (m_times.shown.empty()) m_times.first = now();
    m_times.shown.push_back(now());
    m_times.latency.push_back(now() - m_sent[static_cast<std::size_t>(sample)]);
}

/// Sends the newest move that is due by now, in place of all since the last one.
void WindowDrag::moveWhenDue(const std::function<QPointF(double)>& path) {
    const double due = kMovesEvery * std::floor(now() / kMovesEvery);
    if (m_sent.size() > 1 && due <= m_sent.back()) return;
    const QPointF at = m_from + path(due * 1e-3);
    if (at == m_last) return;
    m_last = at;
    m_sent.push_back(m_sent.size() > 1 ? due : now());
    send(QEvent::MouseMove, at);
}

WindowDrag::Times WindowDrag::drag(const QPointF& from, const std::function<QPointF(double)>& path,
                                   double seconds, std::stop_token stop) {
    m_times = {};
    m_before = m_parts.drawn();
    m_shown = 0;
    m_from = m_last = from;
    m_clock.start();
    m_sent = {0};
    send(QEvent::MouseButtonPress, from);
    // Far enough for a drag to begin, at once.
    m_last = from + path(0.1);
    m_sent.push_back(0);
    send(QEvent::MouseMove, m_last);
    if (!m_parts.session.motion().isDragging()) throw std::runtime_error("there is nothing to drag");
    QTimer due;  // wakes the loop for the next move, which otherwise sleeps as a program's does
    due.setTimerType(Qt::PreciseTimer);
    due.setSingleShot(true);
    while (now() < 1e3 * seconds || (m_times.shown.empty() && now() < kMostWaited)) {
        if (stop.stop_requested()) throw Cancelled();
        moveWhenDue(path);
        due.start(static_cast<int>(std::ceil(kMovesEvery - std::fmod(now(), kMovesEvery))));
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    send(QEvent::MouseButtonRelease, m_last);
    if (m_times.shown.empty()) throw std::runtime_error("the shape did not follow");
    return m_times;
}

}  // namespace wend
