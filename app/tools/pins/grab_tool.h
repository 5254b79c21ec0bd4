#pragma once

#include <functional>

#include "app/tools/drawn_outline.h"
#include "app/tools/pins/held_part.h"
#include "app/tools/tool_kind.h"

namespace wend {

/// Makes one handle of what is drawn over by rectangle, lasso or brush. Shift adds to the selected handle,
/// Ctrl subtracts from it; on a solid a click does so with one vertex.
template <int Dim>
class GrabTool : public ShapeTool<Dim> {
  public:
    /// `done`: a part was taken hold of, and is there to be moved.
    GrabTool(SurfaceOf<Dim>& view, DrawnOutline::Kind outline, PinChoice& choice, std::function<void()> done)
        : ShapeTool<Dim>(view), m_outline(outline), m_choice(choice), m_done(std::move(done)) {
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

  private:
    using ShapeTool<Dim>::surface;
    using ShapeTool<Dim>::session;
    bool takesHidden() const { return m_choice.now().through; }
    void take(Qt::KeyboardModifiers with);
    void follow();

    DrawnOutline m_outline;
    PinChoice& m_choice;
    QObject m_listener;  // to the choice
    std::function<void()> m_done;
    bool m_active = false, m_over = false;  // over: the pointer is over the view
    QPointF m_at;
    std::vector<int> m_caught;  // so far, of a solid
};

extern template class GrabTool<2>;
extern template class GrabTool<3>;

ToolKind grabByLassoTool();
ToolKind grabByBoxTool();
ToolKind grabByBrushTool();

}  // namespace wend
