#pragma once

#include <QKeyEvent>
#include <QPainter>
#include <functional>
#include <optional>

#include "app/tools/shape_surface.h"

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
    void hide() { m_at.reset(); }
    void paint(QPainter& painter) const;

  private:
    std::optional<QPointF> m_at;
};

}  // namespace wend
