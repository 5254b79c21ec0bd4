#pragma once

#include <QCursor>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QString>
#include <algorithm>
#include <optional>

#include "app/session/selection.h"

namespace wend {

class CurveEditing;

/// What a menu is opened for.
enum class MenuPlace { None, Canvas, Pin, Curve };

/// The menu of a handle, which is then among those that are selected; that of the canvas where there is none.
inline MenuPlace menuOfPin(Selection& selection, int handle) {
    if (handle < 0) return MenuPlace::Canvas;
    if (!selection.contains(handle)) selection.set({handle});
    return MenuPlace::Pin;
}

/// With Shift what is picked joins the others, with Ctrl it leaves them.
inline Selection::Pick pickBy(Qt::KeyboardModifiers modifiers) {
    if (modifiers & Qt::ControlModifier) return Selection::Pick::Remove;
    return modifiers & Qt::ShiftModifier ? Selection::Pick::Add : Selection::Pick::Only;
}

/// A brush whose size [ and ] change: its radius after the key, in pixels; nothing for another key.
inline std::optional<double> brushAfter(const QKeyEvent& key, double radius, double largest) {
    if (key.text() != QStringLiteral("[") && key.text() != QStringLiteral("]")) return {};
    return std::clamp(radius * (key.text() == QStringLiteral("[") ? 0.8 : 1.25), 4.0, largest);
}

/// One way to work on the shape with pointer and keys. The view passes on what it does not need for
/// navigation.
class Tool {
  public:
    virtual ~Tool() = default;

    /// One line for the status bar: what the pointer does now.
    virtual QString hint() const = 0;
    virtual QCursor cursor() const { return Qt::ArrowCursor; }
    /// True if a press here is for the tool even where the left button turns the view.
    virtual bool wants(const QPointF&) const { return false; }
    /// The handle under the pointer, or −1.
    virtual int hovered() const { return -1; }
    virtual void press(const QMouseEvent& event) = 0;
    /// A press of another button than the left one that is the tool's, whatever it means elsewhere.
    virtual bool takesButton(const QMouseEvent&) const { return false; }
    virtual void move(const QMouseEvent& event) = 0;
    virtual void release(const QMouseEvent& event) = 0;
    /// In place of the second press.
    virtual void doubleClick(const QMouseEvent& event) { press(event); }
    /// True if the key was used.
    virtual bool key(const QKeyEvent& event) = 0;
    /// Gives up the gesture, as if it had not begun.
    virtual void cancel() = 0;
    /// A key that is the tool's now although a shortcut has it.
    virtual bool ownsKey(const QKeyEvent&) const { return false; }
    /// What the menu that is opened there is for; the tool remembers the place.
    virtual MenuPlace menuAt(const QPointF&) { return MenuPlace::Canvas; }
    /// The curve that it edits; null if it edits none.
    virtual CurveEditing* curve() { return nullptr; }
    /// A drag of the left button moves the view, as with the space bar.
    virtual bool pans() const { return false; }
    /// Whether it wants to see all of the picture, also what the shape leaves out.
    virtual bool showsPicture() const { return false; }
    /// It is chosen, and later another one is.
    virtual void choose() {}
    virtual void dismiss() {}
    /// The pointer is not over the view any more.
    virtual void leave() {}
    /// The pointer rests, and what lies under it may be another thing than it was.
    virtual void lookAgain() {}
    /// Draws what it needs over the view.
    virtual void paint(QPainter&) const {}
};

}  // namespace wend
