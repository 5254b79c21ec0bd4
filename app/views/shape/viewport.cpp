#include "app/views/shape/viewport.h"

#include <utility>

#include "app/panels/legend.h"

namespace wend {

namespace {

constexpr int kDimAfter = 250, kNameAfter = 300;  // milliseconds

}  // namespace

Viewport::Viewport(View& view, QWidget& widget, QWidget& overlay, ShapeSession& session, int dimension,
                   Tool* over)
    : m_view(view),
      m_widget(widget),
      m_overlay(overlay),
      m_session(session),
      m_dimension(dimension),
      m_over(over) {
    m_dim.setSingleShot(true);
    m_dim.setInterval(kDimAfter);
    m_marksDue.setSingleShot(true);
    m_nameDue.setSingleShot(true);
    m_nameDue.setInterval(kNameAfter);
    const auto paint = qOverload<>(&QWidget::update);
    connect(&m_dim, &QTimer::timeout, this, [this] {
        m_dimmed = m_session.isStale();
        m_view.showLooks();
    });
    connect(&m_marksDue, &QTimer::timeout, &m_overlay, paint);
    connect(&m_nameDue, &QTimer::timeout, this, [this] {
        m_named = m_pointedAt;
        m_overlay.update();
    });
    connect(&m_session.playback(), &Playback::playingChanged, &m_overlay, paint);
    connect(&m_session.document(), &Document::opened, this, &Viewport::wantField);
    connect(&m_session, &ShapeSession::pinsChanged, this, &Viewport::lookAgain);
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
    if (m_session.document().dimension() == m_dimension)
        emit hintChanged(m_dimension == 2 || m_session.frame() ? tool.hint() : QString());
}

void Viewport::lookAgain() {
    if (!m_tool || m_active || m_session.isDragging()) return;
    m_tool->lookAgain();
    updateCursor();
    tellHint(*m_tool);
    m_overlay.update();
}

void Viewport::cancelGesture() {
    if (Tool* tool = std::exchange(m_active, nullptr)) tool->cancel();
}

void Viewport::takeFrame() {
    const bool hasShape = m_session.frame() != nullptr;
    if (std::exchange(m_hasShape, hasShape) != hasShape && m_tool) tellHint(*m_tool);
    if (m_session.isStale() && !m_dimmed) {
        if (!m_dim.isActive()) m_dim.start();
    } else if (!m_session.isStale()) {
        m_dim.stop();
        m_dimmed = false;
    }
}

void Viewport::redraw(int milliseconds) {
    if (!m_session.isDragging())
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
    if (m_session.document().dimension() == m_dimension)
        m_session.setFieldWanted(
            wantedField(m_looks.map, m_looks.colours.measure, m_looks.arrows || m_looks.values));
}

void Viewport::setRangeKeeper(QAction& keep) {
    m_lock = new LegendLock(keep, m_widget);
    showLegendLock();
}

void Viewport::showLegendLock() {
    if (m_lock) m_lock->setVisible(showsMap() && m_session.frame());
}

void Viewport::paintLegend(QPainter& painter, const QSize& size) const {
    if (showsMap())
        paintLegendCard(painter, size, m_looks.colours.measure, m_looks.colours.range, m_widget.palette(),
                        m_dimension);
}

}  // namespace wend
