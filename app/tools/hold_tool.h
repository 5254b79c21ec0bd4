#pragma once

#include <QPainterPath>
#include <functional>

#include "app/tools/tool.h"
#include "app/tools/tool_surface.h"

namespace wend {

/// Takes hold of a part of a picture as one handle: by rectangle, lasso or brush. Shift adds to the selected
/// part, Ctrl takes away from it.
class HoldTool : public Tool {
  public:
    enum class Shape { Rectangle, Lasso, Brush };
    /// `done`: a part was taken hold of, and is there to be moved.
    HoldTool(ToolSurface& surface, Shape shape, std::function<void()> done)
        : m_surface(surface), m_shape(shape), m_done(std::move(done)) {}

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    void cancel() override;
    void leave() override { m_over = false; }
    void paint(QPainter& painter) const override;

  private:
    ShapeSession& session() const { return m_surface.session(); }
    bool isClick() const;
    QPainterPath area() const;
    QPainterPath selectedArea() const;
    void hold(const QPainterPath& area);
    void change(const QPainterPath& area);
    Polygon atRest(const QPolygonF& outline) const;
    bool holdsSomething(const Polygon& polygon) const;

    ToolSurface& m_surface;
    Shape m_shape;
    std::function<void()> m_done;
    bool m_active = false, m_over = false;
    double m_radius = 22;  // of the brush, in pixels
    QPolygonF m_line;
    QPointF m_at;
};

}  // namespace wend
