#include "app/session/calm_follower.h"

#include <utility>

#include "app/session/shape_motion.h"

namespace wend {

namespace {

constexpr int kPause = 100;  // milliseconds

}  // namespace

CalmFollower::CalmFollower(const ShapeMotion& motion, QObject* parent, std::function<void()> show)
    : QObject(parent), m_motion(motion), m_show(std::move(show)) {
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPause);
    connect(&m_pause, &QTimer::timeout, this, &CalmFollower::takeLate);
}

void CalmFollower::take() {
    m_isLate = m_motion.isDragging() && m_pause.isActive();
    if (m_isLate) return;
    m_pause.stop();
    if (m_motion.isDragging()) m_pause.start();
    m_show();
}

void CalmFollower::takeLate() {
    if (std::exchange(m_isLate, false)) take();
}

}  // namespace wend
