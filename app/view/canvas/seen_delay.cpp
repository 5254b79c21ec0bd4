#include "app/view/canvas/seen_delay.h"

#include <QEvent>

#include "app/session/shape_session.h"

namespace wend {

SeenDelay::SeenDelay(ShapeSession& session) : m_session(session) {
    connect(&session, &ShapeSession::dragBegan, this, &SeenDelay::begin);
    connect(&session, &ShapeSession::dragMoved, this, &SeenDelay::noteMove);
}

void SeenDelay::watch(QWidget& view, std::function<FramePtr()> drawn) {
    m_views.push_back({&view, std::move(drawn)});
    view.installEventFilter(this);
}

void SeenDelay::begin() {
    m_moved.clear();
    m_shown = 0;
    const FramePtr frame = m_session.frame();
    m_past = frame && frame->live ? frame->gesture : -1;
    m_clock.start();
}

void SeenDelay::noteMove() {
    const DragGesture* drag = m_session.gesture();
    if (!drag) return;
    m_moved.resize(static_cast<std::size_t>(drag->sampleCount()) + 1, -1);
    m_moved.back() = m_clock.nsecsElapsed();
}

/// What is queued now comes after the window has been painted to its end.
bool SeenDelay::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Paint && m_session.isDragging())
        for (const View& view : m_views) {
            if (view.widget != watched) continue;
            const FramePtr frame = view.drawn();
            if (frame && frame->live && frame->gesture != m_past && frame->sample > m_shown)
                QMetaObject::invokeMethod(
                    this, [this, sample = frame->sample] { take(sample); }, Qt::QueuedConnection);
        }
    return QObject::eventFilter(watched, event);
}

void SeenDelay::take(int sample) {
    const auto index = static_cast<std::size_t>(sample);
    if (sample <= m_shown || index >= m_moved.size() || m_moved[index] < 0) return;
    m_shown = sample;
    emit seen(1e-6 * static_cast<double>(m_clock.nsecsElapsed() - m_moved[index]));
}

}  // namespace wend
