// Mouse and key gestures on the bars of the tracks.

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QLocale>
#include <QMenu>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "app/document/project.h"
#include "app/panels/fields/ease_names.h"
#include "app/panels/fields/panel_parts.h"
#include "app/view/film/track_view.h"

namespace wend {

namespace {

constexpr double kSnap = 6;     // pixels to other ends, and to the time that is shown
constexpr double kDragged = 3;  // pixels before a press is a drag
constexpr double kStep = 0.04;  // seconds, of a key

QString seconds(double time) {
    return QLocale().toString(time, 'f', 2);
}

}  // namespace

/// Snaps to the nearest end of another bar, or to the shown time, within reach.
double TrackView::snapped(double time, const std::vector<MotionId>& own) const {
    std::vector<double> marks = {0, end(), m_session.playback().time()};
    for (const Row& row : m_rows)
        for (const Bar& bar : row.bars)
            if (!isAmong(own, bar)) marks.insert(marks.end(), {bar.time.start, bar.time.end});
    double best = time, reach = kSnap;
    for (const double mark : marks)
        if (const double d = std::abs(xOf(mark) - xOf(time)); d < reach) reach = d, best = mark;
    return best;
}

/// The hold covers the handle's motions.
MotionTime TrackView::draggedHold(const Grabbed& grabbed, double time) const {
    const Bar& bar = grabbed.bar;
    const auto& bars = m_rows[static_cast<std::size_t>(bar.handle)].bars;
    const double start = std::max(bar.time.start, 0.0), to = std::min(bar.time.end, end());
    const double way = time - grabbed.at;
    const double latest = bars.empty() ? to - kShortestMotion : bars.front().time.start;
    const double earliest = bars.empty() ? start + kShortestMotion : std::min(bars.back().time.end, end());
    if (grabbed.part == Part::Start)
        return {std::clamp(snapped(start + way), 0.0, std::max(latest, 0.0)), bar.time.end};
    return {bar.time.start, std::clamp(snapped(to + way), std::min(earliest, end()), end())};
}

/// Moves grabbed bars with the pointer; by an end, scales all of them from the opposite end.
MotionTime TrackView::dragged(const Grabbed& grabbed, double time) const {
    if (grabbed.bar.motion == kHold) return draggedHold(grabbed, time);
    const auto& [start, end] = grabbed.bar.time;
    const MotionTime& span = grabbed.span;
    const double way = time - grabbed.at;
    const double toStart = snapped(start + way, grabbed.motions), toEnd = snapped(end + way, grabbed.motions);
    MotionTime wanted = span;
    if (grabbed.part == Part::Start) {
        wanted.start = std::lerp(span.end, toStart, (span.end - span.start) / (span.end - start));
    } else if (grabbed.part == Part::End) {
        wanted.end = std::lerp(span.start, toEnd, (span.end - span.start) / (end - span.start));
    } else {
        const bool byEnd = toEnd != end + way && toStart == start + way;
        wanted.start = byEnd ? toEnd - (end - span.start) : toStart - (start - span.start);
        wanted.end = wanted.start + (span.end - span.start);
    }
    return fittedSpan(m_session.document().design(), grabbed.motions, wanted);
}

void TrackView::change(const QString& what, AnyDesign after) {
    m_session.playback().setPlaying(false);
    m_session.document().changeDesign(what, std::move(after));
}

void TrackView::move(const std::vector<MotionId>& motions, const MotionTime& span, const QString& what,
                     const QString& key) {
    m_session.playback().setPlaying(false);
    Document& document = m_session.document();
    document.change(what, withMotionSpan(*document.project(), motions, span), key);
}

/// Also selects the handles of the bars.
void TrackView::choose(std::vector<MotionId> bars) {
    m_chosen = std::move(bars);
    std::vector<int> pins;
    for (const MotionId& bar : m_chosen) pins.push_back(bar.handle);
    m_session.selection().set(std::move(pins));
    viewport()->update();
}

/// Returns the chosen bars whose pins are not locked.
std::vector<MotionId> TrackView::changeable() const {
    std::vector<MotionId> motions = m_chosen;
    std::erase_if(motions, [this](const MotionId& id) { return !m_session.mayChange(id.handle); });
    return motions;
}

void TrackView::scrub(double x) {
    m_session.playback().setPlaying(false);
    m_session.playback().setTime(timeAt(x));
}

void TrackView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    const QPointF at = event->position();
    if (at.y() < kRuler && at.x() >= m_way.x() - kGrip) {
        m_scrubbing = true;
        return scrub(at.x());
    }
    const bool joins = event->modifiers() & (Qt::ShiftModifier | Qt::ControlModifier);
    const auto hit = barAt(at);
    if (hit && hit->first.motion != kHold) {
        const Bar& bar = hit->first;
        const bool among = isChosen(bar);
        std::vector<MotionId> next = joins || among ? m_chosen : std::vector<MotionId>();
        if (joins && among)
            std::erase(next, bar);
        else if (!among)
            next.push_back(bar);
        choose(std::move(next));
        if (isChosen(bar)) grab(bar, hit->second, timeAt(at.x()), among && !joins);
        return;
    }
    if (!joins) m_chosen.clear();
    if (const int row = rowAt(at); row >= 0)
        joins ? m_session.selection().toggle(row) : m_session.selection().set({row});
    if (hit)
        grab(hit->first, hit->second, timeAt(at.x()), false);
    else
        m_band = Band{at, at, m_chosen};
    viewport()->update();
}

void TrackView::grab(const Bar& bar, Part part, double at, bool alone) {
    const bool isMotion = bar.motion != kHold;
    if (!m_session.mayChange(bar.handle)) return;
    const auto motions = isMotion ? changeable() : std::vector<MotionId>();
    const MotionTime span = isMotion ? spanOf(m_session.document().design(), motions) : bar.time;
    m_grabbed = Grabbed{bar, part, at, motions, span, span, alone};
}

/// Adds touched bars to the earlier choice.
void TrackView::stretchBand(const QPointF& to) {
    m_band->to = to;
    m_chosen = m_band->others;
    const QRectF frame = QRectF(m_band->from, to).normalized();
    for (const Row& row : m_rows)
        for (const Bar& bar : row.bars)
            if (barRect(bar).intersects(frame) && !isChosen(bar)) m_chosen.push_back(bar);
    viewport()->update();
}

void TrackView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    if (m_scrubbing) return scrub(at.x());
    if (m_band) return stretchBand(at);
    if (m_grabbed) {
        const bool moves =
            m_grabbed->time != m_grabbed->span || std::abs(at.x() - xOf(m_grabbed->at)) >= kDragged;
        if (moves) m_grabbed->time = dragged(*m_grabbed, timeAt(at.x()));
        return viewport()->update();
    }
    const auto hit = barAt(at);
    viewport()->setCursor(!hit                        ? Qt::ArrowCursor
                          : hit->second == Part::Body ? Qt::OpenHandCursor
                                                      : Qt::SizeHorCursor);
}

void TrackView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    m_scrubbing = false;
    const auto band = std::exchange(m_band, std::nullopt);
    if (band && m_chosen != band->others) choose(m_chosen);
    if (const auto grabbed = std::exchange(m_grabbed, std::nullopt)) drop(*grabbed);
    viewport()->update();
}

void TrackView::drop(const Grabbed& grabbed) {
    const Bar& bar = grabbed.bar;
    if (grabbed.time == grabbed.span) {
        if (grabbed.alone) choose({bar});
    } else if (bar.motion != kHold) {
        move(grabbed.motions, grabbed.time,
             grabbed.part == Part::Body ? tr("Move in time") : tr("Change duration"));
    } else {
        change(tr("Change when it holds"),
               withHold(m_session.document().design(), bar.handle, grabbed.time, m_session.document().end()));
    }
}

void TrackView::contextMenuEvent(QContextMenuEvent* event) {
    const auto hit = barAt(event->pos());
    if (!hit || hit->first.motion == kHold || m_grabbed) return;
    if (!isChosen(hit->first)) choose({hit->first});
    showMenu(hit->first, event->globalPos());
}

void TrackView::showMenu(const Bar& bar, const QPoint& global) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addSection(tr("Easing"));
    for (const Ease ease : kEases) {
        QAction* action = menu->addAction(easeName(ease), this, [this, ease] {
            if (const auto motions = changeable(); !motions.empty())
                change(tr("Change easing"), withMotionEase(m_session.document().design(), motions, ease));
        });
        action->setCheckable(true);
        action->setChecked(bar.ease == ease);
    }
    menu->addSeparator();
    menu->addAction(m_chosen.size() > 1 ? tr("&Remove Motions") : tr("&Remove Motion"), this,
                    &TrackView::removeChosen);
    menu->popup(global);
}

void TrackView::removeChosen() {
    const auto motions = changeable();
    if (motions.empty()) return;
    if (m_chosen.size() > 1) m_chosen.clear();  // a single one is replaced by the next
    change(motions.size() > 1 ? tr("Remove motions") : tr("Remove motion"),
           withoutMotions(m_session.document().design(), motions));
}

/// Delete is for the bars that are chosen, not for their pins.
bool TrackView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && !m_chosen.empty() &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
        event->accept();
        return true;
    }
    return QAbstractScrollArea::event(event);
}

/// Moves the chosen bars by Left and Right with Alt, otherwise the shown time.
bool TrackView::nudge(const QKeyEvent& event) {
    const double way = event.key() == Qt::Key_Left ? -kStep : event.key() == Qt::Key_Right ? kStep : 0;
    if (way == 0) return false;
    if (!(event.modifiers() & Qt::AltModifier)) {
        m_session.playback().setPlaying(false);
        m_session.playback().setTime(m_session.playback().time() + way);
    } else if (const auto motions = changeable(); !motions.empty()) {
        QString key = QStringLiteral("track");
        for (const MotionId& id : motions) key += QStringLiteral(" %1 %2").arg(id.handle).arg(id.motion);
        const MotionTime span = spanOf(m_session.document().design(), motions);
        move(motions, {span.start + way, span.end + way}, tr("Move in time"), key);
    }
    return true;
}

void TrackView::keyPressEvent(QKeyEvent* event) {
    const int step = event->key() == Qt::Key_Up ? -1 : event->key() == Qt::Key_Down ? 1 : 0;
    if (nudge(*event)) return;
    if (event->key() == Qt::Key_Delete && !m_chosen.empty()) return removeChosen();
    if (event->key() == Qt::Key_Escape && (m_grabbed || m_band)) {
        if (m_band) m_chosen = m_band->others;
        m_grabbed.reset();
        m_band.reset();
        return viewport()->update();
    }
    if (step == 0 || m_rows.empty()) return QAbstractScrollArea::keyPressEvent(event);
    const int last = static_cast<int>(m_rows.size()) - 1, now = m_session.singleHandle();
    const int next = std::clamp(now < 0 ? 0 : now + step, 0, last);
    m_session.selection().set({next});
    const auto& bars = m_rows[static_cast<std::size_t>(next)].bars;
    m_chosen.assign(bars.begin(), bars.begin() + (bars.empty() ? 0 : 1));
}

/// Shows the name and times of a bar.
bool TrackView::viewportEvent(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QAbstractScrollArea::viewportEvent(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const auto hit = barAt(help->pos());
    if (!hit) {
        QToolTip::hideText();
        return true;
    }
    const MotionTime time = timeOf(hit->first);
    if (hit->first.motion == kHold)
        QToolTip::showText(help->globalPos(),
                           tr("Holds from %1 to %2 s").arg(seconds(time.start), seconds(time.end)));
    else
        QToolTip::showText(help->globalPos(), tr("%1: %2 to %3 s, %4")
                                                  .arg(hit->first.kind, seconds(hit->first.time.start),
                                                       seconds(hit->first.time.end),
                                                       withoutKey(easeName(hit->first.ease)).toLower()));
    return true;
}

}  // namespace wend
