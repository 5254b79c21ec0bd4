#pragma once

#include "app/tools/tool.h"
#include "app/tools/tool_surface.h"

namespace wend {

/// Selects and drags pins; with `adds`, a click on the free shape makes a new one.
class PinTool : public Tool {
  public:
    PinTool(ToolSurface& surface, bool adds) : m_surface(surface), m_adds(adds) {}

    QString hint() const override;
    QCursor cursor() const override;
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    void cancel() override;

    /// The handle within reach of a point of the widget, or −1.
    int handleAt(const QPointF& widget) const;

  private:
    ToolSurface& surface() const { return m_surface; }
    ShapeSession& session() const { return m_surface.session(); }
    enum class Gesture { None, Pressed, Drag, Marquee };

    void pressHandle(int handle, bool extend);
    void begin(const QMouseEvent& event);
    void selectInside(const QRectF& rectangle, bool extend);
    void hover(const QPointF& at);
    bool nudge(const QKeyEvent& event);

    ToolSurface& m_surface;
    bool m_adds;
    Gesture m_gesture = Gesture::None;
    QPointF m_from;
    int m_pressed = -1;
    int m_hovered = -1;
};

}  // namespace wend
