#pragma once

#include "app/project/project_fwd.h"
#include "app/tools/key_cross.h"
#include "app/tools/tool_kind.h"

namespace wend {

class Brush;

enum class FillDeed { Fill, Pick };

/// Fills the connected area under a click with the paint of the brush, with Shift the whole shape; or picks
/// up the material.
template <int Dim>
class FillTool : public ShapeTool<Dim> {
  public:
    using Deed = FillDeed;
    FillTool(SurfaceOf<Dim>& view, Brush& brush, Deed deed)
        : ShapeTool<Dim>(view), m_brush(brush), m_deed(deed) {}

    QString hint() const override;
    QCursor cursor() const override { return Qt::PointingHandCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent&) override {}
    bool key(const QKeyEvent& event) override { return m_cross.clicks<Dim>(event, surface(), *this); }
    void cancel() override {}
    void leave() override {
        m_over = false;
        m_cross.hide();
    }
    void paint(QPainter& painter) const override;

  private:
    using ShapeTool<Dim>::surface;
    using ShapeTool<Dim>::session;
    void fill(int cell, Qt::KeyboardModifiers modifiers);
    void show(Design next, const QString& step);

    Brush& m_brush;
    Deed m_deed;
    KeyCross m_cross;
    bool m_over = false;
    QPointF m_at;
};

extern template class FillTool<2>;
extern template class FillTool<3>;

ToolKind fillTool();
ToolKind eyedropperTool();

}  // namespace wend
