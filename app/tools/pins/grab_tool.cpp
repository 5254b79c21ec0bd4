#include "app/tools/pins/grab_tool.h"

#include <QCoreApplication>
#include <iterator>

namespace wend {

namespace {

constexpr std::size_t kMostLooked = 4000;

}  // namespace

template <int Dim>
QString GrabTool<Dim>::hint() const {
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

template <int Dim>
void GrabTool<Dim>::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return;
    m_at = event.position();
    m_outline.begin(m_at);
    m_caught.clear();
    m_active = m_over = true;
    follow();
    surface().redraw();
}

template <int Dim>
void GrabTool<Dim>::move(const QMouseEvent& event) {
    m_at = event.position();
    m_over = true;
    if (m_active) {
        m_outline.goOn(m_at);
        follow();
    }
    surface().redraw();
}

/// Updates what would be held of a solid; nothing if testing visibility would delay the pointer.
template <int Dim>
void GrabTool<Dim>::follow() {
    if constexpr (Dim == 3) {
        if (m_outline.kind() == DrawnOutline::Kind::Brush) {
            const auto isNew = [this](const QPointF& p) { return m_outline.isNewlyBrushed(p); };
            m_caught = joined(m_caught, surface().verticesWhere(isNew, !takesHidden()));
        } else if (const auto all = drawnPart<3>(surface(), m_outline, true); all.size() <= kMostLooked) {
            m_caught = takesHidden() ? all : drawnPart<3>(surface(), m_outline, false);
        } else {
            m_caught.clear();
        }
    }
}

template <int Dim>
void GrabTool<Dim>::release(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || !std::exchange(m_active, false)) return;
    m_at = event.position();
    m_over = true;
    m_outline.goOn(m_at);
    if (session().template frame<Dim>() && session().document().dimension() == Dim) take(event.modifiers());
    m_caught.clear();
    surface().redraw();
}

template <int Dim>
void GrabTool<Dim>::take(Qt::KeyboardModifiers with) {
    if (m_outline.isClick()) {
        const bool changes = with & (Qt::ShiftModifier | Qt::ControlModifier);
        if (!changes) session().selection().clear();
        if constexpr (Dim == 3)
            if (const int vertex = surface().pick(m_at).vertex; changes && vertex >= 0)
                changePart<3>(surface(), {vertex}, with);
        return;
    }
    const auto part = drawnPart<Dim>(surface(), m_outline, takesHidden());
    if (!changePart<Dim>(surface(), part, with) && holdPart<Dim>(surface(), part)) m_done();
}

template <int Dim>
bool GrabTool<Dim>::key(const QKeyEvent& event) {
    const bool escapes = event.key() == Qt::Key_Escape;
    if (escapes && !m_active) session().selection().clear();
    if (escapes) cancel();
    const auto radius = m_outline.radiusAfter(event);
    if (radius) m_choice.change(&PinSettings::radius, *radius);
    if (!escapes && !radius) return false;
    surface().redraw();
    return true;
}

template <int Dim>
void GrabTool<Dim>::cancel() {
    m_active = false;
    m_caught.clear();
}

template <int Dim>
void GrabTool<Dim>::paint(QPainter& painter) const {
    if (m_active)
        m_outline.paint(painter);
    else if (m_over && m_outline.kind() == DrawnOutline::Kind::Brush)
        m_outline.paintBrush(painter, m_at);
    if constexpr (Dim == 3)
        if (m_active && !m_caught.empty()) paintCaught(painter, surface(), m_caught, m_at);
}

template class GrabTool<2>;
template class GrabTool<3>;

ToolKind grabByLassoTool() {
    return toolKind("lasso", "area-lasso", QT_TRANSLATE_NOOP("Tools", "Grab by &Lasso"),
                    QT_TRANSLATE_NOOP("Tools", "Take hold of all that lies in a drawn outline as one handle"),
                    "L", Mode::Pins,
                    both<GrabTool>(DrawnOutline::Kind::Lasso, &Workbench::pins, &Workbench::toSelect),
                    {ToolOption::Through});
}

ToolKind grabByBoxTool() {
    return toolKind("rectangle", "area-rectangle", QT_TRANSLATE_NOOP("Tools", "Grab by Bo&x"),
                    QT_TRANSLATE_NOOP("Tools", "Take hold of all that lies in a rectangle as one handle"),
                    "Shift+B", Mode::Pins,
                    both<GrabTool>(DrawnOutline::Kind::Rectangle, &Workbench::pins, &Workbench::toSelect),
                    {ToolOption::Through});
}

ToolKind grabByBrushTool() {
    return toolKind("grabBrush", "area-brush", QT_TRANSLATE_NOOP("Tools", "Grab by &Brush"),
                    QT_TRANSLATE_NOOP("Tools", "Take hold of what is brushed over as one handle"), "U",
                    Mode::Pins,
                    both<GrabTool>(DrawnOutline::Kind::Brush, &Workbench::pins, &Workbench::toSelect),
                    {ToolOption::GrabSize, ToolOption::Through});
}

}  // namespace wend
