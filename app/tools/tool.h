#pragma once

#include <QCursor>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QString>

namespace wend {

/// One way to work on the shape with pointer and keys. The view passes on what it does not need for
/// navigation.
class Tool {
  public:
    virtual ~Tool() = default;

    /// One line for the status bar: what the pointer does now.
    virtual QString hint() const = 0;
    virtual QCursor cursor() const { return Qt::ArrowCursor; }
    virtual void press(const QMouseEvent& event) = 0;
    virtual void move(const QMouseEvent& event) = 0;
    virtual void release(const QMouseEvent& event) = 0;
    /// True if the key was used.
    virtual bool key(const QKeyEvent& event) = 0;
    /// Gives up the gesture, as if it had not begun.
    virtual void cancel() = 0;
};

}  // namespace wend
