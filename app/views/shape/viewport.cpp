#include "app/views/shape/viewport.h"

#include <QKeyEvent>
#include <utility>

#include "app/panels/legend.h"
#include "app/session/shape_session.h"
#include "app/views/shape/shape_painter.h"

namespace wend {

namespace {

constexpr int kDimAfter = 250, kNameAfter = 300;  // milliseconds

constexpr double kClickPixels = 4;

}  // namespace

Viewport::Viewport(View& view, ShapeView& shape, QWidget& widget, QWidget& overlay, Tool* over)
    : m_view(view), m_shape(shape), m_widget(widget), m_overlay(overlay), m_over(over) {
    m_dim.setSingleShot(true);
    m_dim.setInterval(kDimAfter);
    m_marksDue.setSingleShot(true);
    m_nameDue.setSingleShot(true);
    m_nameDue.setInterval(kNameAfter);
    const auto paint = qOverload<>(&QWidget::update);
    connect(&m_dim, &QTimer::timeout, this, [this] {
        m_dimmed = m_shape.session().motion().isStale();
        m_view.showLooks();
    });
    connect(&m_marksDue, &QTimer::timeout, &m_overlay, paint);
    connect(&m_nameDue, &QTimer::timeout, this, [this] {
        m_named = m_pointedAt;
        m_overlay.update();
    });
    connect(&m_shape.session().playback(), &Playback::playingChanged, &m_overlay, paint);
    connect(&m_shape.session().document(), &Document::opened, this, &Viewport::wantField);
    connect(&m_shape.session().gestures(), &ShapeGesture::pinsChanged, this, &Viewport::lookAgain);
    m_widget.installEventFilter(this);
}

void Viewport::setTool(Tool* tool) {
    const bool showed = m_tool && m_tool->showsPicture();
    if (Tool* last = std::exchange(m_tool, nullptr)) {
        last->cancel();
        last->leave();
        last->dismiss();
    }
    m_tool = tool;
    m_active = nullptr;
    if (tool) tool->choose();
    updateCursor();
    if (tool) tellHint(*tool);
    if (showed != (tool && tool->showsPicture())) m_view.showLooks();
    m_overlay.update();
}

/// Emits the hint of a tool. Without a solid no tool applies. Shapes of the other dimension are reported by
/// the other view.
void Viewport::tellHint(const Tool& tool) {
    if (m_shape.session().document().dimension() == m_shape.dimension())
        emit hintChanged(m_shape.dimension() == 2 || m_shape.session().motion().frame() ? tool.hint()
                                                                                        : QString());
}

void Viewport::lookAgain() {
    if (!m_tool || m_active || m_shape.session().motion().isDragging()) return;
    m_tool->lookAgain();
    updateCursor();
    tellHint(*m_tool);
    m_overlay.update();
}

void Viewport::cancelGesture() {
    if (Tool* tool = std::exchange(m_active, nullptr)) tool->cancel();
}

void Viewport::takeFrame() {
    const bool hasShape = m_shape.session().motion().frame() != nullptr;
    if (std::exchange(m_hasShape, hasShape) != hasShape && m_tool) tellHint(*m_tool);
    if (m_shape.session().motion().isStale() && !m_dimmed) {
        if (!m_dim.isActive()) m_dim.start();
    } else if (!m_shape.session().motion().isStale()) {
        m_dim.stop();
        m_dimmed = false;
    }
}

void Viewport::redraw(int milliseconds) {
    if (!m_shape.session().motion().isDragging())
        m_overlay.update();
    else if (!m_marksDue.isActive())
        m_marksDue.start(milliseconds);
}

void Viewport::takeLooks() {
    wantField();
    m_view.showLooks();
    if (m_pointer) emit pointed(m_view.pointerText(*m_pointer));
}

/// Fields for shapes of the other dimension are requested by the other view.
void Viewport::wantField() {
    if (m_shape.session().document().dimension() == m_shape.dimension())
        m_shape.session().motion().setFieldWanted(
            wantedField(m_looks.map, m_looks.colours.measure, m_looks.arrows || m_looks.values));
}

void Viewport::setRangeKeeper(QAction& keep) {
    m_lock = new LegendLock(keep, m_widget);
    showLegendLock();
}

void Viewport::showLegendLock() {
    if (m_lock) m_lock->setVisible(showsMap() && m_shape.session().motion().frame());
}

void Viewport::paintLegend(QPainter& painter, const QSize& size) const {
    if (showsMap())
        paintLegendCard(painter, size, m_looks.colours.measure, m_looks.colours.range, m_widget.palette(),
                        m_shape.dimension());
}

void Viewport::paintPins(ShapePainter& painter) const {
    if (m_shape.session().playback().isPlaying()) return;
    if (m_looks.groups) painter.groups(*m_looks.groups);
    painter.paths(hovered());
    painter.pins(hovered(), m_named);
}

void Viewport::showWorst() {
    const FramePtr frame = m_shape.session().motion().frame();
    const int cell = frame ? worstOf(*frame->distortion, m_looks.colours.measure).cell : -1;
    if (cell >= 0) showPlace(frame->centreOf(cell));
}

void Viewport::showPlace(const Vec3& at) {
    if (m_shape.session().document().dimension() == m_shape.dimension()) m_view.showPlace(at);
}

// --- Pointer and key events on a shape ---

bool Viewport::eventFilter(QObject* watched, QEvent* event) {
    auto& mouse = *static_cast<QMouseEvent*>(event);
    auto& key = *static_cast<QKeyEvent*>(event);
    switch (event->type()) {
        case QEvent::MouseButtonPress:
            return press(mouse), true;
        case QEvent::MouseButtonDblClick:
            return doubleClick(mouse), true;
        case QEvent::MouseMove:
            return move(mouse), true;
        case QEvent::MouseButtonRelease:
            return release(mouse), true;
        case QEvent::KeyPress:
            return pressKey(key);
        case QEvent::KeyRelease:
            if (key.key() == Qt::Key_Space && !key.isAutoRepeat()) setSpaceDown(false);
            return false;
        case QEvent::TabletPress:
        case QEvent::TabletMove:
        case QEvent::TabletRelease:
            m_shape.takePressure(*static_cast<QTabletEvent*>(event));
            return true;
        case QEvent::ShortcutOverride:
            if (!ownsKey(key)) return false;
            event->accept();
            return true;
        case QEvent::FocusOut:
            setSpaceDown(false);
            return false;
        case QEvent::Leave:
            leave();
            return false;
        case QEvent::PaletteChange:
            m_view.showLooks();
            return false;
        default:
            return QObject::eventFilter(watched, event);
    }
}

Tool* Viewport::toolAt(const QPointF& at) const {
    return m_over && !m_looks.hidden && m_over->wants(at) ? m_over : m_tool;
}

/// Shows the cursor and the hint of the tool, or of the one that the event has activated.
void Viewport::useTool(Tool* tool) {
    if (tool != m_over && m_tool) tool = m_tool;
    updateCursor();
    if (tool == m_over) m_widget.setCursor(tool->cursor());
    tellHint(*tool);
}

/// Returns whether the event is for the tool: a navigation button navigates, unless it was pressed on an item
/// of the tool.
bool Viewport::isForTool(const QMouseEvent& event, const Tool& tool) const {
    return event.button() == Qt::LeftButton && (!m_view.navigatesBy(event) || tool.wants(event.position()));
}

/// Returns whether the left button pans: with the space bar, or by the pan tool.
bool Viewport::pansBy(const QMouseEvent& event, const Tool* tool) const {
    return event.button() == Qt::LeftButton && !m_active && (m_spaceDown || (tool && tool->pans()));
}

/// Passes the event to the tool, which grabs the pointer.
void Viewport::give(Tool* tool, const QMouseEvent& event, void (Tool::*what)(const QMouseEvent&)) {
    m_active = tool;
    m_activeButton = event.button();
    (tool->*what)(event);
    useTool(tool);
    m_overlay.update();
}

void Viewport::press(QMouseEvent& event) {
    m_widget.setFocus(Qt::MouseFocusReason);
    m_pressedAt = event.position();
    if (event.button() == m_activeButton) m_active = nullptr;  // its release event was lost
    Tool* tool = toolAt(event.position());
    const bool pans = pansBy(event, tool);
    m_asksMenu = false;
    if (!pans && !m_active && tool && (tool->takesButton(event) || isForTool(event, *tool)))
        return give(tool, event, &Tool::press);
    m_asksMenu = !m_active && event.button() == Qt::RightButton;
    if (!m_active) m_view.navigate(event, pans);
    updateCursor();
}

/// Treats the second press of a double click as another press, unless the tool handles double clicks.
void Viewport::doubleClick(QMouseEvent& event) {
    Tool* tool = toolAt(event.position());
    if (!tool || m_active || pansBy(event, tool) || !isForTool(event, *tool)) return press(event);
    give(tool, event, &Tool::doubleClick);
}

/// Ignores a late move from before the press, which has no button pressed.
void Viewport::move(QMouseEvent& event) {
    if (m_active && event.buttons() == Qt::NoButton) return;
    m_pointer = event.position();
    emit pointed(m_view.pointerText(*m_pointer));
    if (!m_active && m_view.isNavigating()) return m_view.navigate(event, false);
    Tool* tool = m_active ? m_active : toolAt(event.position());
    if (!m_active && m_over && tool != m_over) m_over->move(event);
    if (!tool) return;
    tool->move(event);
    nameHovered();
    useTool(tool);
}

/// Ends the gesture. Opens a menu, which grabs the pointer, only without a gesture and if the view has not
/// moved.
void Viewport::release(QMouseEvent& event) {
    if (m_active) {
        if (event.button() != m_activeButton) return;
        Tool* tool = std::exchange(m_active, nullptr);
        tool->release(event);
        useTool(tool);
        m_overlay.update();
        return;
    }
    const bool click = (event.position() - m_pressedAt).manhattanLength() <= kClickPixels;
    const bool moved = m_view.isNavigating();
    const bool asks = event.button() == Qt::RightButton && event.buttons() == Qt::NoButton && m_asksMenu;
    if (asks && m_tool && (click || !moved)) {
        m_view.endNavigation();
        const MenuPlace place = m_tool->menuAt(event.position());
        if (place != MenuPlace::None) emit menuWanted(event.globalPosition().toPoint(), place);
        return;
    }
    m_view.navigate(event, false);
    updateCursor();
    if (!moved || m_spaceDown || !click || event.button() != Qt::LeftButton || !m_tool) return;
    m_tool->press(event);  // a click belongs to the tool even if the left button rotates the view
    m_tool->release(event);
    useTool(m_tool);
}

void Viewport::leave() {
    if (m_tool) m_tool->leave();
    nameHovered();
    m_overlay.update();
    m_pointer.reset();
    emit pointed({});
}

/// Shows the name of the hovered handle after a moment, so that names do not flicker past.
void Viewport::nameHovered() {
    if (std::exchange(m_pointedAt, hovered()) == hovered()) return;
    m_named = -1;
    m_pointedAt < 0 ? m_nameDue.stop() : m_nameDue.start();
}

bool Viewport::pressKey(QKeyEvent& event) {
    if (event.key() == Qt::Key_Space && !m_active) {
        if (!event.isAutoRepeat()) setSpaceDown(true);
        return true;
    }
    Tool* tool = m_active ? m_active : m_tool;
    if (!tool || !tool->key(event)) return false;
    useTool(tool);
    m_overlay.update();
    if (m_tool == m_active && event.key() == Qt::Key_Escape) m_active = nullptr;
    return true;
}

/// During a gesture all plain keys belong to the tool; arrows, Escape and Space belong to the focused view,
/// even if they are shortcuts.
bool Viewport::ownsKey(const QKeyEvent& event) const {
    const int key = event.key();
    const bool plain = !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier));
    return (m_tool && m_tool->ownsKey(event)) || (m_active && plain) || key == Qt::Key_Escape ||
           key == Qt::Key_Space || (key >= Qt::Key_Left && key <= Qt::Key_Down);
}

void Viewport::setSpaceDown(bool down) {
    m_spaceDown = down;
    updateCursor();
}

void Viewport::updateCursor() {
    if (m_view.isPanning())
        m_widget.setCursor(Qt::ClosedHandCursor);
    else if (m_spaceDown)
        m_widget.setCursor(Qt::OpenHandCursor);
    else
        m_widget.setCursor(m_tool ? m_tool->cursor() : QCursor(Qt::ArrowCursor));
}

}  // namespace wend
