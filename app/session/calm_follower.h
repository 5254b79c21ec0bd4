#pragma once

#include <QTimer>
#include <functional>

#include "app/base/connect_each.h"

namespace wend {

class ShapeMotion;

/// Calls `show` when one of the given signals is emitted: at once, but during a drag at most ten times a
/// second. Numbers and switches beside the view need no more, and would take as long as the drawing of the
/// shape.
class CalmFollower : public QObject {
  public:
    template <class... SendersAndSignals>
    CalmFollower(const ShapeMotion& motion, QObject* parent, std::function<void()> show,
                 SendersAndSignals... of)
        : CalmFollower(motion, parent, std::move(show)) {
        connectEach(this, &CalmFollower::take, of...);
    }

  private:
    CalmFollower(const ShapeMotion& motion, QObject* parent, std::function<void()> show);
    void take();
    void takeLate();

    const ShapeMotion& m_motion;
    std::function<void()> m_show;
    QTimer m_pause;
    bool m_isLate = false;  // there was a change in the pause
};

}  // namespace wend
