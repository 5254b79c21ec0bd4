#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <QWidget>
#include <functional>
#include <vector>

#include "app/session/motion/frame.h"

namespace wend {

class ShapeSession;

/// How long what is seen in a drag comes after the hand: from a move of the pointer to the end of the
/// painting that shows the shape there.
class SeenDelay : public QObject {
    Q_OBJECT

  public:
    explicit SeenDelay(ShapeSession& session);

    /// In this view; `drawn` tells which frame its next painting shows.
    void watch(QWidget& view, std::function<FramePtr()> drawn);

  signals:
    void seen(double milliseconds);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    struct View {
        QPointer<QWidget> widget;
        std::function<FramePtr()> drawn;
    };
    void begin();
    void noteMove();
    void take(int sample);

    ShapeSession& m_session;
    std::vector<View> m_views;
    QElapsedTimer m_clock;
    std::vector<qint64> m_moved;  // nanoseconds, by the sample's number; −1 where none was noted
    int m_shown = 0;              // the newest sample that was seen
    int m_past = -1;              // the drag before, whose last shape may still be seen
};

}  // namespace wend
