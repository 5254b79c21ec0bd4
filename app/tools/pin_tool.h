#pragma once

#include "app/tools/curve_editor.h"
#include "app/tools/key_cross.h"
#include "app/tools/pin_ring.h"
#include "app/tools/tool.h"
#include "app/tools/tool_surface.h"
#include "app/tools/typed_number.h"

namespace wend {

/// Selects pins of a picture, drags, rotates, scales and widens them; with `adds`, a click on the free shape
/// makes a new one.
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
    MenuPlace menuAt(const QPointF& at) override;
    CurveEditing* curve() override { return &m_curve; }
    void paint(QPainter& painter) const override;

    /// The handle within reach of a point of the widget, or around it, or −1.
    int handleAt(const QPointF& widget) const;
    /// What a drag does with what is selected: turning and scaling begin anywhere, pins are moved by
    /// themselves.
    void setGrip(Grip::Kind kind);
    /// New pins sit on corners of the mesh, instead of where one clicks.
    void setSnaps(bool snaps) { m_snaps = snaps; }

  private:
    ToolSurface& surface() const { return m_surface; }
    ShapeSession& session() const { return m_surface.session(); }
    enum class Gesture { None, Pressed, Drag, Ring, Widen, Marquee, Curve, OnCurve };

    void pressHandle(int handle, bool extend);
    int pinAt(const QPointF& widget) const;
    int regionAt(const QPointF& widget) const;
    std::optional<Location<2>> placeAt(const QPointF& widget) const;
    bool placeRing() const;
    void paintWidened(QPainter& painter) const;
    void begin();
    void beginGrip();
    void beginRing();
    void refuse(Grip::Kind kind);
    QString gripHint() const;
    static QString refusal(Grip::Kind kind);
    std::optional<PinRing::Part> litPart() const;
    void follow(const QMouseEvent& event);
    void dragRing(bool snaps);
    void finishDrag();
    void clickAt(const QPointF& at, bool extend);
    double widenedTo(const QPointF& at) const;
    int curvePointAt(const QPointF& at) const;
    void selectInside(const QRectF& rectangle, Qt::KeyboardModifiers modifiers);
    void hover(const QPointF& at);
    bool nudge(const QKeyEvent& event);

    ToolSurface& m_surface;
    CurveEditor<2> m_curve;
    KeyCross m_cross;
    bool m_adds;
    bool m_snaps = false;
    Grip::Kind m_grip = Grip::Kind::Move;
    Gesture m_gesture = Gesture::None;
    QPointF m_from, m_at;
    int m_pressed = -1;
    int m_hovered = -1;
    bool m_widens = false;   // Alt was held when it was pressed
    bool m_records = false;  // Ctrl was
    double m_seconds = 0;    // of the pointer's last event
    mutable PinRing m_ring;  // where the selection was last seen
    mutable bool m_hasRing = false;
    std::optional<PinRing::Part> m_part;  // of the ring: pressed, or under the pointer
    Amount m_amount = Amount::Zero();
    TypedNumber m_typed;
};

}  // namespace wend
