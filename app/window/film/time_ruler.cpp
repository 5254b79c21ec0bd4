#include "app/window/film/time_ruler.h"

#include <QHelpEvent>
#include <QInputDialog>
#include <QLocale>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "app/base/connect_each.h"
#include "app/base/preferences.h"
#include "app/project/edits/film_edits.h"
#include "app/project/edits/setting_edits.h"
#include "app/style/theme.h"
#include "app/window/film/sound_track.h"
#include "app/window/film/time_strip.h"

namespace wend {

namespace {

constexpr int kNumbers = 22, kMarkers = 16, kLoudness = 26;  // heights of the rows
constexpr double kBand = 6;                                  // height of the cycle
constexpr double kHandle = 5;                                // pixels around an end of the cycle, or a marker
constexpr double kTickPixels = 64;                           // between numbers
constexpr double kHardlyHeard = 0.03;                        // amplitude of a sound

/// Returns 1, 2 or 5 times a power of ten, no less than `least`.
double roundStep(double least) {
    const double power = std::pow(10, std::floor(std::log10(least)));
    for (const double factor : {1, 2, 5})
        if (factor * power >= least) return factor * power;
    return 10 * power;
}

}  // namespace

TimeRuler::TimeRuler(Document& document, Playback& playback, TimeScale& scale, SoundTrack& sound,
                     QWidget* parent)
    : QWidget(parent), m_document(document), m_playback(playback), m_scale(scale), m_sound(sound) {
    setObjectName(QStringLiteral("timeRuler"));
    setMouseTracking(true);
    setAccessibleName(tr("Ruler"));
    setStatusTip(
        tr("Drag to show another time; with Shift, mark the part that a loop repeats. A right-click "
           "counts frames, sets the frame rate, and adds markers"));
    const auto arrange = [this] {
        m_drag = Drag::None;
        m_marker = -1;
        m_marks = filmMarksOf(m_document);
        if (std::exchange(m_rows, rows()) != m_rows) emit rowsChanged();
        update();
    };
    connectEach(this, arrange, &document, &Document::opened, &document, &Document::projectChanged, &sound,
                &SoundTrack::changed);
    connectEach(this, qOverload<>(&QWidget::update), &playback, &Playback::timeChanged, &playback,
                &Playback::endChanged, &scale, &TimeScale::changed);
    arrange();
}

int TimeRuler::rows() const {
    return kNumbers + (m_marks.markers.empty() ? 0 : kMarkers) + (m_sound.peaks().empty() ? 0 : kLoudness);
}

int TimeRuler::soundTop() const {
    return rows() - kLoudness;
}

/// Returns the cycle as it is dragged, or that of the project.
std::optional<std::array<double, 2>> TimeRuler::cycle() const {
    const auto [from, to] = m_marks.cycle.value_or(std::array{0.0, m_scale.end()});
    if (m_drag == Drag::NewCycle && m_now != m_pressed)
        return std::array{std::min(m_pressed, m_now), std::max(m_pressed, m_now)};
    if (m_drag == Drag::CycleStart && m_now < to) return std::array{m_now, to};
    if (m_drag == Drag::CycleEnd && m_now > from) return std::array{from, m_now};
    return m_marks.cycle;
}

double TimeRuler::markerTime(int marker) const {
    return m_drag == Drag::Marker && marker == m_marker ? m_now : m_marks.markers[marker].at;
}

QPointF TimeRuler::markerSpot(int marker) const {
    return {m_scale.xOf(markerTime(marker)), kNumbers + kMarkers / 2.0};
}

QPointF TimeRuler::cycleSpot(int end) const {
    return {m_scale.xOf(cycle().value_or(std::array{0.0, m_scale.end()})[end]), kBand / 2};
}

TimeRuler::Hit TimeRuler::hitAt(const QPointF& at) const {
    for (int i = static_cast<int>(m_marks.markers.size()) - 1; i >= 0 && at.y() >= kNumbers; --i)
        if (std::abs(markerSpot(i).x() - at.x()) <= kHandle && at.y() < kNumbers + kMarkers)
            return {Drag::Marker, i};
    if (m_marks.cycle && at.y() < kBand + 2)
        for (const int end : {1, 0})
            if (std::abs(cycleSpot(end).x() - at.x()) <= kHandle)
                return {end == 0 ? Drag::CycleStart : Drag::CycleEnd};
    return {at.x() >= m_scale.way().x() - kHandle ? Drag::Time : Drag::None};
}

double TimeRuler::snapped(double x) const {
    std::vector<double> marks = {0, m_scale.end()};
    if (m_drag != Drag::Time) marks.push_back(m_playback.time());
    for (int i = 0; i < static_cast<int>(m_marks.markers.size()); ++i)
        if (i != m_marker) marks.push_back(m_marks.markers[i].at);
    const double time = m_scale.timeAt(x);
    return std::clamp(m_drag == Drag::Time && !m_scale.countsFrames() ? time : m_scale.snapped(time, marks),
                      0.0, m_scale.end());
}

const Project& TimeRuler::project() const {
    return *m_document.project();
}

void TimeRuler::change(const QString& what, const std::shared_ptr<const Project>& next) {
    m_playback.setPlaying(false);
    m_document.change(what, next);
}

void TimeRuler::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_scale.end() <= 0) return;
    const Hit hit = hitAt(event->position());
    m_marker = hit.marker;
    m_drag = hit.drag == Drag::Time && event->modifiers() & Qt::ShiftModifier ? Drag::NewCycle : hit.drag;
    if (m_drag == Drag::None) return;
    m_pressed = m_now = snapped(event->position().x());
    if (m_drag == Drag::Time) mouseMoveEvent(event);
}

void TimeRuler::mouseMoveEvent(QMouseEvent* event) {
    if (m_drag == Drag::None) {
        const Drag over = hitAt(event->position()).drag;
        setCursor(over == Drag::None || over == Drag::Time ? Qt::ArrowCursor : Qt::SizeHorCursor);
        return;
    }
    m_now = snapped(event->position().x());
    if (m_drag == Drag::Time) {
        m_playback.setPlaying(false);
        const bool moves = m_playback.time() != m_now;
        m_playback.setTime(m_now);
        if (moves) m_sound.scrub(m_now);
    }
    update();
}

void TimeRuler::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_drag == Drag::None) return;
    const auto marked = cycle();
    const Drag drag = std::exchange(m_drag, Drag::None);
    const int marker = std::exchange(m_marker, -1);
    update();
    if (m_now == m_pressed || drag == Drag::Time) return;
    if (drag == Drag::Marker) return change(tr("Move marker"), withMarkerMoved(project(), marker, m_now));
    change(tr("Change cycle"), withCycle(project(), marked->at(0), marked->at(1)));
}

void TimeRuler::markCycle(int end) {
    markCycle(end, m_playback.time());
}

void TimeRuler::markCycle(int end, double time) {
    if (m_scale.end() <= 0) return;
    const double at = m_scale.onFrame(time);
    change(tr("Change cycle"), end == 0 ? withCycle(project(), at, {}) : withCycle(project(), {}, at));
}

void TimeRuler::addMarker() {
    addMarker(m_playback.time());
}

void TimeRuler::addMarker(double time) {
    if (m_scale.end() <= 0) return;
    change(tr("Add marker"), withMarker(project(), m_scale.onFrame(time), tr("Marker").toStdString()));
}

void TimeRuler::rename(int marker) {
    bool given = false;
    const QString name =
        QInputDialog::getText(window(), tr("Rename Marker"), tr("Name of the marker:"), QLineEdit::Normal,
                              QString::fromStdString(m_marks.markers[marker].name), &given);
    if (given) change(tr("Rename marker"), withMarkerNamed(project(), marker, name.trimmed().toStdString()));
}

void TimeRuler::mouseDoubleClickEvent(QMouseEvent* event) {
    if (const Hit hit = hitAt(event->position()); hit.marker >= 0) rename(hit.marker);
}

void TimeRuler::fillRates(QMenu& menu) {
    menu.setTitle(tr("Frame &Rate"));
    for (const double rate : {12, 15, 24, 25, 30, 50, 60}) {
        QAction* action = menu.addAction(tr("%1 fps").arg(rate), this,
                                         [this, rate] { changeSetting(m_document, "time.frameRate", rate); });
        action->setCheckable(true);
        action->setChecked(m_scale.rate() == rate);
    }
}

void TimeRuler::addCycleActions(QMenu& menu, double here) {
    menu.addAction(tr("Cycle &from Here") + QStringLiteral("\tI"), this, [=, this] { markCycle(0, here); });
    menu.addAction(tr("Cycle &to Here") + QStringLiteral("\tO"), this, [=, this] { markCycle(1, here); });
    menu.addAction(tr("&No Cycle"), this, [this] { change(tr("Remove cycle"), withoutCycle(project())); })
        ->setEnabled(m_marks.cycle.has_value());
}

/// Opens the menu. Its items act at the time under the pointer, their shortcuts at the time shown.
void TimeRuler::contextMenuEvent(QContextMenuEvent* event) {
    if (m_scale.end() <= 0 || m_drag != Drag::None) return;
    const bool isPlace = event->reason() == QContextMenuEvent::Mouse;
    const double here = isPlace ? snapped(event->pos().x()) : m_playback.time();
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    QAction* poses = menu->addAction(tr("Show Key &Poses"), this, [this](bool shown) {
        preferences::keyPosesShown.set(shown);
        emit rowsChanged();
    });
    poses->setCheckable(true);
    poses->setChecked(preferences::keyPosesShown.value());
    QAction* frames = menu->addAction(tr("&Count Frames"), &m_scale, &TimeScale::setCountsFrames);
    frames->setCheckable(true);
    frames->setChecked(m_scale.countsFrames());
    auto* rates = menu->addMenu(QString());
    fillRates(*rates);
    menu->addSeparator();
    addCycleActions(*menu, here);
    menu->addSeparator();
    menu->addAction(tr("Add &Marker") + QStringLiteral("\tShift+M"), this, [=, this] { addMarker(here); });
    if (const int marker = hitAt(event->pos()).marker; marker >= 0) {
        menu->addAction(tr("R&ename Marker…"), this, [this, marker] { rename(marker); });
        menu->addAction(tr("Re&move Marker"), this,
                        [this, marker] { change(tr("Remove marker"), withoutMarker(project(), marker)); });
    }
    if (m_sound.hasFile()) {
        menu->addSeparator();
        QAction* heard = menu->addAction(tr("Play the &Sound"), &m_sound, &SoundTrack::setHeard);
        heard->setCheckable(true);
        heard->setChecked(m_sound.isHeard());
    }
    menu->popup(event->globalPos());
}

bool TimeRuler::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const Hit hit = hitAt(help->pos());
    const auto now = cycle();
    if (hit.marker >= 0)
        QToolTip::showText(help->globalPos(),
                           tr("%1: %2").arg(QString::fromStdString(m_marks.markers[hit.marker].name),
                                            m_scale.text(markerTime(hit.marker))));
    else if (hit.drag == Drag::CycleStart || hit.drag == Drag::CycleEnd)
        QToolTip::showText(help->globalPos(),
                           tr("Cycle: %1 to %2").arg(m_scale.text(now->at(0)), m_scale.text(now->at(1))));
    else
        QToolTip::hideText();
    return true;
}

void TimeRuler::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    paintCycle(painter);
    paintTicks(painter);
    paintMarkers(painter);
    if (!m_sound.peaks().empty()) paintSound(painter);
    const Theme theme = Theme::of(palette());
    painter.setPen(theme.line);
    painter.drawLine(QPointF(0, height() - 0.5), QPointF(width(), height() - 0.5));
    const double now = m_scale.xOf(m_playback.time());
    painter.setPen(QPen(theme.accentText, 1.5));
    painter.drawLine(QPointF(now, kNumbers - 2), QPointF(now, height()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.accentText);
    painter.drawPolygon(
        QPolygonF({{now - 5, kNumbers - 9}, {now + 5, kNumbers - 9}, {now, double(kNumbers - 1)}}));
}

void TimeRuler::paintTicks(QPainter& painter) const {
    painter.setPen(Theme::of(palette()).secondText);
    const double unit = m_scale.countsFrames() ? 1 / m_scale.rate() : 1;
    const double least = kTickPixels * m_scale.end() / m_scale.way().width() / unit;
    const double step = m_scale.countsFrames() ? std::max(1.0, roundStep(least)) : roundStep(least);
    for (int i = 0; i * step * unit <= m_scale.end() * (1 + 1e-9); ++i) {
        const double x = m_scale.xOf(i * step * unit);
        painter.drawLine(QPointF(x, kNumbers - 5), QPointF(x, kNumbers - 1));
        painter.drawText(QRectF(x - 30, 0, 60, kNumbers - 5), Qt::AlignCenter,
                         QLocale().toString(i * step, 'g', 5));
    }
    const QRectF unitRect(4, 0, m_scale.way().x() - 40, kNumbers - 5);
    painter.drawText(unitRect, Qt::AlignVCenter | Qt::AlignLeft,
                     m_scale.countsFrames() ? tr("frames at %1 fps").arg(m_scale.rate()) : tr("seconds"));
}

void TimeRuler::paintCycle(QPainter& painter) const {
    const auto now = cycle();
    if (!now) return;
    const Theme theme = Theme::of(palette());
    const double from = m_scale.xOf(now->at(0)), to = m_scale.xOf(std::min(now->at(1), m_scale.end()));
    QColor ground = theme.accent;
    ground.setAlphaF(0.2F);
    painter.fillRect(QRectF(from, 0, to - from, height()), ground);
    painter.fillRect(QRectF(from, 0, to - from, 3), theme.accent);
    for (const double x : {from, to}) painter.fillRect(QRectF(x - 1.5, 0, 3, kBand + 2), theme.accentText);
}

void TimeRuler::paintMarkers(QPainter& painter) const {
    const Theme theme = Theme::of(palette());
    for (int i = 0; i < static_cast<int>(m_marks.markers.size()); ++i) {
        const QPointF at = markerSpot(i);
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme.warning);
        painter.drawPolygon(QPolygonF({at + QPointF(-4, -6), at + QPointF(4, -6), at + QPointF(4, 2),
                                       at + QPointF(0, 6), at + QPointF(-4, 2)}));
        painter.setPen(theme.secondText);
        painter.drawText(QRectF(at.x() + 7, kNumbers, 160, kMarkers), Qt::AlignVCenter | Qt::AlignLeft,
                         QString::fromStdString(m_marks.markers[i].name));
    }
}

/// Draws a line per pixel, as long as the sound is loud there beside its loudest place: that of a quiet
/// recording can be read, too, but not what is hardly heard.
void TimeRuler::paintSound(QPainter& painter) const {
    const auto& peaks = m_sound.peaks();
    const double middle = soundTop() + kLoudness / 2.0;
    const double most = std::max<double>(kHardlyHeard, *std::ranges::max_element(peaks));
    painter.setPen(Theme::of(palette()).secondText);
    const auto placeOf = [&](double x) {
        const double place = m_scale.timeAt(x) * Playback::kSecondsPerUnit / SoundTrack::kPeriod;
        return static_cast<std::size_t>(std::clamp(place, 0.0, double(peaks.size())));
    };
    for (int x = m_scale.way().left(); x <= m_scale.way().right(); ++x) {
        const std::size_t from = placeOf(x), to = std::max(placeOf(x + 1), from + 1);
        if (from >= peaks.size()) break;
        const float loudest =
            *std::max_element(peaks.begin() + static_cast<std::ptrdiff_t>(from),
                              peaks.begin() + static_cast<std::ptrdiff_t>(std::min(to, peaks.size())));
        const double half = std::max(0.5, loudest / most * (kLoudness / 2.0 - 2));
        painter.drawLine(QPointF(x + 0.5, middle - half), QPointF(x + 0.5, middle + half));
    }
}

}  // namespace wend
