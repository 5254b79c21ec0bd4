#pragma once

#include <QColor>
#include <QPainterPath>

#include "app/session/brush.h"
#include "app/tools/key_cross.h"
#include "app/tools/shape_tool.h"

namespace wend {

/// A brush over a picture or a solid, which adds balls around the rest places under the pointer. `[` and `]`
/// change its size, with Shift its hardness; an Alt-drag with the right button changes both. Esc cancels the
/// stroke. Pen pressure is used. Arrow keys move it, Enter touches the shape.
class StrokeTool : public ShapeTool<> {
  public:
    StrokeTool(ShapeView& view, Brush& tip) : ShapeTool<>(view), m_brush(tip) {}

    QString hint() const final;
    QCursor cursor() const override { return Qt::CrossCursor; }
    bool takesButton(const QMouseEvent& event) const override;
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    void cancel() override;
    void leave() override {
        m_over = false;
        m_cross.hide();
    }
    void paint(QPainter& painter) const override;

  protected:
    struct Dab {
        Place place;
        Vec3 rest;
        double radius;  // of the whole brush, in the domain's units
        Vec3 axis;      // see axisAt()
        double pressure;
    };
    /// Half of the soft edge is within this ball, half beyond it.
    Ball<3> ballOf(const Dab& dab) const;
    double featherOf(const Dab& dab) const;
    /// Returns the name of the picture's part on which the stroke began.
    std::string partOf(const Dab& dab) const;

    /// Returns the hint while the brush is not being adjusted.
    virtual QString strokeHint() const = 0;
    /// Returns whether a stroke erases with the current modifiers.
    virtual bool takesAway() const { return m_modifiers & Qt::ControlModifier; }
    /// Returns whether Shift-click draws a straight line from the end of the last stroke.
    virtual bool drawsLines() const { return false; }
    /// Called when a stroke begins.
    virtual void begin() {}
    /// Returns the rest direction that a ball stores; zero for none.
    virtual Vec3 axisAt(const ShapeFrame&, const Touch&) const { return Vec3::Zero(); }
    /// Called when a stroke has become longer.
    virtual void follow(const std::vector<Dab>&) {}
    /// Called when a stroke is complete; it has at least one ball.
    virtual void take(const std::vector<Dab>& dabs) = 0;
    virtual QColor colour() const = 0;
    /// Draws the stroke so far.
    virtual void paintStroke(QPainter& painter, const std::vector<Dab>& dabs) const;

    Brush& brush() const { return m_brush; }
    /// Returns the modifiers at the start of the stroke, or the current ones between strokes. Those of a
    /// straight line exclude Shift.
    Qt::KeyboardModifiers modifiers() const { return m_modifiers; }

  private:
    /// A drag that adjusts the brush: its former settings and the pressed place.
    struct Tuning {
        double radius, hardness;
        QPointF from;
    };
    void tune(const QPointF& at);
    void setTip(double radius, double hardness);
    void paintTuning(QPainter& painter) const;
    void start(const QPointF& at);
    bool dab(const QPointF& at, double pressure);
    void dabsTo(const QPointF& at);
    std::optional<QPointF> lineStart() const;
    void drawLine();
    void paintLine(QPainter& painter) const;
    std::optional<Mat3> facing(const QPointF& at) const;
    QPainterPath ringAt(const QPointF& at, double radius) const;

    Brush& m_brush;
    KeyCross m_cross;
    std::optional<Tuning> m_tuning;
    bool m_active = false;
    bool m_over = false;         // the pointer is over the view
    QPointF m_at;                // of the pointer
    QPointF m_last;              // the last place of the stroke …
    double m_lastPressure = 1;   // … and how hard it was pressed there
    bool m_waits = false;        // pressed with Shift: a line if it is a click, a stroke if it is drawn
    std::optional<Place> m_end;  // of the last stroke, on …
    std::shared_ptr<const void> m_endShape;
    Qt::KeyboardModifiers m_modifiers;
    std::shared_ptr<const void> m_mesh;  // that the stroke began on: its balls are places of this one
    std::vector<Dab> m_dabs;
};

}  // namespace wend
