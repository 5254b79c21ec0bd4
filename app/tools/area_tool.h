#pragma once

#include "app/tools/shape_tool.h"

namespace wend {

/// Takes hold of many vertices at once, as one handle: by rectangle, lasso or brush over what is seen, or by
/// a ball or box around a point of the surface, or the half of space beyond it. Shift adds to the selected
/// handle, Ctrl takes away from it; with them a click does so with one vertex.
class AreaTool : public ShapeTool<3> {
  public:
    enum class Shape { Rectangle, Lasso, Brush, Ball, Box, Half };
    AreaTool(SolidSurface& surface, Shape shape) : ShapeTool<3>(surface), m_shape(shape) {}

    /// Takes vertices that something hides, too.
    void setThrough(bool through) { m_through = through; }

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
    bool isSolidShape() const {
        return m_shape == Shape::Ball || m_shape == Shape::Box || m_shape == Shape::Half;
    }
    bool isClick() const;
    std::function<bool(const QPointF&)> insideTest() const;
    std::vector<int> verticesInside() const;
    void brush();
    void finish(Qt::KeyboardModifiers modifiers);
    Region<3> region() const;
    void finishRegion(bool changes);
    void paintRegion(QPainter& painter) const;
    void paintCaught(QPainter& painter, const std::vector<int>& vertices) const;
    void countCaught();
    void tellNothingToTakeFrom() const;
    void changeSelected(std::vector<int> vertices, bool add);

    Shape m_shape;
    bool m_through = false, m_active = false, m_adds = false;
    QPolygonF m_line;
    QPointF m_at;
    bool m_over = false;  // the pointer is over the view
    // where a region begins, in the pose and in the rest shape, and how the solid is turned there
    Vec<3> m_centre = Vec<3>::Zero(), m_restCentre = Vec<3>::Zero();
    Mat<3> m_turn = Mat<3>::Identity();
    double m_radius = 18;                  // of the brush, in pixels
    std::vector<int> m_brushed, m_caught;  // m_caught: so far, by rectangle or lasso
};

}  // namespace wend
