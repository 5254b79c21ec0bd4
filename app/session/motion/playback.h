#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

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
    /// Playback speed relative to real time.
    double speed() const { return m_speed; }
    bool isAtEnd() const { return m_time >= m_end; }

    /// Sets the end. The time follows if it was at the old end or is beyond the new one.
    void setEnd(double end);
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

    QTimer m_timer;
    QElapsedTimer m_clock;
    double m_time = 0, m_end = 0, m_ready = 0;
    double m_speed = 1;
    bool m_loops = false;
};

}  // namespace wend
