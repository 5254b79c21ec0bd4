#include "app/window/film/time_strip.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QToolButton>
#include <cmath>

#include "app/panels/fields/jump_slider.h"
#include "app/panels/fields/number_boxes.h"
#include "app/panels/fields/panel_parts.h"
#include "app/project/edits/film_edits.h"
#include "app/style/theme.h"
#include "core/integration/integration_options.h"

namespace wend {

namespace {

constexpr int kSteps = 10000;
constexpr double kShortest = 0.1, kLongest = 600;  // seconds

}  // namespace

TimeStrip::TimeStrip(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_play(new QToolButton(this)),
      m_loop(new QToolButton(this)),
      m_slider(new JumpSlider(this)),
      m_label(new QLabel(this)),
      m_length(new ExactBox(this)) {
    setObjectName(QStringLiteral("timeStrip"));
    setAttribute(Qt::WA_StyledBackground);
    m_slider->setRange(0, kSteps);
    m_slider->setPageStep(kSteps / 10);
    describe(m_slider, tr("Time"), tr("Which moment of the motion is shown."));
    m_loop->setCheckable(true);
    m_label->setProperty("role", "second");
    m_label->setMinimumWidth(m_label->fontMetrics().horizontalAdvance(QStringLiteral("00.00 / ")));
    m_label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    makeLength();
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

    Playback& playback = m_session.playback();
    connect(m_slider, &QSlider::valueChanged, this,
            [&playback](int value) { playback.setTime(playback.end() * value / kSteps); });
    connect(m_slider, &QSlider::sliderPressed, &playback, [&playback] { playback.setPlaying(false); });
    connect(&playback, &Playback::endChanged, this, &TimeStrip::showEnd);
    connect(&playback, &Playback::timeChanged, this, &TimeStrip::showTime);
    connect(&playback, &Playback::playingChanged, this, &TimeStrip::showPlaying);
    connect(&m_session.document(), &Document::opened, this, &TimeStrip::showLength);
    connect(&m_session.document(), &Document::projectChanged, this, &TimeStrip::showLength);
    connect(&m_session.motion(), &ShapeMotion::progress, this, [this](double time) {
        m_computed = time;
        update();
    });
    connect(&m_session.motion(), &ShapeMotion::busyChanged, this, qOverload<>(&QWidget::update));
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
    if (event->type() == QEvent::Resize || event->type() == QEvent::Move) emit wayChanged();
    return QWidget::eventFilter(watched, event);
}

void TimeStrip::makeLength() {
    m_length->setRange(kShortest, kLongest);
    m_length->setDecimals(2);
    m_length->setSingleStep(0.5);
    m_length->setSuffix(tr(" s"));
    m_length->setKeyboardTracking(false);
    describe(m_length, tr("Length"),
             tr("How long the film is. The poses stay as they are, however fast it goes."));
    connect(m_length, &QDoubleSpinBox::valueChanged, this, &TimeStrip::changeLength);
}

void TimeStrip::showLength() {
    const Document& document = m_session.document();
    m_length->setEnabled(!document.isEmpty());
    if (!document.isEmpty()) m_length->put(document.end());
}

void TimeStrip::changeLength() {
    Document& document = m_session.document();
    if (document.isEmpty() || m_length->exact() == document.end()) return;
    wend::changeLength(document, tr("Change length"), m_length->exact());
}

void TimeStrip::setIcons(const QIcon& play, const QIcon& pause, const QIcon& loop) {
    m_playIcon = play;
    m_pauseIcon = pause;
    m_loop->setIcon(loop);
    showPlaying(m_session.playback().isPlaying());
}

void TimeStrip::showEnd(double end) {
    m_slider->setEnabled(end > 0);
    m_slider->setToolTip(end > 0 ? tr("Which moment of the motion is shown.")
                                 : tr("Nothing moves yet: drag a pin."));
    m_computed = 0;
    showTime();
}

void TimeStrip::showTime() {
    const Playback& playback = m_session.playback();
    const QSignalBlocker quiet(m_slider);
    m_slider->setValue(
        playback.end() > 0 ? static_cast<int>(std::lround(kSteps * playback.time() / playback.end())) : 0);
    const QLocale locale;
    m_label->setText(playback.end() > 0 ? tr("%1 /").arg(locale.toString(playback.time(), 'f', 2))
                                        : tr("Drag a pin to begin"));
}

void TimeStrip::showPlaying(bool playing) {
    m_play->setIcon(playing ? m_pauseIcon : m_playIcon);
}

void TimeStrip::paintEvent(QPaintEvent*) {
    const double end = m_session.playback().end();
    if (end <= 0 || m_session.document().isEmpty()) return;
    QPainter painter(this);
    paintSettling(painter, end);
    if (!m_session.motion().isBusy()) return;
    const double part = std::clamp(m_computed / end, 0.0, 1.0);
    painter.fillRect(QRectF(0, 0, width() * part, 2), Theme::of(palette()).accent);
}

/// Draws a band behind the slider where the shape relaxes.
void TimeStrip::paintSettling(QPainter& painter, double end) {
    QColor band = Theme::of(palette()).accent;
    band.setAlphaF(0.25);
    const QRectF groove = way();
    for (const SettleWindow& window : settlingOf(*m_session.document().project())) {
        const double from = groove.width() * window.start / end, to = groove.width() * window.end / end;
        painter.fillRect(QRectF(groove.left() + from, m_slider->y() + 2, to - from, m_slider->height() - 4),
                         band);
    }
}

}  // namespace wend
