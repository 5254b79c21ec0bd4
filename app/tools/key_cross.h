#pragma once

#include <QKeyEvent>
#include <QPainter>
#include <functional>
#include <optional>

#include "app/tools/shape_surface.h"
#include "app/tools/tool.h"

namespace wend {

/// Where an arrow key points, a pixel long, with Shift ten; nothing for another key.
std::optional<QPointF> arrowOf(const QKeyEvent& key);

/// A cross that arrow keys move over the view, from the middle of the shape, for what a click does elsewhere.
class KeyCross {
  public:
    /// An arrow moves it, with Enter `click` is done where it is; true if the key was used.
    template <int Dim>
    bool take(const QKeyEvent& key, ShapeSurface<Dim>& surface,
              const std::function<void(const QPointF&)>& click);
    /// What Enter does with a tool's button.
    enum class Enter { Clicks, Presses, LetsGo };
    /// An arrow moves a tool's pointer with it; Enter clicks there, with what is held, or does half of that.
    template <int Dim>
    bool clicks(const QKeyEvent& key, ShapeSurface<Dim>& surface, Tool& tool, Enter enter = Enter::Clicks);
    /// What the tool gets comes from here.
    bool isAtWork() const { return m_clicks; }
    /// The mouse has taken over.
    void hide() {
        if (!m_clicks) m_at.reset();
    }
    void paint(QPainter& painter) const;

  private:
    bool m_clicks = false;
    std::optional<QPointF> m_at;
};

}  // namespace wend
