#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <algorithm>

namespace wend {

/// The time that is shown, in [0, end], and its run while playing. One unit of time lasts kSecondsPerUnit.
class Playback : public QObject {
    Q_OBJECT

  public:
    static constexpr double kSecondsPerUnit = 1;

    explicit Playback(QObject* parent = nullptr);

    double time() const { return m_time; }
    double end() const { return m_end; }
    bool isPlaying() const { return m_timer.isActive(); }
    bool loops() const { return m_loops; }
    /// Returns the playback speed relative to real time.
    double speed() const { return m_speed; }
    bool isAtEnd() const { return m_time >= m_end; }

    /// Sets the end. The time follows if it was at the old end or is beyond the new one.
    void setEnd(double end);
    /// Sets the part that repeats while it loops; without an extent, that is all of it.
    void setCycle(double from, double to) { m_cycleFrom = from, m_cycleTo = to; }
    /// Frames up to here exist: playing waits there.
    void setReady(double time) { m_ready = time; }

  public slots:
    void setTime(double time);
    void setPlaying(bool playing);
    void setLoops(bool loops);
    void setSpeed(double speed);

  signals:
    void timeChanged(double time);
    void endChanged(double end);
    void playingChanged(bool playing);
    void loopsChanged(bool loops);

  private:
    void tick();
    bool hasCycle() const { return m_loops && m_cycleFrom < std::min(m_cycleTo, m_end); }
    double lastTime() const { return hasCycle() ? std::min(m_cycleTo, m_end) : m_end; }

    QTimer m_timer;
    QElapsedTimer m_clock;
    double m_time = 0, m_end = 0, m_ready = 0;
    double m_cycleFrom = 0, m_cycleTo = 0;
    double m_speed = 1;
    bool m_loops = false;
};

}  // namespace wend
