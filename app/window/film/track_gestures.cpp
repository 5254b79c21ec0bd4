// Mouse and key gestures on the bars of the tracks.

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "app/panels/fields/ease_names.h"
#include "app/panels/fields/panel_parts.h"
#include "app/project/edits/film_edits.h"
#include "app/project/edits/key_edits.h"
#include "app/project/project.h"
#include "app/window/film/time_strip.h"
#include "app/window/film/track_view.h"

namespace wend {

namespace {

constexpr double kDragged = 3;  // pixels before a press is a drag

}  // namespace

/// Snaps to the nearest key that does not move along, to the shown time or a marker within reach, or a frame.
double TrackView::snapped(double time, const std::vector<KeyId>& moving) const {
    std::vector<double> marks = {0, end(), m_session.playback().time()};
    for (const FilmMarks::Marker& marker : filmMarksOf(m_session.document()).markers)
        marks.push_back(marker.at);
    for (int row = 0; row < static_cast<int>(m_rows.size()); ++row)
        for (const Bar& bar : m_rows[static_cast<std::size_t>(row)].bars)
            for (const double key : {bar.time.start, bar.time.end})
                if (!isAmong(moving, KeyId{row, key})) marks.push_back(key);
    return m_scale->snapped(time, marks);
}

std::vector<KeyId> TrackView::endsOf(const std::vector<MotionId>& motions) const {
    std::vector<KeyId> ends;
    for (const MotionId& id : motions) {
        const MotionTime& time =
            m_rows[static_cast<std::size_t>(id.handle)].bars[static_cast<std::size_t>(id.motion)].time;
        ends.insert(ends.end(), {{id.handle, time.start}, {id.handle, time.end}});
    }
    return ends;
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
    const std::vector<KeyId> moving = endsOf(grabbed.motions);
    const double toStart = snapped(start + way, moving), toEnd = snapped(end + way, moving);
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

void TrackView::change(const QString& what, Design after) {
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
    m_keys.clear();
    std::vector<int> pins;
    for (const MotionId& bar : m_chosen) pins.push_back(bar.handle);
    m_session.selection().set(std::move(pins));
    viewport()->update();
    emit choiceChanged();
}

/// Returns the chosen bars whose pins are not locked.
std::vector<MotionId> TrackView::changeable() const {
    std::vector<MotionId> motions = m_chosen;
    std::erase_if(motions, [this](const MotionId& id) { return !m_session.gestures().mayChange(id.handle); });
    return motions;
}

void TrackView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    const QPointF at = event->position();
    const bool joins = event->modifiers() & (Qt::ShiftModifier | Qt::ControlModifier);
    if (pressKey(at, joins)) return;
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
    if (!joins) m_chosen.clear(), m_keys.clear();
    if (const int row = rowAt(at); row >= 0)
        joins ? m_session.selection().toggle(row) : m_session.selection().set({row});
    if (hit)
        grab(hit->first, hit->second, timeAt(at.x()), false);
    else
        m_band = Band{at, at, m_chosen, m_keys};
    viewport()->update();
    emit choiceChanged();
}

void TrackView::grab(const Bar& bar, Part part, double at, bool alone) {
    const bool isMotion = bar.motion != kHold;
    if (!m_session.gestures().mayChange(bar.handle)) return;
    const auto motions = isMotion ? changeable() : std::vector<MotionId>();
    const MotionTime span = isMotion ? spanOf(m_session.document().design(), motions) : bar.time;
    m_grabbed = Grabbed{bar, part, at, motions, span, span, alone};
}

/// Adds the keys in the frame to the earlier choice; if there are none, the bars that it touches.
void TrackView::stretchBand(const QPointF& to) {
    m_band->to = to;
    m_chosen = m_band->others;
    m_keys = m_band->otherKeys;
    const QRectF frame = QRectF(m_band->from, to).normalized();
    for (int row = 0; row < static_cast<int>(m_rows.size()); ++row)
        for (const double time : keysIn(row))
            if (const KeyId key{row, time}; frame.contains(keySpot(key)) && !isChosen(key))
                m_keys.push_back(key);
    if (!m_keys.empty()) m_chosen.clear();
    for (const Row& row : m_keys.empty() ? m_rows : std::vector<Row>())
        for (const Bar& bar : row.bars)
            if (barRect(bar).intersects(frame) && !isChosen(bar)) m_chosen.push_back(bar);
    viewport()->update();
}

void TrackView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    if (m_band) return stretchBand(at);
    if (m_grabbedKeys) return dragKeys(timeAt(at.x()));
    if (m_grabbed) {
        const bool moves =
            m_grabbed->time != m_grabbed->span || std::abs(at.x() - xOf(m_grabbed->at)) >= kDragged;
        if (moves) m_grabbed->time = dragged(*m_grabbed, timeAt(at.x()));
        return viewport()->update();
    }
    const auto hit = barAt(at);
    viewport()->setCursor(keyAt(at)                    ? Qt::SizeHorCursor
                          : !hit                       ? Qt::ArrowCursor
                          : hit->first.motion != kHold ? Qt::OpenHandCursor
                                                       : Qt::SizeHorCursor);
}

void TrackView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    const auto band = std::exchange(m_band, std::nullopt);
    if (band && !m_keys.empty())
        chooseKeys(m_keys);
    else if (band && m_chosen != band->others)
        choose(m_chosen);
    if (const auto keys = std::exchange(m_grabbedKeys, std::nullopt)) dropKeys(*keys);
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
    if (m_grabbed || m_grabbedKeys || end() <= 0) return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const auto hit = barAt(event->pos());
    if (const auto key = keyAt(event->pos())) {
        if (!isChosen(*key)) chooseKeys({*key});
        fillMenu(*menu, *key);
    } else if (hit && hit->first.motion != kHold) {
        if (!isChosen(hit->first)) choose({hit->first});
        fillMenu(*menu, hit->first);
    } else if (const int row = rowAt(event->pos()); row >= 0) {
        m_session.selection().set({row});
        addPasting(*menu);
    } else {
        return delete menu;
    }
    menu->popup(event->globalPos());
}

void TrackView::fillMenu(QMenu& menu, const Bar& bar) {
    menu.addSection(tr("Easing"));
    for (const Ease ease : kEases) {
        QAction* action = menu.addAction(easeName(ease), this, [this, ease] {
            if (const auto motions = changeable(); !motions.empty())
                change(tr("Change easing"), withMotionEase(m_session.document().design(), motions, ease));
        });
        action->setCheckable(true);
        action->setChecked(bar.ease == ease);
    }
    addEaseEditor(menu);
    menu.addSeparator();
    menu.addAction(tr("&Straighten"), this, [this] {
        change(tr("Straighten"), straightened(m_session.document().design(), changeable()));
    });
    QMenu* keys = menu.addMenu(tr("Simplify to &Keys"));
    for (const auto& [name, pixels] : {std::pair{tr("&Few"), 16}, {tr("&Some"), 4}, {tr("&Many"), 1}})
        keys->addAction(name, this, [this, pixels = pixels] {
            change(tr("Simplify"), withFewKeys(m_session.document().design(), changeable(),
                                               pixels * m_session.motion().pixel()));
        });
    menu.addSeparator();
    menu.addAction(m_chosen.size() > 1 ? tr("&Remove Motions") : tr("&Remove Motion"), this,
                   &TrackView::removeChosen);
}

void TrackView::removeChosen() {
    if (!m_keys.empty()) return removeKeys();
    const auto motions = changeable();
    if (motions.empty()) return;
    if (m_chosen.size() > 1) m_chosen.clear();  // a single one is replaced by the next
    change(motions.size() > 1 ? tr("Remove motions") : tr("Remove motion"),
           withoutMotions(m_session.document().design(), motions));
}

/// Delete is for the bars and keys that are chosen, not for their pins.
bool TrackView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && takesKey(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return QAbstractScrollArea::event(event);
}

/// Moves the chosen bars or keys by Left and Right with Alt, otherwise the shown time.
bool TrackView::nudge(const QKeyEvent& event) {
    const int side = event.key() == Qt::Key_Left ? -1 : event.key() == Qt::Key_Right ? 1 : 0;
    const double way = side * m_scale->step();
    if (way == 0) return false;
    if (!(event.modifiers() & Qt::AltModifier)) {
        m_session.playback().setPlaying(false);
        m_session.playback().setTime(m_scale->onFrame(m_session.playback().time() + way));
    } else if (!m_keys.empty()) {
        moveKeys(way, QStringLiteral("keys"));
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
    if (keyCommand(*event)) return;
    if (event->key() == Qt::Key_Escape && (m_grabbed || m_grabbedKeys || m_band)) {
        if (m_band) m_chosen = m_band->others, m_keys = m_band->otherKeys;
        m_grabbed.reset();
        m_grabbedKeys.reset();
        m_band.reset();
        return viewport()->update();
    }
    if (step == 0 || m_rows.empty()) return QAbstractScrollArea::keyPressEvent(event);
    const int last = static_cast<int>(m_rows.size()) - 1, now = m_session.selection().single();
    const int next = std::clamp(now < 0 ? 0 : now + step, 0, last);
    m_session.selection().set({next});
    const auto& bars = m_rows[static_cast<std::size_t>(next)].bars;
    m_keys.clear();
    m_chosen.assign(bars.begin(), bars.begin() + (bars.empty() ? 0 : 1));
    emit choiceChanged();
}

/// Shows the time of a key, or the name and times of a bar.
bool TrackView::viewportEvent(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QAbstractScrollArea::viewportEvent(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const auto hit = barAt(help->pos());
    if (const auto key = keyAt(help->pos())) {
        QToolTip::showText(help->globalPos(), tr("Key at %1").arg(m_scale->text(key->time)));
        return true;
    }
    if (!hit) {
        QToolTip::hideText();
        return true;
    }
    const MotionTime time = timeOf(hit->first);
    if (hit->first.motion == kHold)
        QToolTip::showText(help->globalPos(),
                           tr("Holds from %1 to %2").arg(m_scale->text(time.start), m_scale->text(time.end)));
    else
        QToolTip::showText(
            help->globalPos(),
            tr("%1: %2 to %3, %4")
                .arg(hit->first.kind, m_scale->text(time.start), m_scale->text(time.end),
                     (hit->first.ease ? withoutKey(easeName(*hit->first.ease)) : tr("Easing Curve"))
                         .toLower()));
    return true;
}

}  // namespace wend
