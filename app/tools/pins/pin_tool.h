#pragma once

#include <QKeyEvent>
#include <QString>

#include "app/tools/gizmos.h"
#include "app/tools/in_steps.h"
#include "app/tools/key_cross.h"
#include "app/tools/pins/curve_editor.h"
#include "app/tools/pins/pin_picking.h"
#include "app/tools/tool_kind.h"

namespace wend {

/// A number typed during a drag, which replaces the pointer's amount.
class TypedNumber {
  public:
    /// Returns whether the key belongs to a number.
    bool take(const QKeyEvent& key);
    bool isEmpty() const { return m_text.isEmpty(); }
    double value() const { return m_text.toDouble(); }
    void clear() { m_text.clear(); }

  private:
    QString m_text;
};

/// Selects, drags, rotates, scales and widens pins, with a ring in the plane and a manipulator in space. With
/// `adds`, a click on the bare shape adds a pin, and a drag from there moves it.
class PinTool : public ShapeTool<> {
  public:
    /// Shape of the marquee beside pins.
    using Outline = DrawnOutline::Kind;
    PinTool(ShapeView& view, PinChoice& choice, bool adds);

    QString hint() const override;
    QCursor cursor() const override;
    bool wants(const QPointF& at) const override;
    int hovered() const override { return m_hovered; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    void cancel() override;
    void doubleClick(const QMouseEvent& event) override;
    void leave() override {
        m_over = false;
        m_hovered = -1;
        if (m_gesture == Gesture::None) m_part.reset();
    }
    void lookAgain() override {
        if (m_over && m_gesture == Gesture::None) hover();
    }
    bool ownsKey(const QKeyEvent& event) const override;
    MenuPlace menuAt(const QPointF& at) override;
    CurveEditor* curve() override { return &m_curve; }
    void paint(QPainter& painter) const override;
    bool hasManipulator() const override { return placeGizmo(); }

    /// Returns the handle within reach of a point of the widget, or around it, or −1.
    int handleAt(const QPointF& widget) const;

  private:
    using Part = GizmoPart;
    enum class Gesture { None, Pressed, Drag, Widen, Marquee, Curve, OnCurve };

    bool takesHidden() const { return m_choice.now().through; }
    int pinAt(const QPointF& widget) const { return markUnder(view(), widget, takesHidden()); }
    int curvePointAt(const QPointF& at) const;
    std::optional<Part> partAt(const QPointF& at) const;
    std::optional<Part> litPart() const;
    bool isSelected(int handle) const;
    bool placeGizmo() const;
    void takePointer(const QMouseEvent& event);
    void takeChoice();
    void hover();
    void select(int handle, bool extend);
    void begin();
    bool setPin();
    bool widens() const;
    bool canUse(const Part& part);
    void beginDrag(const Part& part);
    /// Returns the pointer's place; with `steps` constrained to eight directions from the pressed place.
    QPointF reached(bool steps) const { return steps ? m_from + inSteps(m_at - m_from) : m_at; }
    void drag(bool snaps = false);
    void lock(int axis);
    void finishDrag();
    void clickAt(const QPointF& at, bool extend);
    int addPin(const QPointF& at);
    double widenedTo(const QPointF& at) const;
    bool isTaken(const PinView& pin) const;
    void selectInside(Qt::KeyboardModifiers modifiers);
    bool nudge(const QKeyEvent& event);
    bool keyInDrag(const QKeyEvent& event);
    QString besideHint() const;
    QString gripHint() const;
    static QString pointHint(Grip::Kind kind);
    void paintWidened(QPainter& painter) const;

    std::unique_ptr<Gizmo> m_gizmo;  // where the selection was last seen
    CurveEditor m_curve;
    KeyCross m_cross;
    DrawnOutline m_outline;
    PinChoice& m_choice;
    bool m_adds;
    Gesture m_gesture = Gesture::None;
    QPointF m_from, m_at;
    bool m_over = false;           // the pointer is over the view
    Qt::KeyboardModifiers m_with;  // was held when it was pressed
    double m_seconds = 0;          // of the pointer's last event
    int m_pressed = -1, m_hovered = -1;
    std::optional<Part> m_part;  // pressed, or under the pointer
    bool m_leaves = false;       // deselects on a click without a drag
    bool m_sets = false;         // the drag's step began with a new pin, or a point that became wide
    Amount m_amount = Amount::Zero();
    TypedNumber m_typed;
    QObject m_listener;  // to the choice
};

ToolKind pinTool();
ToolKind selectTool();

}  // namespace wend
