#include "app/session/calm_follower.h"

#include <utility>

#include "app/session/shape_session.h"

namespace wend {

namespace {

constexpr int kPause = 100;  // milliseconds

}  // namespace

CalmFollower::CalmFollower(ShapeSession& session, Of what, QObject* parent, std::function<void()> show)
    : QObject(parent), m_session(session), m_show(std::move(show)) {
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPause);
    connect(&m_pause, &QTimer::timeout, this, &CalmFollower::takeLate);
    if (what != Of::Frames) connect(&session, &ShapeSession::pinsChanged, this, &CalmFollower::take);
    if (what != Of::Pins) connect(&session, &ShapeSession::frameChanged, this, &CalmFollower::take);
}

void CalmFollower::take() {
    m_isLate = m_session.isDragging() && m_pause.isActive();
    if (m_isLate) return;
    m_pause.stop();
    if (m_session.isDragging()) m_pause.start();
    m_show();
}

void CalmFollower::takeLate() {
    if (std::exchange(m_isLate, false)) take();
}

}  // namespace wend
