#pragma once

#include "app/tools/curve_editor.h"
#include "app/tools/drawn_outline.h"
#include "app/tools/key_cross.h"
#include "app/tools/manipulator.h"
#include "app/tools/typed_number.h"

namespace wend {

/// Selects pins of a solid and moves, turns and scales them with a manipulator; with `adds`, a click on the
/// solid makes a new one.
class SolidPinTool : public SolidTool {
  public:
    /// What is drawn beside pins to select all in it.
    using Outline = DrawnOutline::Kind;
    SolidPinTool(SolidSurface& surface, Manipulator& manipulator, bool adds);

    /// What the manipulator does.
    void setGrip(Grip::Kind kind);
    void setOutline(Outline outline) { m_outline.setKind(outline); }
    /// Selects also what something hides.
    void setThrough(bool through) { m_through = through; }
    /// New pins sit on corners of the mesh, instead of where one clicks.
    void setSnaps(bool snaps) { m_snaps = snaps; }

    QString hint() const override;
    QCursor cursor() const override;
    bool wants(const QPointF& at) const override;
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    void cancel() override;
    void paint(QPainter& painter) const override;
    void doubleClick(const QMouseEvent& event) override;
    void leave() override;
    bool ownsKey(const QKeyEvent& event) const override;
    MenuPlace menuAt(const QPointF& at) override;
    CurveEditing* curve() override { return &m_curve; }

    /// The handle within reach of a point of the widget, or −1.
    int handleAt(const QPointF& widget) const;
    int hovered() const { return m_hovered; }

  private:
    enum class Gesture { None, Pressed, Drag, Marquee, Curve, OnCurve };

    QString outlineHint() const;
    bool placeManipulator() const;
    void begin(const QPointF& at);
    void drag(const QPointF& at);
    void lock(int axis);
    bool nudge(const QKeyEvent& event);
    void finish();
    void clickAt(const QPointF& at, bool extend);
    void select(int handle, bool extend);
    bool isTaken(const PinView<3>& pin) const;
    void selectInside(Qt::KeyboardModifiers modifiers);
    QString numbers() const;

    Manipulator& m_manipulator;
    CurveEditor<3> m_curve;
    KeyCross m_cross;
    bool m_adds;
    bool m_through = false;
    bool m_snaps = true;
    bool m_over = false;  // the pointer is over the view
    DrawnOutline m_outline;
    Gesture m_gesture = Gesture::None;
    QPointF m_from, m_at;
    bool m_records = false;  // Ctrl was held when it was pressed
    double m_seconds = 0;    // of the pointer's last event
    int m_pressed = -1, m_hovered = -1;
    std::optional<Manipulator::Part> m_part;  // pressed, or under the pointer
    Amount m_amount = Amount::Zero();
    TypedNumber m_typed;
};

}  // namespace wend
