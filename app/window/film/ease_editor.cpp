#include "app/window/film/ease_editor.h"

#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/panels/fields/controls.h"
#include "app/panels/fields/ease_names.h"
#include "app/panels/fields/panel_parts.h"
#include "app/style/theme.h"
#include "app/window/film/track_choice.h"

namespace wend {

namespace {

constexpr double kDot = 6;                          // pixels, radius of a handle
constexpr double kDotGrip = 14;                     // pixels around it
constexpr double kEaseSnap = 5;                     // pixels
constexpr double kNearStep = 0.02, kFarStep = 0.1;  // of the way, per key press
constexpr int kCurvePieces = 64;                    // straight pieces of the curve

constexpr double kInPercent = 100;
constexpr int kEaseIcon = 20;  // pixels

}  // namespace

EasePlot::EasePlot(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("easePlot"));
    setFocusPolicy(Qt::StrongFocus);
    describe(this, tr("Easing curve"),
             tr("How far the pin has come over time. Drag the two handles up or down; Left and Right choose "
                "one, Up and Down move it."));
}

void EasePlot::setProgress(const std::optional<ShownProgress>& shown) {
    m_shown = shown;
    m_drags = false;
    m_curve = shown ? shown->curve : Progress{};
    update();
}

QRectF EasePlot::area() const {
    return QRectF(rect()).adjusted(12, 8, -12, -8);
}

QPointF EasePlot::spot(double time, double way) const {
    const QRectF box = area();
    return {box.left() + time * box.width(), box.bottom() - (way - kLow) / (kHigh - kLow) * box.height()};
}

QPointF EasePlot::handleSpot(int handle) const {
    return handle == 0 ? spot(1.0 / 3, m_curve.first) : spot(2.0 / 3, m_curve.second);
}

/// Returns the progress that a handle may have: that of a recording never decreases.
double EasePlot::limited(double way) const {
    const bool forward = m_shown && !m_shown->way.empty();
    return std::clamp(way, forward ? 0 : kLow, forward ? 1 : kHigh);
}

void EasePlot::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_shown || !m_shown->isFree) return;
    const auto distance = [&](int handle) {
        const QPointF off = handleSpot(handle) - event->position();
        return std::hypot(off.x(), off.y());
    };
    const int nearest = distance(0) <= distance(1) ? 0 : 1;
    if (distance(nearest) > kDotGrip) return;
    m_active = nearest;
    m_before = m_curve;
    m_drags = true;
    update();
}

/// Snaps to the places of the four easings.
void EasePlot::mouseMoveEvent(QMouseEvent* event) {
    if (!m_drags) return;
    const QRectF box = area();
    double way = kLow + (box.bottom() - event->position().y()) / box.height() * (kHigh - kLow);
    for (const double mark : {0.0, 1.0 / 3, 2.0 / 3, 1.0})
        if (std::abs(spot(0, mark).y() - event->position().y()) < kEaseSnap) way = mark;
    wayOf(m_active) = limited(way);
    emit moved(m_curve);
    update();
}

void EasePlot::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !std::exchange(m_drags, false)) return;
    update();
    if (m_curve != m_before) emit changed(m_curve, false);
}

/// Esc puts a dragged handle back rather than closing the window.
bool EasePlot::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && m_drags &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void EasePlot::keyPressEvent(QKeyEvent* event) {
    if (m_drags && event->key() == Qt::Key_Escape) {
        m_drags = false;
        m_curve = m_before;
        emit moved(m_curve);
        return update();
    }
    const int side = event->key() == Qt::Key_Up ? 1 : event->key() == Qt::Key_Down ? -1 : 0;
    if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right) {
        m_active = event->key() == Qt::Key_Left ? 0 : 1;
        return update();
    }
    if (side == 0 || m_drags || !m_shown || !m_shown->isFree) return QWidget::keyPressEvent(event);
    const double step = event->modifiers() & Qt::ShiftModifier ? kFarStep : kNearStep;
    wayOf(m_active) = limited(wayOf(m_active) + side * step);
    update();
    emit changed(m_curve, true);
}

void EasePlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    paintGrid(painter);
    if (!m_shown) return;
    paintCurve(painter);
    if (m_shown->isFree) paintHandles(painter);
    if (!hasFocus()) return;
    painter.setPen(QPen(Theme::of(palette()).accentText, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

void EasePlot::paintGrid(QPainter& painter) const {
    const Theme theme = Theme::of(palette());
    painter.setPen(QPen(theme.line, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(spot(0, 1), spot(1, 0)));
    for (const double third : {1.0 / 3, 2.0 / 3}) painter.drawLine(spot(third, kLow), spot(third, kHigh));
    painter.setPen(QPen(theme.line, 1, Qt::DashLine));
    painter.drawLine(spot(0, 0), spot(1, 1));
}

/// Draws the rhythm of a recording thin beneath the curve that is nearest to it.
void EasePlot::paintCurve(QPainter& painter) const {
    const Theme theme = Theme::of(palette());
    painter.setBrush(Qt::NoBrush);
    if (m_shown->way.size() > 1) {
        QPolygonF own;
        for (std::size_t i = 0; i < m_shown->way.size(); ++i)
            own << spot(double(i) / double(m_shown->way.size() - 1), m_shown->way[i]);
        painter.setPen(QPen(theme.secondText, 1));
        painter.drawPolyline(own);
    }
    QPolygonF curve;
    for (int i = 0; i <= kCurvePieces; ++i)
        curve << spot(double(i) / kCurvePieces, m_curve.at(double(i) / kCurvePieces));
    painter.setPen(QPen(theme.accentText, 2.5));
    painter.drawPolyline(curve);
}

void EasePlot::paintHandles(QPainter& painter) const {
    const Theme theme = Theme::of(palette());
    for (int handle = 0; handle < 2; ++handle) {
        const QPointF at = handleSpot(handle);
        painter.setPen(QPen(palette().color(QPalette::WindowText), 1));
        painter.drawLine(handle == 0 ? spot(0, 0) : spot(1, 1), at);
        const bool active = hasFocus() && handle == m_active;
        painter.setBrush(active ? theme.accentText : palette().color(QPalette::WindowText));
        painter.setPen(QPen(palette().color(QPalette::Base), 1.5));
        painter.drawEllipse(at, kDot, kDot);
    }
}

EaseEditor::EaseEditor(TrackChoice& choice, QWidget* parent)
    : QDialog(parent, Qt::Tool),
      m_choice(choice),
      m_what(secondLabel({}, this)),
      m_plot(new EasePlot(this)),
      m_start(speedBox(tr("Speed at the start"))),
      m_end(speedBox(tr("Speed at the end"))) {
    setObjectName(QStringLiteral("easeEditor"));
    setWindowTitle(tr("Easing Curve"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_what);
    column->addWidget(m_plot, 1);
    column->addWidget(makePresets());
    column->addLayout(panelRow(tr("Speed at the &start"), m_start, this));
    column->addLayout(panelRow(tr("Speed at the &end"), m_end, this));
    connect(m_plot, &EasePlot::moved, this, &EaseEditor::showSpeeds);
    connect(m_plot, &EasePlot::changed, this, [this](const Progress& curve, bool byKey) {
        m_choice.setProgress(curve, byKey ? QStringLiteral("ease keys") : QString());
    });
    connect(&m_choice, &TrackChoice::changed, this, &EaseEditor::takeChoice);
    takeChoice();
}

ExactBox* EaseEditor::speedBox(const QString& name) {
    const Numbers numbers{3 * EasePlot::kLow * kInPercent, 3 * EasePlot::kHigh * kInPercent, 0, 10, tr(" %")};
    ExactBox* box =
        numberBox(this, "", name, tr("In percent of the speed of an even move: at 0 % the pin stops there."),
                  numbers, &EaseEditor::typeSpeeds);
    box->setKeyboardTracking(false);
    return box;
}

QIcon EaseEditor::curveIcon(const Progress& curve) const {
    const qreal ratio = devicePixelRatioF();
    QPixmap pixmap(QSize(kEaseIcon, kEaseIcon) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::ButtonText), 1.8));
    QPolygonF line;
    for (int i = 0; i <= kEaseIcon; ++i) {
        const double s = double(i) / kEaseIcon;
        line << QPointF(2 + 16 * s, 18 - 16 * curve.at(s));
    }
    painter.drawPolyline(line);
    return pixmap;
}

QWidget* EaseEditor::makePresets() {
    auto* row = new QWidget(this);
    auto* buttons = bareRow(row, 4);
    for (const Ease ease : kEases) {
        const QString name = withoutKey(easeName(ease));
        auto* button = buttonFor<QToolButton>(
            this, "", {}, name, [this, ease] { m_choice.setProgress(progressOf(ease)); }, name);
        button->setIcon(curveIcon(progressOf(ease)));
        button->setCheckable(true);
        buttons->addWidget(button);
        m_presets.push_back(button);
    }
    auto* hold = buttonFor<QToolButton>(this, "easeHold", tr("Hold"),
                                        tr("The pin stays where it was, and goes on from there afterwards."),
                                        [this] { m_choice.holdEased(); });
    buttons->addWidget(hold);
    buttons->addStretch(1);
    m_presets.push_back(hold);
    return row;
}

/// Shows the first of the chosen motions.
void EaseEditor::takeChoice() {
    const auto motions = m_choice.easedMotions();
    std::optional<ShownProgress> shown;
    if (!motions.empty()) shown = shownProgress(m_choice.design(), motions.front());
    m_plot->setProgress(shown);
    m_what->setText(motions.empty()       ? tr("Choose a bar or a key in the tracks.")
                    : !shown->isFree      ? tr("Rotations and scalings have one of the four easings.")
                    : motions.size() == 1 ? tr("1 motion")
                                          : tr("%n motions", nullptr, static_cast<int>(motions.size())));
    for (QToolButton* button : m_presets) button->setEnabled(!motions.empty());
    for (ExactBox* box : {m_start, m_end}) box->setEnabled(shown && shown->isFree);
    showSpeeds(m_plot->curve());
}

void EaseEditor::showSpeeds(const Progress& curve) {
    m_start->put(kInPercent * curve.startSpeed());
    m_end->put(kInPercent * curve.endSpeed());
    for (std::size_t i = 0; i < kEases.size(); ++i)
        m_presets[i]->setChecked(m_presets[i]->isEnabled() && easeOf(curve) == kEases[i]);
}

void EaseEditor::typeSpeeds() {
    const Progress typed{m_start->exact() / (3 * kInPercent), 1 - m_end->exact() / (3 * kInPercent)};
    m_choice.setProgress(typed, QStringLiteral("ease numbers"));
}

}  // namespace wend
