#pragma once

#include "app/tools/curve_editor.h"
#include "app/tools/tool.h"
#include "app/tools/tool_surface.h"

namespace wend {

/// Selects and drags pins; with `adds`, a click on the free shape makes a new one.
class PinTool : public Tool {
  public:
    PinTool(ToolSurface& surface, bool adds);

    QString hint() const override;
    QCursor cursor() const override;
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    void cancel() override;
    void doubleClick(const QMouseEvent& event) override;
    bool ownsKey(const QKeyEvent& event) const override;
    bool opensMenu(const QPointF& at) override { return m_curve.pointAtForMenu(at); }
    CurveEditing* curve() override { return &m_curve; }
    void paint(QPainter& painter) const override { m_curve.paint(painter, m_at); }

    /// The handle within reach of a point of the widget, or −1.
    int handleAt(const QPointF& widget) const;

  private:
    ToolSurface& surface() const { return m_surface; }
    ShapeSession& session() const { return m_surface.session(); }
    enum class Gesture { None, Pressed, Drag, Marquee, Curve, OnCurve };

    void pressHandle(int handle, bool extend);
    void begin(const QMouseEvent& event);
    int curvePointAt(const QPointF& at) const;
    void selectInside(const QRectF& rectangle, Qt::KeyboardModifiers modifiers);
    void hover(const QPointF& at);
    bool nudge(const QKeyEvent& event);

    ToolSurface& m_surface;
    CurveEditor<2> m_curve;
    bool m_adds;
    Gesture m_gesture = Gesture::None;
    QPointF m_from, m_at;
    int m_pressed = -1;
    int m_hovered = -1;
};

}  // namespace wend
