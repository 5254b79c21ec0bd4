#pragma once

#include <QKeyEvent>
#include <QPainter>
#include <functional>
#include <optional>

#include "app/tools/shape_view.h"
#include "app/tools/tool.h"

namespace wend {

/// Returns the direction of an arrow key, one pixel long, with Shift ten; nothing for other keys.
std::optional<QPointF> arrowOf(const QKeyEvent& key);

/// A keyboard cursor: a cross that arrow keys move over the view, starting in the middle of the shape, and
/// that replaces mouse clicks.
class KeyCross {
  public:
    /// Moves the cross with the arrow keys, and calls `click` where it is with Enter. Returns true if the key
    /// was used.
    bool take(const QKeyEvent& key, ShapeView& view, const std::function<void(const QPointF&)>& click);
    /// How Enter acts on a tool's button.
    enum class Enter { Clicks, Presses, LetsGo };
    /// Moves a tool's pointer by arrows; Enter clicks there with the pressed modifiers, or presses or
    /// releases.
    bool clicks(const QKeyEvent& key, ShapeView& view, Tool& tool, Enter enter = Enter::Clicks);
    /// Returns whether the tool's current event comes from the keyboard.
    bool isAtWork() const { return m_clicks; }
    /// Hides the cross when the mouse is used again.
    void hide() {
        if (!m_clicks) m_at.reset();
    }
    void paint(QPainter& painter) const;

  private:
    bool m_clicks = false;
    std::optional<QPointF> m_at;
};

}  // namespace wend
