#pragma once

#include "app/tools/solid_surface.h"

namespace wend {

/// Takes hold of many vertices at once, as one handle: by rectangle, lasso or brush over what is seen, or by
/// a ball or box around a point of the surface. Shift adds to the selected handle, Ctrl takes away from it.
class AreaTool : public SolidTool {
  public:
    enum class Shape { Rectangle, Lasso, Brush, Ball, Box };
    AreaTool(SolidSurface& surface, Shape shape) : SolidTool(surface), m_shape(shape) {}

    /// Takes vertices that something hides, too.
    void setThrough(bool through) { m_through = through; }

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    void cancel() override;
    void paint(QPainter& painter) const override;

  private:
    bool isSolidShape() const { return m_shape == Shape::Ball || m_shape == Shape::Box; }
    std::function<bool(const QPointF&)> insideTest() const;
    std::vector<int> verticesInside() const;
    void brush();
    void finish(Qt::KeyboardModifiers modifiers);
    Region<3> region() const;
    void changeSelected(std::vector<int> vertices, bool add);

    Shape m_shape;
    bool m_through = false, m_active = false;
    QPolygonF m_line;
    QPointF m_at;
    Vec<3> m_centre = Vec<3>::Zero();  // of a ball or box, in the pose
    int m_vertex = -1;                 // where its centre is in the rest shape
    double m_radius = 18;              // of the brush, in pixels
    std::vector<int> m_brushed;
};

}  // namespace wend
