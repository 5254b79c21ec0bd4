#pragma once

#include "app/engine/motion/edited_material.h"
#include "app/tools/key_cross.h"
#include "app/tools/tool_kind.h"

namespace wend {

class Brush;

enum class FillDeed { Fill, Pick };

/// Fills the connected area under a click with the paint of the brush, with Shift the whole shape; or picks
/// up the material.
class FillTool : public ShapeTool<> {
  public:
    using Deed = FillDeed;
    FillTool(ShapeView& view, Brush& brush, Deed deed) : ShapeTool<>(view), m_brush(brush), m_deed(deed) {}

    QString hint() const override;
    QCursor cursor() const override { return Qt::PointingHandCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent&) override {}
    bool key(const QKeyEvent& event) override { return m_cross.clicks(event, view(), *this); }
    void cancel() override {}
    void leave() override {
        m_over = false;
        m_cross.hide();
    }
    void paint(QPainter& painter) const override;

  private:
    void fill(int cell, Qt::KeyboardModifiers modifiers);
    void show(Design next, const QString& step);
    std::unique_ptr<EditedMaterial> material() const;

    Brush& m_brush;
    Deed m_deed;
    KeyCross m_cross;
    bool m_over = false;
    QPointF m_at;
};

ToolKind fillTool();
ToolKind eyedropperTool();

}  // namespace wend
