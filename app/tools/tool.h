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

class CurveEditor;

/// The subject of a context menu.
enum class MenuPlace { None, Canvas, Handle, Curve };

/// Opens the menu of a handle and adds it to the selection; that of the canvas without one.
inline MenuPlace menuOfPin(Selection& selection, int handle) {
    if (handle < 0) return MenuPlace::Canvas;
    if (!selection.contains(handle)) selection.set({handle});
    return MenuPlace::Handle;
}

/// Shift adds to the selection, Ctrl removes from it.
inline Selection::Pick pickBy(Qt::KeyboardModifiers modifiers) {
    if (modifiers & Qt::ControlModifier) return Selection::Pick::Remove;
    return modifiers & Qt::ShiftModifier ? Selection::Pick::Add : Selection::Pick::Only;
}

/// Returns the radius of a brush in pixels after [ or ]; nothing for other keys.
inline std::optional<double> brushAfter(const QKeyEvent& key, double radius, double largest) {
    if (key.text() != QStringLiteral("[") && key.text() != QStringLiteral("]")) return {};
    return std::clamp(radius * (key.text() == QStringLiteral("[") ? 0.8 : 1.25), 4.0, largest);
}

/// Edits the shape with pointer and keys. Views forward all events that they do not need for navigation.
class Tool {
  public:
    virtual ~Tool() = default;

    /// Returns one line for the status bar that describes the pointer's current effect.
    virtual QString hint() const = 0;
    virtual QCursor cursor() const { return Qt::ArrowCursor; }
    /// Returns whether a press here belongs to the tool even if the left button rotates the view.
    virtual bool wants(const QPointF&) const { return false; }
    /// Returns the handle under the pointer, or −1.
    virtual int hovered() const { return -1; }
    virtual void press(const QMouseEvent& event) = 0;
    /// Returns whether the tool uses a press of a button other than the left one, whatever that does
    /// elsewhere.
    virtual bool takesButton(const QMouseEvent&) const { return false; }
    virtual void move(const QMouseEvent& event) = 0;
    virtual void release(const QMouseEvent& event) = 0;
    /// Called instead of the second press.
    virtual void doubleClick(const QMouseEvent& event) { press(event); }
    /// Returns whether the key was used.
    virtual bool key(const QKeyEvent& event) = 0;
    /// Gives up the gesture, as if it had not begun.
    virtual void cancel() = 0;
    /// Returns whether the tool uses the key now, although it is a shortcut.
    virtual bool ownsKey(const QKeyEvent&) const { return false; }
    /// Returns the kind of menu for this place, which the tool remembers.
    virtual MenuPlace menuAt(const QPointF&) { return MenuPlace::Canvas; }
    /// Returns the curve that it edits; null if it edits none.
    virtual CurveEditor* curve() { return nullptr; }
    /// Returns whether a drag with the left button pans the view, as with the space bar.
    virtual bool pans() const { return false; }
    /// Returns whether the tool shows a manipulator around the selection.
    virtual bool hasManipulator() const { return false; }
    /// Returns whether the tool needs the whole picture, including the parts outside the outline.
    virtual bool showsPicture() const { return false; }
    /// Called when the tool becomes active or inactive.
    virtual void choose() {}
    virtual void dismiss() {}
    /// Called when the pointer leaves the view.
    virtual void leave() {}
    /// Re-evaluates the hover state; the scene changed under a still pointer.
    virtual void lookAgain() {}
    /// Draws over the view.
    virtual void paint(QPainter&) const {}
};

}  // namespace wend
