#pragma once

#include "app/tools/shape_tool.h"

namespace wend {

class Brush;

/// A click on the shape with what the brush paints: fills the part that hangs together there, with Shift the
/// whole shape; or picks up what is there.
template <int Dim>
class FillTool : public ShapeTool<Dim> {
  public:
    enum class Deed { Fill, Pick };
    FillTool(SurfaceOf<Dim>& view, Brush& brush, Deed deed)
        : ShapeTool<Dim>(view), m_brush(brush), m_deed(deed) {}

    QString hint() const override;
    QCursor cursor() const override { return Qt::PointingHandCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent&) override {}
    bool key(const QKeyEvent&) override { return false; }
    void cancel() override {}
    void leave() override { m_over = false; }
    void paint(QPainter& painter) const override;

  private:
    using ShapeTool<Dim>::surface;
    using ShapeTool<Dim>::session;
    void fill(int cell, Qt::KeyboardModifiers modifiers);

    Brush& m_brush;
    Deed m_deed;
    bool m_over = false;
    QPointF m_at;
};

extern template class FillTool<2>;
extern template class FillTool<3>;

}  // namespace wend
