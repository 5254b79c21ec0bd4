#pragma once

#include <QTimer>
#include <functional>

namespace wend {

class ShapeSession;

/// Calls `show` when pins or frames of a session change: at once, but during a drag at most ten times a
/// second. Numbers and switches beside the view need no more, and would take as long as the drawing of the
/// shape.
class CalmFollower : public QObject {
  public:
    enum class Of { Pins, Frames, Both };
    CalmFollower(ShapeSession& session, Of what, QObject* parent, std::function<void()> show);

  private:
    void take();
    void takeLate();

    ShapeSession& m_session;
    std::function<void()> m_show;
    QTimer m_pause;
    bool m_isLate = false;  // there was a change in the pause
};

}  // namespace wend
