#pragma once

#include "app/tools/curve_editor.h"
#include "app/tools/manipulator.h"

namespace wend {

/// Selects pins of a solid and moves, turns and scales them with a manipulator; with `adds`, a click on the
/// solid makes a new one.
class SolidPinTool : public SolidTool {
  public:
    SolidPinTool(SolidSurface& surface, Manipulator& manipulator, bool adds)
        : SolidTool(surface), m_manipulator(manipulator), m_curve(surface), m_adds(adds) {}

    QString hint() const override;
    QCursor cursor() const override;
    bool wants(const QPointF& at) const override;
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    void cancel() override;
    void paint(QPainter& painter) const override;

    /// The handle within reach of a point of the widget, or −1.
    int handleAt(const QPointF& widget) const;
    int hovered() const { return m_hovered; }

  private:
    enum class Gesture { None, Pressed, Drag, Marquee, Curve };

    bool placeManipulator() const;
    void begin(const QPointF& at);
    void drag(const QPointF& at);
    void lock(int axis);
    bool typeKey(const QKeyEvent& event);
    bool nudge(const QKeyEvent& event);
    void finish();
    void addPinAt(const QPointF& at, bool extend);
    void selectInside(const QRectF& rectangle, bool extend);
    QString numbers() const;

    Manipulator& m_manipulator;
    CurveEditor m_curve;
    bool m_adds;
    Gesture m_gesture = Gesture::None;
    QPointF m_from, m_at;
    int m_pressed = -1, m_hovered = -1;
    std::optional<Manipulator::Part> m_part;  // pressed, or under the pointer
    Amount m_amount = Amount::Zero();
    QString m_typed;
};

}  // namespace wend
