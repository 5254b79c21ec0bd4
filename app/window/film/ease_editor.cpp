#include "app/window/film/ease_editor.h"

#include <QLabel>
#include <QPainter>
#include <QPixmap>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/panels/fields/ease_names.h"
#include "app/panels/fields/exact_box.h"
#include "app/panels/fields/panel_parts.h"
#include "app/window/film/ease_plot.h"
#include "app/window/film/track_view.h"

namespace wend {

namespace {

constexpr double kInPercent = 100;
constexpr int kEaseIcon = 20;  // pixels

}  // namespace

EaseEditor::EaseEditor(TrackView& tracks)
    : QDialog(&tracks, Qt::Tool),
      m_tracks(tracks),
      m_what(secondLabel({}, this)),
      m_plot(new EasePlot(this)),
      m_start(new ExactBox(this)),
      m_end(new ExactBox(this)) {
    setObjectName(QStringLiteral("easeEditor"));
    setWindowTitle(tr("Easing Curve"));
    makeSpeeds();
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_what);
    column->addWidget(m_plot, 1);
    column->addWidget(makePresets());
    column->addLayout(panelRow(tr("Speed at the &start"), m_start, this));
    column->addLayout(panelRow(tr("Speed at the &end"), m_end, this));
    connect(m_plot, &EasePlot::moved, this, &EaseEditor::showSpeeds);
    connect(m_plot, &EasePlot::changed, this, [this](const Progress& curve, bool byKey) {
        m_tracks.setProgress(curve, byKey ? QStringLiteral("ease keys") : QString());
    });
    connect(&m_tracks, &TrackView::choiceChanged, this, &EaseEditor::takeChoice);
    takeChoice();
}

void EaseEditor::makeSpeeds() {
    for (ExactBox* box : {m_start, m_end}) {
        box->setRange(3 * EasePlot::kLow * kInPercent, 3 * EasePlot::kHigh * kInPercent);
        box->setDecimals(0);
        box->setSingleStep(10);
        box->setSuffix(tr(" %"));
        box->setKeyboardTracking(false);
        connect(box, &QDoubleSpinBox::valueChanged, this, &EaseEditor::typeSpeeds);
    }
    const QString help = tr("In percent of the speed of an even move: at 0 % the pin stops there.");
    describe(m_start, tr("Speed at the start"), help);
    describe(m_end, tr("Speed at the end"), help);
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
        auto* button = new QToolButton(row);
        button->setIcon(curveIcon(progressOf(ease)));
        button->setCheckable(true);
        describe(button, withoutKey(easeName(ease)), withoutKey(easeName(ease)));
        connect(button, &QToolButton::clicked, this,
                [this, ease] { m_tracks.setProgress(progressOf(ease)); });
        buttons->addWidget(button);
        m_presets.push_back(button);
    }
    auto* hold = new QToolButton(row);
    hold->setObjectName(QStringLiteral("easeHold"));
    hold->setText(tr("Hold"));
    describe(hold, tr("Hold"), tr("The pin stays where it was, and goes on from there afterwards."));
    connect(hold, &QToolButton::clicked, &m_tracks, &TrackView::holdChosen);
    buttons->addWidget(hold);
    buttons->addStretch(1);
    m_presets.push_back(hold);
    return row;
}

/// Shows the first of the chosen motions.
void EaseEditor::takeChoice() {
    const auto motions = m_tracks.easedMotions();
    const auto shown = m_tracks.shownEase();
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
    m_tracks.setProgress(typed, QStringLiteral("ease numbers"));
}

}  // namespace wend
