#pragma once

#include <QElapsedTimer>
#include <QEvent>
#include <QObject>
#include <QPointF>
#include <functional>
#include <stop_token>
#include <vector>

#include "app/engine/motion/frame.h"

class QWidget;

namespace wend {

class ShapeSession;

/// A hand that drags a pin in a view: moves of the mouse at an even rate, of which the newest counts when the
/// window was busy in between, as with a real mouse. It takes down when every frame was on the screen.
class WindowDrag : public QObject {
  public:
    struct Parts {
        QWidget& view;
        ShapeSession& session;
        std::function<FramePtr()> drawn;  // the frame that the view's next painting shows
    };
    /// The times of a drag in milliseconds.
    struct Times {
        double first = 0;             // from the press to the first frame that follows it
        std::vector<double> latency;  // of every frame: since the move that it shows
        std::vector<double> shown;    // when it was there, since the press
    };
    explicit WindowDrag(Parts parts);

    /// Presses at a place, moves along the path (an offset for a time in seconds) and releases. Throws
    /// std::runtime_error if nothing follows, Cancelled when stopped.
    Times drag(const QPointF& from, const std::function<QPointF(double)>& path, double seconds,
               std::stop_token stop);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void send(QEvent::Type type, const QPointF& at);
    void moveWhenDue(const std::function<QPointF(double)>& path);
    void takeShown(int sample);
    double now() const { return static_cast<double>(m_clock.nsecsElapsed()) * 1e-6; }

    Parts m_parts;
    QElapsedTimer m_clock;
    QPointF m_from, m_last;
    std::vector<double> m_sent;  // when each sample of the gesture was due; the first is the press
    int m_shown = 0;             // the newest sample that was displayed
    FramePtr m_before;
    Times m_times;
};

}  // namespace wend
