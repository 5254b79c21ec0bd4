#include "app/window/film/time_strip.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QToolButton>
#include <cmath>

#include "app/base/connect_each.h"
#include "app/base/preferences.h"
#include "app/panels/fields/controls.h"
#include "app/panels/fields/jump_slider.h"
#include "app/panels/fields/panel_parts.h"
#include "app/project/edits/film_edits.h"
#include "app/session/shape_motion.h"
#include "app/style/theme.h"
#include "app/window/film/sound_track.h"
#include "app/window/film/track_view.h"
#include "core/integration/integration_options.h"

namespace wend {

namespace {

constexpr double kSnapReach = 6;     // pixels, of what snaps
constexpr double kArrowStep = 0.04;  // seconds, of an arrow key

constexpr int kSteps = 10000;
constexpr double kShortest = 0.1, kLongest = 600;  // seconds

}  // namespace

TimeScale::TimeScale(Document& document, Playback& playback, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_playback(playback),
      m_countsFrames(preferences::rulerInFrames.value()) {}

void TimeScale::setWay(const QRect& way) {
    m_way = way;
    emit changed();
}

double TimeScale::end() const {
    return m_playback.end();
}

double TimeScale::xOf(double time) const {
    return m_way.x() + (end() > 0 ? time / end() * m_way.width() : 0);
}

double TimeScale::timeAt(double x) const {
    return (x - m_way.x()) / m_way.width() * end();
}

double TimeScale::rate() const {
    return filmMarksOf(m_document).frameRate;
}

void TimeScale::setCountsFrames(bool counts) {
    m_countsFrames = counts;
    preferences::rulerInFrames.set(counts);
    emit changed();
}

double TimeScale::onFrame(double time) const {
    return m_countsFrames ? std::round(time * rate()) / rate() : time;
}

double TimeScale::step() const {
    return m_countsFrames ? 1 / rate() : kArrowStep;
}

double TimeScale::snapped(double time, const std::vector<double>& marks) const {
    double best = onFrame(time), reach = kSnapReach;
    for (const double mark : marks)
        if (const double d = std::abs(xOf(mark) - xOf(time)); d < reach) reach = d, best = mark;
    return best;
}

QString TimeScale::text(double time) const {
    const QLocale locale;
    return m_countsFrames ? tr("frame %1").arg(locale.toString(time * rate(), 'g', 5))
                          : tr("%1 s").arg(locale.toString(time, 'f', 2));
}

TimeStrip::TimeStrip(Document& document, Playback& playback, const ShapeMotion& motion,
                     const TrackView& tracks, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_playback(playback),
      m_motion(motion),
      m_tracks(tracks),
      m_play(new QToolButton(this)),
      m_loop(new QToolButton(this)),
      m_slider(new JumpSlider(this)),
      m_label(new QLabel(this)),
      m_length(numberBox(this, "", tr("Length"),
                         tr("How long the film is. The poses stay as they are, however fast it goes."),
                         {kShortest, kLongest, 2, 0.5, tr(" s")}, &TimeStrip::changeLength)) {
    setObjectName(QStringLiteral("timeStrip"));
    setAttribute(Qt::WA_StyledBackground);
    m_slider->setRange(0, kSteps);
    m_slider->setPageStep(kSteps / 10);
    describe(m_slider, tr("Time"), tr("Which moment of the motion is shown."));
    m_loop->setCheckable(true);
    m_label->setProperty("role", "second");
    m_label->setMinimumWidth(m_label->fontMetrics().horizontalAdvance(QStringLiteral("00.00 / ")));
    m_label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_length->setKeyboardTracking(false);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 5, 16, 5);
    row->setSpacing(6);
    for (QToolButton* button : {m_play, m_loop}) {
        button->setIconSize({20, 20});
        row->addWidget(button);
    }
    row->addWidget(m_label);
    row->addWidget(m_length);
    row->addSpacing(4);
    row->addWidget(m_slider, 1);
    m_slider->installEventFilter(this);
    connect(m_slider, &QSlider::valueChanged, this, [this](int value) {
        m_playback.setTime(m_playback.end() * value / kSteps);
        if (m_slider->isSliderDown()) m_tracks.sound().scrub(m_playback.time());
    });
    connect(m_slider, &QSlider::sliderPressed, this, [this] { m_playback.setPlaying(false); });
    connect(&playback, &Playback::endChanged, this, &TimeStrip::showEnd);
    connect(&playback, &Playback::timeChanged, this, &TimeStrip::showTime);
    connectEach(this, &TimeStrip::showLength, &document, &Document::opened, &document,
                &Document::projectChanged);
    connect(&motion, &ShapeMotion::progress, this, [this](double time) {
        m_computed = time;
        update();
    });
    connect(&motion, &ShapeMotion::busyChanged, this, qOverload<>(&QWidget::update));
    showEnd(playback.end());
    showLength();
}

QSlider* TimeStrip::slider() const {
    return m_slider;
}

QRect TimeStrip::way() const {
    return m_slider->way().translated(m_slider->pos());
}

bool TimeStrip::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize || event->type() == QEvent::Move) m_tracks.scale().setWay(way());
    return QWidget::eventFilter(watched, event);
}

void TimeStrip::showLength() {
    m_length->setEnabled(!m_document.isEmpty());
    if (!m_document.isEmpty()) m_length->put(m_document.end());
}

void TimeStrip::changeLength() {
    if (m_document.isEmpty() || m_length->exact() == m_document.end()) return;
    wend::changeLength(m_document, tr("Change length"), m_length->exact());
}

void TimeStrip::showEnd(double end) {
    m_slider->setEnabled(end > 0);
    m_slider->setToolTip(end > 0 ? tr("Which moment of the motion is shown.")
                                 : tr("Nothing moves yet: drag a pin."));
    m_computed = 0;
    showTime();
}

void TimeStrip::showTime() {
    const double time = m_playback.time(), end = m_playback.end();
    const QSignalBlocker quiet(m_slider);
    m_slider->setValue(end > 0 ? static_cast<int>(std::lround(kSteps * time / end)) : 0);
    m_label->setText(end > 0 ? tr("%1 /").arg(QLocale().toString(time, 'f', 2)) : tr("Drag a pin to begin"));
}

void TimeStrip::paintEvent(QPaintEvent*) {
    const double end = m_playback.end();
    if (end <= 0 || m_document.isEmpty()) return;
    QPainter painter(this);
    paintSettling(painter, end);
    if (!m_motion.isBusy()) return;
    const double part = std::clamp(m_computed / end, 0.0, 1.0);
    painter.fillRect(QRectF(0, 0, width() * part, 2), Theme::of(palette()).accent);
}

/// Draws a band behind the slider where the shape relaxes.
void TimeStrip::paintSettling(QPainter& painter, double end) {
    QColor band = Theme::of(palette()).accent;
    band.setAlphaF(0.25);
    const QRectF groove = way();
    for (const SettleWindow& window : settlingOf(*m_document.project())) {
        const double from = groove.width() * window.start / end, to = groove.width() * window.end / end;
        painter.fillRect(QRectF(groove.left() + from, m_slider->y() + 2, to - from, m_slider->height() - 4),
                         band);
    }
}

}  // namespace wend
