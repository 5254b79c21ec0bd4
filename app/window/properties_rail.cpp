#include "app/window/properties_rail.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/base/preferences.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/surface_panel.h"
#include "app/style/theme.h"
#include "app/window/properties.h"

namespace wend {

namespace {

constexpr int kNarrowWindow = 1100;  // below it the view needs the room
constexpr int kRailButton = 36, kRailIcon = 20;

}  // namespace

PropertiesRail::PropertiesRail(Properties& properties, QAction& shown, QWidget* parent)
    : QWidget(parent),
      m_properties(properties),
      m_shown(shown),
      m_column(new QVBoxLayout(this)),
      m_wanted(preferences::propertiesShown.value()) {
    setObjectName(QStringLiteral("propertiesRail"));
    setAttribute(Qt::WA_StyledBackground);
    m_column->setContentsMargins(5, 8, 3, 8);  // its line at the left
    m_column->setSpacing(4);
    m_column->addStretch(1);
    m_properties.setParent(parent);
    m_properties.hide();
    connect(&m_shown, &QAction::triggered, this, &PropertiesRail::take);
    connect(&m_properties, &Properties::sectionsChanged, this, &PropertiesRail::showSections);
    showSections();
}

QToolButton* PropertiesRail::buttonOf(QWidget& section) {
    QToolButton*& button = m_buttons[&section];
    if (button) return button;
    button = new QToolButton(this);
    button->setCheckable(true);
    button->setFixedSize(kRailButton, kRailButton);
    button->setIconSize({kRailIcon, kRailIcon});
    button->setFocusPolicy(Qt::TabFocus);
    connect(button, &QToolButton::clicked, this, [this, &section] { toggle(section); });
    return button;
}

/// Shows a button for each section of the step, in their order.
void PropertiesRail::showSections() {
    for (const auto& [section, button] : m_buttons) button->hide();
    int place = 0;
    for (const Properties::Section& one : m_properties.sections()) {
        QToolButton* button = buttonOf(*one.place);
        button->setIcon(wendIcon(QString::fromLatin1(one.icon), palette()));
        describe(button, one.name, tr("Opens this part of the properties over the view; Esc closes it."));
        m_column->insertWidget(place++, button);
        button->setVisible(isCollapsed());
    }
}

void PropertiesRail::fitTo(int windowWidth) {
    m_narrow = windowWidth < kNarrowWindow;
    m_properties.fitTo(windowWidth);
    arrange();
}

/// Opens the panels over the view in a narrow window, for now; otherwise the choice is stored.
void PropertiesRail::take(bool shown) {
    if (m_narrow) {
        const auto sections = m_properties.sections();
        shown && !sections.empty() ? open(*sections.front().place) : close();
        return arrange();
    }
    m_wanted = shown;
    preferences::propertiesShown.set(shown);
    close();
    arrange();
}

void PropertiesRail::toggle(QWidget& section) {
    m_open&& m_section == &section ? close() : open(section);
    arrange();
}

void PropertiesRail::open(QWidget& section) {
    if (!isCollapsed()) return;
    m_section = &section;
    if (!std::exchange(m_open, true)) qApp->installEventFilter(this);
    arrange();
    m_properties.raise();
    m_properties.showSection(section);
    m_properties.setFocus(Qt::PopupFocusReason);  // so that Tab moves to its first field
}

void PropertiesRail::openAtSurface() {
    for (const Properties::Section& one : m_properties.sections())
        if (one.place->isAncestorOf(&m_properties.surface())) open(*one.place);
}

void PropertiesRail::close() {
    if (!std::exchange(m_open, false)) return;
    const QWidget* focus = QApplication::focusWidget();
    const bool had = focus && isBeside(*focus);
    m_section = nullptr;
    if (!m_swallows) qApp->removeEventFilter(this);
    arrange();
    if (had) emit done();
}

void PropertiesRail::arrange() {
    if (!isCollapsed() && m_open) close();
    setFixedWidth(isCollapsed() ? kWidth : m_properties.width());
    for (const Properties::Section& one : m_properties.sections()) {
        QToolButton* button = buttonOf(*one.place);
        button->setVisible(isCollapsed());
        button->setChecked(m_open && m_section == one.place);
    }
    place();
    const bool seen = isVisibleTo(parentWidget()) && (m_open || !isCollapsed());
    m_properties.setVisible(seen);
    m_shown.setChecked(m_open || !isCollapsed());
}

/// Places the panels over the rail, or left of it.
void PropertiesRail::place() {
    const int left = isCollapsed() ? x() - m_properties.width() : x();
    m_properties.setGeometry(left, y(), m_properties.width(), height());
}

bool PropertiesRail::isBeside(const QWidget& widget) const {
    return &widget == &m_properties || m_properties.isAncestorOf(&widget) || &widget == this ||
           isAncestorOf(&widget);
}

/// Menus and dialogs that were opened from it are windows of their own.
bool PropertiesRail::closesBy(const QWidget& widget, const QEvent& press) {
    if (widget.window() != window() || isBeside(widget)) return false;
    m_swallows = press.type() == QEvent::MouseButtonPress && parentWidget()->isAncestorOf(&widget);
    close();
    return m_swallows;
}

/// A click on the view only closes the panels; a click on a bar works as usual.
bool PropertiesRail::eventFilter(QObject* watched, QEvent* event) {
    const auto* widget = qobject_cast<const QWidget*>(watched);
    if (!widget) return false;
    if (m_swallows) {
        if (event->type() == QEvent::MouseButtonRelease) {
            m_swallows = false;
            qApp->removeEventFilter(this);
            return true;
        }
        return event->type() == QEvent::MouseMove;
    }
    if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick)
        return closesBy(*widget, *event);
    if (event->type() != QEvent::KeyPress || QApplication::activePopupWidget() ||
        QApplication::activeModalWidget())
        return false;
    if (static_cast<const QKeyEvent*>(event)->key() != Qt::Key_Escape) return false;
    close();
    return true;
}

void PropertiesRail::resizeEvent(QResizeEvent*) {
    place();
}

void PropertiesRail::moveEvent(QMoveEvent*) {
    place();
}

void PropertiesRail::showEvent(QShowEvent*) {
    arrange();
}

void PropertiesRail::hideEvent(QHideEvent*) {
    if (isHidden()) close();
    arrange();
}

void PropertiesRail::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) showSections();
    QWidget::changeEvent(event);
}

}  // namespace wend
