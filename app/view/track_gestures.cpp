// What mouse and keys do to the bars of the tracks.

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QLocale>
#include <QMenu>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "app/document/project.h"
#include "app/panels/ease_names.h"
#include "app/panels/panel_parts.h"
#include "app/view/track_view.h"

namespace wend {

namespace {

constexpr double kSnap = 6;     // pixels to other ends, and to the time that is shown
constexpr double kDragged = 3;  // pixels before a press is a drag
constexpr double kStep = 0.04;  // seconds, of a key

QString seconds(double time) {
    return QLocale().toString(time, 'f', 2);
}

}  // namespace

/// The nearest end of another bar, or what is shown, within reach.
double TrackView::snapped(double time, const Bar& own) const {
    std::vector<double> marks = {0, end(), m_session.playback().time()};
    for (const Row& row : m_rows)
        for (const Bar& bar : row.bars)
            if (!(bar == own)) marks.insert(marks.end(), {bar.time.start, bar.time.end});
    double best = time, reach = kSnap;
    for (const double mark : marks)
        if (const double d = std::abs(xOf(mark) - xOf(time)); d < reach) reach = d, best = mark;
    return best;
}

/// It reaches over its motions.
MotionTime TrackView::draggedHold(const Grabbed& grabbed, double time) const {
    const Bar& bar = grabbed.bar;
    const auto& bars = m_rows[static_cast<std::size_t>(bar.handle)].bars;
    const double start = std::max(bar.time.start, 0.0), to = std::min(bar.time.end, end());
    const double way = time - grabbed.at;
    const double latest = bars.empty() ? to - kShortestMotion : bars.front().time.start;
    const double earliest = bars.empty() ? start + kShortestMotion : std::min(bars.back().time.end, end());
    if (grabbed.part == Part::Start)
        return {std::clamp(snapped(start + way, bar), 0.0, std::max(latest, 0.0)), bar.time.end};
    return {bar.time.start, std::clamp(snapped(to + way, bar), std::min(earliest, end()), end())};
}

MotionTime TrackView::dragged(const Grabbed& grabbed, double time) const {
    const Bar& bar = grabbed.bar;
    if (bar.motion == kHold) return draggedHold(grabbed, time);
    const MotionTime room = roomOf(m_session.document().design(), bar.handle, bar.motion);
    const double way = time - grabbed.at;
    if (grabbed.part == Part::Start)
        return {std::clamp(snapped(bar.time.start + way, bar), room.start,
                           std::max(bar.time.end - kShortestMotion, room.start)),
                bar.time.end};
    if (grabbed.part == Part::End)
        return {bar.time.start, std::clamp(snapped(bar.time.end + way, bar), bar.time.start + kShortestMotion,
                                           std::max(room.end, bar.time.start + kShortestMotion))};
    const double length = bar.time.end - bar.time.start;
    const double toStart = snapped(bar.time.start + way, bar), toEnd = snapped(bar.time.end + way, bar);
    const bool byEnd = toEnd != bar.time.end + way && toStart == bar.time.start + way;
    const double start =
        std::clamp(byEnd ? toEnd - length : toStart, room.start, std::max(room.end - length, room.start));
    return {start, start + length};
}

void TrackView::change(const QString& what, AnyDesign after) {
    m_session.playback().setPlaying(false);
    m_session.document().changeDesign(what, std::move(after));
}

void TrackView::move(const Bar& bar, const MotionTime& time, const QString& what, const QString& key) {
    if (time == bar.time) return;
    m_session.playback().setPlaying(false);
    Document& document = m_session.document();
    document.change(what, withMotionTime(*document.project(), bar.handle, bar.motion, time), key);
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
    const auto hit = barAt(at);
    m_chosen = hit && hit->first.motion != kHold ? std::optional(hit->first) : std::nullopt;
    if (const int row = rowAt(at); row >= 0) m_session.selection().set({row});
    if (!hit) return viewport()->update();
    if (m_session.mayChange(hit->first.handle))
        m_grabbed = Grabbed{hit->first, hit->second, timeAt(at.x()), hit->first.time};
    viewport()->update();
}

void TrackView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    if (m_scrubbing) return scrub(at.x());
    if (m_grabbed) {
        const bool moves =
            m_grabbed->time != m_grabbed->bar.time || std::abs(at.x() - xOf(m_grabbed->at)) >= kDragged;
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
    if (const auto grabbed = std::exchange(m_grabbed, std::nullopt)) drop(*grabbed);
    viewport()->update();
}

void TrackView::drop(const Grabbed& grabbed) {
    const Bar& bar = grabbed.bar;
    if (bar.motion != kHold)
        return move(bar, grabbed.time,
                    grabbed.part == Part::Body ? tr("Move in time") : tr("Change duration"));
    if (grabbed.time == bar.time) return;
    change(tr("Change when it holds"),
           withHold(m_session.document().design(), bar.handle, grabbed.time, m_session.document().end()));
}

void TrackView::contextMenuEvent(QContextMenuEvent* event) {
    const auto hit = barAt(event->pos());
    if (!hit || hit->first.motion == kHold || m_grabbed) return;
    m_chosen = hit->first;
    m_session.selection().set({hit->first.handle});
    showMenu(hit->first, event->globalPos());
}

void TrackView::showMenu(const Bar& bar, const QPoint& global) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addSection(tr("How it begins and ends"));
    for (const Ease ease : kEases) {
        QAction* action = menu->addAction(easeName(ease), this, [this, bar, ease] {
            if (!m_session.mayChange(bar.handle)) return;
            change(tr("Ease"), withMotionEase(m_session.document().design(), bar.handle, bar.motion, ease));
        });
        action->setCheckable(true);
        action->setChecked(bar.ease == ease);
    }
    menu->addSeparator();
    menu->addAction(tr("&Remove Motion"), this, [this, bar] { remove(bar); });
    menu->popup(global);
}

void TrackView::remove(const Bar& bar) {
    if (!m_session.mayChange(bar.handle)) return;
    change(tr("Remove motion"), withoutMotion(m_session.document().design(), bar.handle, bar.motion));
}

/// Delete goes for the bar that is chosen, not for its pin.
bool TrackView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && m_chosen &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
        event->accept();
        return true;
    }
    return QAbstractScrollArea::event(event);
}

/// Left and Right move the chosen bar with Alt, else what is shown.
bool TrackView::nudge(const QKeyEvent& event) {
    const double way = event.key() == Qt::Key_Left ? -kStep : event.key() == Qt::Key_Right ? kStep : 0;
    if (way == 0) return false;
    if (!(event.modifiers() & Qt::AltModifier)) {
        m_session.playback().setPlaying(false);
        m_session.playback().setTime(m_session.playback().time() + way);
    } else if (m_chosen && m_session.mayChange(m_chosen->handle)) {
        const Bar bar = m_rows[static_cast<std::size_t>(m_chosen->handle)]
                            .bars[static_cast<std::size_t>(m_chosen->motion)];
        move(bar, {bar.time.start + way, bar.time.end + way}, tr("Move in time"),
             QStringLiteral("track %1 %2").arg(bar.handle).arg(bar.motion));
    }
    return true;
}

void TrackView::keyPressEvent(QKeyEvent* event) {
    const int step = event->key() == Qt::Key_Up ? -1 : event->key() == Qt::Key_Down ? 1 : 0;
    if (nudge(*event)) return;
    if (event->key() == Qt::Key_Delete && m_chosen) return remove(*m_chosen);
    if (event->key() == Qt::Key_Escape && m_grabbed) {
        m_grabbed.reset();
        return viewport()->update();
    }
    if (step == 0 || m_rows.empty()) return QAbstractScrollArea::keyPressEvent(event);
    const int last = static_cast<int>(m_rows.size()) - 1, now = m_session.singleHandle();
    const int next = std::clamp(now < 0 ? 0 : now + step, 0, last);
    m_session.selection().set({next});
    const auto& bars = m_rows[static_cast<std::size_t>(next)].bars;
    m_chosen = bars.empty() ? std::nullopt : std::optional(bars.front());
}

/// What a bar is, and when.
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
