#include "app/engine/motion/playback.h"

#include <algorithm>

namespace wend {

Playback::Playback(QObject* parent) : QObject(parent) {
    m_timer.setInterval(16);
    connect(&m_timer, &QTimer::timeout, this, &Playback::tick);
}

void Playback::setEnd(double end) {
    if (end == m_end) return;
    const bool follow = isAtEnd();
    m_end = end;
    emit endChanged(end);
    if (follow || m_time > end) setTime(end);
}

void Playback::setTime(double time) {
    time = std::clamp(time, 0.0, m_end);
    if (time == m_time) return;
    m_time = time;
    emit timeChanged(time);
}

void Playback::setPlaying(bool playing) {
    if (playing == isPlaying() || (playing && m_end <= 0)) return;
    if (playing && isAtEnd()) setTime(0);
    m_clock.start();
    if (playing)
        m_timer.start();
    else
        m_timer.stop();
    emit playingChanged(playing);
}

void Playback::setLoops(bool loops) {
    if (m_loops == loops) return;
    m_loops = loops;
    emit loopsChanged(loops);
}

void Playback::setSpeed(double speed) {
    m_speed = speed;
}

void Playback::tick() {
    const double passed = m_speed * static_cast<double>(m_clock.restart()) * 1e-3 / kSecondsPerUnit;
    if (m_time < lastTime()) {
        setTime(std::min({m_time + passed, std::max(m_ready, m_time), lastTime()}));
        return;
    }
    if (m_loops)
        setTime(hasCycle() ? m_cycleFrom : 0);
    else
        setPlaying(false);
}

}  // namespace wend
