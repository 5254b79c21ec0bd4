#include "app/window/actions/bars.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QMouseEvent>
#include <QRegularExpression>
#include <QSet>
#include <QTextEdit>
#include <QToolButton>
#include <QToolTip>
#include <QWidget>
#include <algorithm>
#include <utility>

#include "app/panels/fields/controls.h"
#include "app/panels/fields/panel_parts.h"
#include "app/project/edits/document.h"
#include "app/window/actions/actions.h"
#include "app/window/actions/brush_actions.h"
#include "app/window/actions/depth_actions.h"
#include "app/window/actions/picture_actions.h"
#include "app/window/actions/pin_actions.h"
#include "app/window/actions/solid_actions.h"
#include "app/window/actions/toolbox.h"

namespace wend {

namespace {

/// Returns the mnemonic; null if there is none.
QChar letterOf(const QString& text) {
    static const QRegularExpression letter(QStringLiteral("&([^&\\s])"));
    const auto found = letter.match(QString(text).remove(QStringLiteral("&&")));
    return found.hasMatch() ? found.captured(1)[0].toUpper() : QChar();
}

/// Assigns a free letter; languages without an alphabet have one in brackets at the end.
QString withFreeLetter(const QString& text, const QSet<QChar>& taken) {
    static const QRegularExpression bracket(QStringLiteral("\\(&.\\)"));
    if (text.contains(bracket)) {
        for (char letter = 'A'; letter <= 'Z'; ++letter)
            if (!taken.contains(QLatin1Char(letter)))
                return QString(text).replace(bracket, QStringLiteral("(&%1)").arg(QLatin1Char(letter)));
        return QString(text).remove(bracket);
    }
    QString plain = withoutKey(text);
    for (qsizetype i = 0; i < plain.size(); ++i)
        if (plain[i].isLetter() && !taken.contains(plain[i].toUpper())) return plain.insert(i, u'&');
    return plain;
}

constexpr int kStepWidth = 104, kStepHeight = 32, kIcon = 20, kButton = 36, kZoom = 56, kGap = 16;

/// Boxes of numbers have no use for letters.
bool typesText(const QObject* widget) {
    const auto* line = qobject_cast<const QLineEdit*>(widget);
    return line && !line->isReadOnly() && !qobject_cast<const QAbstractSpinBox*>(line->parent());
}

bool isPlain(const QEvent& event, Qt::Key key) {
    const auto& press = static_cast<const QKeyEvent&>(event);
    return press.key() == key && !press.modifiers();
}

template <class... Kinds>
bool isOneOf(const QObject* widget) {
    return (qobject_cast<const Kinds*>(widget) || ...);
}

bool usesSpace(const QObject* widget) {
    return isOneOf<QLineEdit, QTextEdit, QAbstractSpinBox, QAbstractButton, QComboBox, QAbstractItemView>(
        widget);
}

}  // namespace

ContextMenu::ContextMenu(const Offers& offers, QObject* parent)
    : QObject(parent), m_offers(offers), m_menu(std::make_unique<QMenu>()) {}

void ContextMenu::popUp(const QPoint& global, MenuPlace place) {
    if (place == MenuPlace::None || m_offers.document.isEmpty()) return;
    if (place == MenuPlace::Curve) {
        m_offers.curves.popUp(global);
        return;
    }
    m_offers.curves.refresh();
    m_menu->clear();
    if (place == MenuPlace::Handle)
        offerPin();
    else
        offerCanvas();
    m_menu->popup(global);
}

void ContextMenu::offerPin() {
    const Actions& a = m_offers.actions;
    m_menu->addSection(m_offers.pins.selectedName());
    if (m_offers.document.dimension() == 2) m_menu->addMenu(m_offers.depth.menu());
    m_offers.pins.fill(*m_menu);
    m_menu->addSeparator();
    m_menu->addAction(m_offers.curves.make);
    m_menu->addAction(a.remove);
    m_menu->addSeparator();
    m_menu->addActions({a.selectAll, a.selectNone});
}

void ContextMenu::offerCanvas() {
    const Actions& a = m_offers.actions;
    m_menu->addActions({a.undo, a.redo});
    m_menu->addSeparator();
    m_menu->addActions({a.pinTool, a.selectTool, a.selectAll, m_offers.pins.showAll});
    m_menu->addSeparator();
    m_menu->addActions({a.showMesh, a.showMap, a.hideOverlays});
    m_menu->addSeparator();
    m_menu->addActions({a.fit, a.actualSize});
}

void makeLettersUnique(QMenu& menu) {
    QSet<QChar> taken;
    QList<QAction*> others;
    for (QAction* action : menu.actions()) {
        if (action->menu()) makeLettersUnique(*action->menu());
        const QChar letter = letterOf(action->text());
        if (letter.isNull()) continue;
        if (taken.contains(letter))
            others << action;
        else
            taken << letter;
    }
    for (QAction* action : others) {
        action->setText(withFreeLetter(action->text(), taken));
        if (const QChar letter = letterOf(action->text()); !letter.isNull()) taken << letter;
    }
}

MenuReasons::MenuReasons(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
}

bool MenuReasons::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ToolTip) return false;
    auto* menu = qobject_cast<QMenu*>(watched);
    if (!menu) return false;
    const auto& help = static_cast<const QHelpEvent&>(*event);
    QAction* entry = menu->actionAt(help.pos());
    if (!entry || entry->isEnabled() || entry->statusTip().isEmpty()) return false;
    QToolTip::showText(help.globalPos(), entry->statusTip(), menu, menu->actionGeometry(entry));
    return true;
}

ModeRow::ModeRow(const Actions& a, const Toolbox& tools, QWidget* parent) : QWidget(parent) {
    auto* row = bareRow(this, kGap);
    row->addWidget(side({a.open, a.save, nullptr, a.undo, a.redo}, Qt::AlignLeft), 1);
    row->addWidget(steps(tools));
    QWidget* right =
        side({a.showRest, a.showMap, a.showMesh, a.hideOverlays, nullptr, a.fit}, Qt::AlignRight);
    right->layout()->addWidget(makeZoom(a));
    right->layout()->addWidget(makeExport(a));
    row->addWidget(right, 1);
    m_spare.push_back(m_zoom);
    for (QAction* action : {a.fit, a.showRest, a.hideOverlays, a.redo, a.undo, a.save, a.open, a.showMesh})
        for (QToolButton* one : findChildren<QToolButton*>())
            if (one->defaultAction() == action) m_spare.push_back(one);
}

QToolButton* ModeRow::button(QAction* action, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setDefaultAction(action);
    button->setIconSize({kIcon, kIcon});
    button->setFixedSize(kButton, kButton);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

QWidget* ModeRow::side(const QList<QAction*>& actions, Qt::Alignment to) {
    auto* part = new QWidget(this);
    auto* row = bareRow(part, 2);
    if (to == Qt::AlignRight) row->addStretch(1);
    for (QAction* action : actions) action ? row->addWidget(button(action, part)) : row->addSpacing(kGap / 2);
    if (to == Qt::AlignLeft) row->addStretch(1);
    return part;
}

QWidget* ModeRow::steps(const Toolbox& tools) {
    auto* group = new QWidget(this);
    group->setObjectName(QStringLiteral("steps"));
    group->setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(group);
    row->setContentsMargins(2, 2, 2, 2);
    row->setSpacing(2);
    for (const Mode mode : kModes) {
        auto* step = new QToolButton(group);
        step->setDefaultAction(tools.modeAction(mode));
        step->setToolButtonStyle(Qt::ToolButtonTextOnly);
        step->setProperty("role", "step");
        step->setFixedHeight(kStepHeight);
        step->setFocusPolicy(Qt::TabFocus);
        row->addWidget(step);
        m_steps.push_back(step);
    }
    return group;
}

QToolButton* ModeRow::makeZoom(const Actions& a) {
    m_zoom = buttonFor<QToolButton>(
        this, "zoom", {}, tr("How large the picture is shown; a click shows its pixels as they are."),
        [&a] { a.actualSize->trigger(); }, tr("Zoom"));
    m_zoom->setFixedSize(kZoom, kButton);
    m_zoom->setFocusPolicy(Qt::TabFocus);
    connect(a.actualSize, &QAction::changed, m_zoom,
            [this, &a] { m_zoom->setEnabled(a.actualSize->isEnabled()); });
    return m_zoom;
}

void ModeRow::showZoom(double zoom) {
    const double percent = 100 * zoom;
    m_zoom->setText(zoom > 0 ? tr("%1 %").arg(QLocale().toString(percent, 'f', percent < 9.95 ? 1 : 0))
                             : QString());
}

QToolButton* ModeRow::makeExport(const Actions& actions) {
    m_export = new QToolButton(this);
    m_export->setObjectName(QStringLiteral("exportButton"));
    m_export->setText(tr("Export"));
    m_export->setMenu(actions.exports.get());
    m_export->setPopupMode(QToolButton::InstantPopup);
    m_export->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_export->setIconSize({kIcon, kIcon});
    m_export->setFocusPolicy(Qt::TabFocus);
    describe(m_export, tr("Export"),
             tr("Export what is shown as a picture, film, sequence, ST map, mesh or view"));
    return m_export;
}

QSize ModeRow::minimumSizeHint() const {
    int width = m_export->sizeHint().width() + 4 * kGap + kZoom - kButton;
    for (const QToolButton* step : m_steps) width += step->sizeHint().width() + 2;
    return {width, kButton};
}

void ModeRow::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    collapse();
}

void ModeRow::collapse() {
    int minimum = minimumSizeHint().width();
    int wish = minimum;
    for (const QToolButton* step : m_steps) wish += std::max(0, kStepWidth - step->sizeHint().width());
    const int buttons = static_cast<int>(m_spare.size()) + 1;
    const bool wide = width() >= wish + buttons * (kButton + 2);
    for (QToolButton* step : m_steps)
        step->setFixedWidth(wide ? std::max(kStepWidth, step->sizeHint().width()) : step->sizeHint().width());
    int room = width() - minimum - (kButton + 2);  // the map always stays
    auto kept = static_cast<int>(m_spare.size());
    if (!wide) kept = std::clamp(room / (kButton + 2), 0, kept);
    for (int i = 0; i < static_cast<int>(m_spare.size()); ++i)
        m_spare[i]->setVisible(i >= static_cast<int>(m_spare.size()) - kept);
}

QList<QAction*> ToolOptions::of(const ToolKind& kind) const {
    QList<QAction*> all;
    for (const ToolOption option : kind.options) all << of(option);
    return all;
}

QList<QAction*> ToolOptions::of(ToolOption option) const {
    switch (option) {
        case ToolOption::Grip:
            return {pins.move, pins.turn, pins.grow};
        case ToolOption::SelectBy:
            return {pins.selectRectangle, pins.selectLasso, pins.selectBrush};
        case ToolOption::Through:
            return {solids.through};
        case ToolOption::Snap:
            return {pins.snap};
        case ToolOption::AddsOrTakes:
            return {outline.adds, outline.takesAway, outline.makesPart};
        case ToolOption::PenSize:
            return {outline.size};
        case ToolOption::Tolerance:
            return {outline.tolerance};
        case ToolOption::Edges:
            return {brush.edges};
        case ToolOption::Target:
            return {brush.keep, brush.stiffness, brush.direction};
        case ToolOption::BrushSize:
            return {brush.size};
        case ToolOption::GrabSize:
            return {pins.brushSize};
        case ToolOption::Tip:
            return {brush.size, brush.hardness, brush.amount, brush.pressure};
        case ToolOption::Order:
            return {brush.order};
        case ToolOption::Separator:
            break;
    }
    return {nullptr};
}

OptionRow::OptionRow(const Toolbox& tools, const Actions& actions, const ToolOptions& options,
                     QWidget* parent)
    : QToolBar(tr("Options"), parent), m_tools(tools), m_actions(actions), m_options(options) {
    setObjectName(QStringLiteral("optionRow"));
    setMovable(false);
    setIconSize({20, 20});
    setFixedHeight(40);
    setContextMenuPolicy(Qt::PreventContextMenu);
    connect(&m_tools, &Toolbox::changed, this, &OptionRow::showTool);
    showTool();
}

/// Options of solids are hidden with their actions while a picture is open.
void OptionRow::showTool() {
    clear();
    const ToolKind* kind = m_tools.current();
    if (!kind) return;
    QAction* tool = m_tools.action(QString::fromLatin1(kind->id));
    auto* title = new QLabel(withoutKey(tool->text()));
    title->setProperty("role", "title");
    title->setContentsMargins(8, 0, 8, 0);
    addWidget(title);
    bool any = false;
    for (QAction* option : m_options.of(*kind)) {
        option ? addAction(option) : static_cast<void>(addSeparator());
        any = any || (option && option->isVisible());
    }
    if (m_tools.mode() == Mode::Animate) return showMotion();
    if (any) return;
    auto* help = new QLabel(ActionMaker::helpOf(*tool));
    help->setProperty("role", "second");
    addWidget(help);
}

void OptionRow::showMotion() {
    QAction* speed = m_actions.speed->menuAction();
    addSeparator();
    for (QAction* action : {m_actions.record, m_actions.onionSkin, m_actions.loop}) {
        addAction(action);
        qobject_cast<QToolButton*>(widgetForAction(action))->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    }
    addAction(speed);
    qobject_cast<QToolButton*>(widgetForAction(speed))->setPopupMode(QToolButton::InstantPopup);
}

HeldKey::HeldKey(Qt::Key key, QWidget& window) : QObject(&window), m_key(key), m_window(window) {
    qApp->installEventFilter(this);
}

bool HeldKey::begins(QObject* watched, const QEvent& event) const {
    const auto* widget = qobject_cast<const QWidget*>(watched);
    if (!widget || widget->window() != &m_window || QApplication::activePopupWidget()) return false;
    return isPlain(event, m_key) && !typesText(watched);
}

bool HeldKey::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::KeyPress:
            if (!begins(watched, *event)) return false;
            setHeld(true);
            return true;
        case QEvent::KeyRelease: {
            const auto& release = static_cast<const QKeyEvent&>(*event);
            if (m_held && release.key() == m_key && !release.isAutoRepeat()) setHeld(false);
            return false;
        }
        case QEvent::WindowDeactivate:
            if (watched == &m_window) setHeld(false);
            return false;
        default:
            return false;
    }
}

void HeldKey::setHeld(bool held) {
    if (held == m_held) return;
    m_held = held;
    emit heldChanged(held);
}

SpaceTap::SpaceTap(QWidget& window, QAction& action) : QObject(&window), m_window(window), m_action(action) {
    qApp->installEventFilter(this);
}

/// Events that are not accepted propagate to parents: only the first one counts.
bool SpaceTap::isOurs(const QObject* watched) const {
    const QWidget* focus = QApplication::focusWidget();
    return watched == focus && focus->window() == &m_window && !QApplication::activePopupWidget() &&
           !usesSpace(focus);
}

void SpaceTap::press(const QKeyEvent& key) {
    m_down = key.key() == Qt::Key_Space && !key.modifiers() && !key.isAutoRepeat() && !m_buttons;
}

void SpaceTap::release(const QKeyEvent& key) {
    if (key.key() != Qt::Key_Space || key.isAutoRepeat()) return;
    if (std::exchange(m_down, false)) m_action.trigger();
}

bool SpaceTap::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::KeyPress:
            if (isOurs(watched)) press(static_cast<QKeyEvent&>(*event));
            return false;
        case QEvent::KeyRelease:
            if (isOurs(watched)) release(static_cast<QKeyEvent&>(*event));
            return false;
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonRelease:
            m_buttons = static_cast<QMouseEvent&>(*event).buttons();
            m_down = false;
            return false;
        case QEvent::Wheel:
        case QEvent::FocusIn:
        case QEvent::WindowDeactivate:
            m_down = false;
            return false;
        default:
            return false;
    }
}

}  // namespace wend
