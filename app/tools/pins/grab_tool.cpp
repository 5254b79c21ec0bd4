#include <QCoreApplication>
#include <functional>
#include <iterator>

#include "app/session/shape_session.h"
#include "app/tools/drawn_outline.h"
#include "app/tools/pins/held_part.h"
#include "app/tools/tool_kinds.h"

namespace wend {

namespace {

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

constexpr std::size_t kMostLooked = 4000;

class PictureGrabTool : public GrabTool {
  public:
    template <class... Parts>
    explicit PictureGrabTool(PictureShapeView& view, Parts&&... parts)
        : GrabTool(view, std::forward<Parts>(parts)...), m_view(view) {}

  protected:
    bool take(Qt::KeyboardModifiers with) override {
        const QPainterPath part = drawnPart(m_view, outline());
        return !changePart(m_view, part, with) && holdPart(m_view, part);
    }

  private:
    PictureShapeView& m_view;
};

class SolidGrabTool : public GrabTool {
  public:
    template <class... Parts>
    explicit SolidGrabTool(SolidShapeView& view, Parts&&... parts)
        : GrabTool(view, std::forward<Parts>(parts)...), m_view(view) {}

  protected:
    bool take(Qt::KeyboardModifiers with) override {
        const std::vector<int> part = drawnPart(m_view, outline(), takesHidden());
        return !changePart(m_view, part, with) && holdPart(m_view, part);
    }
    void takeClicked(Qt::KeyboardModifiers with) override {
        const int vertex = m_view.pick(pointer()).vertex;
        if (vertex >= 0) changePart(m_view, {vertex}, with);
    }
    /// Finds nothing if testing visibility would delay the pointer.
    void follow() override {
        if (outline().kind() == DrawnOutline::Kind::Brush) {
            const auto isNew = [this](const QPointF& p) { return outline().isNewlyBrushed(p); };
            m_caught = joined(m_caught, m_view.verticesWhere(isNew, !takesHidden()));
        } else if (const auto all = drawnPart(m_view, outline(), true); all.size() <= kMostLooked) {
            m_caught = takesHidden() ? all : drawnPart(m_view, outline(), false);
        } else {
            m_caught.clear();
        }
    }
    void drop() override { m_caught.clear(); }
    void paintCaught(QPainter& painter) const override {
        if (!m_caught.empty()) wend::paintCaught(painter, m_view, m_caught, pointer());
    }

  private:
    SolidShapeView& m_view;
    std::vector<int> m_caught;  // so far
};

ToolMakers grabBy(DrawnOutline::Kind kind) {
    return {maker<PictureGrabTool>(&Workbench::picture, kind, &Workbench::pins, &Workbench::toSelect),
            maker<SolidGrabTool>(&Workbench::solid, kind, &Workbench::pins, &Workbench::toSelect)};
}

QString GrabTool::hint() const {
    if (m_outline.kind() == DrawnOutline::Kind::Lasso)
        return QCoreApplication::translate(
            "GrabTool", "Draw around the part to hold; Shift adds to the selected part, Ctrl takes away");
    if (m_outline.kind() == DrawnOutline::Kind::Brush)
        return QCoreApplication::translate(
            "GrabTool", "Brush over the part to hold, [ and ] change the size; Shift adds, Ctrl takes away");
    return QCoreApplication::translate(
        "GrabTool",
        "Draw a rectangle over the part to hold; Shift adds to the selected part, Ctrl takes away");
}

void GrabTool::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return;
    m_at = event.position();
    m_outline.begin(m_at);
    drop();
    m_active = m_over = true;
    follow();
    view().redraw();
}

void GrabTool::move(const QMouseEvent& event) {
    m_at = event.position();
    m_over = true;
    if (m_active) {
        m_outline.goOn(m_at);
        follow();
    }
    view().redraw();
}

void GrabTool::release(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || !std::exchange(m_active, false)) return;
    m_at = event.position();
    m_over = true;
    m_outline.goOn(m_at);
    if (frame()) finish(event.modifiers());
    drop();
    view().redraw();
}

void GrabTool::finish(Qt::KeyboardModifiers with) {
    if (!m_outline.isClick()) {
        if (take(with)) m_done();
    } else if (with & (Qt::ShiftModifier | Qt::ControlModifier)) {
        takeClicked(with);
    } else {
        session().selection().clear();
    }
}

bool GrabTool::key(const QKeyEvent& event) {
    const bool escapes = event.key() == Qt::Key_Escape;
    if (escapes && !m_active) session().selection().clear();
    if (escapes) cancel();
    const auto radius = m_outline.radiusAfter(event);
    if (radius) m_choice.change(&PinSettings::radius, *radius);
    if (!escapes && !radius) return false;
    view().redraw();
    return true;
}

void GrabTool::cancel() {
    m_active = false;
    drop();
}

void GrabTool::paint(QPainter& painter) const {
    if (m_active)
        m_outline.paint(painter);
    else if (m_over && m_outline.kind() == DrawnOutline::Kind::Brush)
        m_outline.paintBrush(painter, m_at);
    if (m_active) paintCaught(painter);
}

}  // namespace

ToolKind grabByLassoTool() {
    return toolKind("lasso", "area-lasso", QT_TRANSLATE_NOOP("Tools", "Grab by &Lasso"),
                    QT_TRANSLATE_NOOP("Tools", "Take hold of all that lies in a drawn outline as one handle"),
                    "L", Mode::Pins, grabBy(DrawnOutline::Kind::Lasso), {ToolOption::Through});
}

ToolKind grabByBoxTool() {
    return toolKind("rectangle", "area-rectangle", QT_TRANSLATE_NOOP("Tools", "Grab by Bo&x"),
                    QT_TRANSLATE_NOOP("Tools", "Take hold of all that lies in a rectangle as one handle"),
                    "Shift+B", Mode::Pins, grabBy(DrawnOutline::Kind::Rectangle), {ToolOption::Through});
}

ToolKind grabByBrushTool() {
    return toolKind("grabBrush", "area-brush", QT_TRANSLATE_NOOP("Tools", "Grab by &Brush"),
                    QT_TRANSLATE_NOOP("Tools", "Take hold of what is brushed over as one handle"), "U",
                    Mode::Pins, grabBy(DrawnOutline::Kind::Brush),
                    {ToolOption::GrabSize, ToolOption::Through});
}

}  // namespace wend
