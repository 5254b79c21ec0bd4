#pragma once

#include <functional>

#include "app/tools/drawn_outline.h"
#include "app/tools/pins/held_part.h"
#include "app/tools/tool_kind.h"

namespace wend {

/// Makes one handle of what is drawn over by rectangle, lasso or brush. Shift adds to the selected handle,
/// Ctrl subtracts from it; on a solid a click does so with one vertex.
class GrabTool : public ShapeTool<> {
  public:
    /// `done`: a part was taken hold of, and is there to be moved.
    GrabTool(ShapeView& view, DrawnOutline::Kind outline, PinChoice& choice, std::function<void()> done)
        : ShapeTool<>(view), m_outline(outline), m_choice(choice), m_done(std::move(done)) {
        const auto take = [this] { m_outline.setRadius(m_choice.now().radius); };
        QObject::connect(&choice, &PinChoice::changed, &m_listener, take);
        take();
    }

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    void cancel() override;
    void leave() override { m_over = false; }
    void paint(QPainter& painter) const override;

  protected:
    /// Takes hold of what is drawn over; returns true if that is a new handle.
    virtual bool take(Qt::KeyboardModifiers with) = 0;
    /// Changes the selected handle by a click with Shift or Ctrl.
    virtual void takeClicked(Qt::KeyboardModifiers) {}
    /// Update, paint and drop what would be held.
    virtual void follow() {}
    virtual void paintCaught(QPainter&) const {}
    virtual void drop() {}
    bool takesHidden() const { return m_choice.now().through; }
    const DrawnOutline& outline() const { return m_outline; }
    const QPointF& pointer() const { return m_at; }

  private:
    void finish(Qt::KeyboardModifiers with);

    DrawnOutline m_outline;
    PinChoice& m_choice;
    QObject m_listener;  // to the choice
    std::function<void()> m_done;
    bool m_active = false, m_over = false;  // over: the pointer is over the view
    QPointF m_at;
};

ToolKind grabByLassoTool();
ToolKind grabByBoxTool();
ToolKind grabByBrushTool();

}  // namespace wend
