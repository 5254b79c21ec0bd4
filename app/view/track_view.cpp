#include "app/view/track_view.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QLocale>
#include <QMenu>
#include <QScrollBar>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "app/document/project.h"
#include "app/panels/ease_names.h"
#include "app/panels/marks.h"
#include "app/panels/panel_parts.h"

namespace wend {

namespace {

constexpr double kGrip = 5;     // pixels of a bar's end, to both sides
constexpr double kSnap = 6;     // to other ends, and to the time that is shown
constexpr double kDragged = 3;  // before a press is a drag
constexpr double kStep = 0.04;  // seconds, of a key

template <int Dim>
QString kindOf(const Motion<Dim>& motion) {
    if (std::holds_alternative<Rotate<Dim>>(motion.kind)) return TrackView::tr("Rotate");
    const auto* curve = std::get_if<CurveMotion<Dim>>(&motion.kind);
    if (!curve) return TrackView::tr("Move");
    const bool stays = std::all_of(curve->points.begin(), curve->points.end(),
                                   [&](const Vec<Dim>& p) { return p == curve->points.front(); });
    return stays && curve->scale != 1 ? TrackView::tr("Scale") : TrackView::tr("Path");
}

QString seconds(double time) {
    return QLocale().toString(time, 'f', 2);
}

}  // namespace

TrackView::TrackView(ShapeSession& session, QWidget* parent)
    : QAbstractScrollArea(parent), m_session(session) {
    setObjectName(QStringLiteral("trackView"));
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::StrongFocus);
    viewport()->setMouseTracking(true);
    setAccessibleName(tr("Tracks"));
    setAccessibleDescription(
        tr("A row for each pin, with a bar for each of its motions; Up and Down choose a pin, Left and Right "
           "another time, with Alt they move the chosen bar"));
    setStatusTip(
        tr("Drag a bar or its ends to another time; bars at the same time move together. A right click sets "
           "how it begins and ends. The ends of the line say when the pin holds"));
    const auto repaint = [this] { viewport()->update(); };
    connect(&m_session.document(), &Document::opened, this, &TrackView::takeProject);
    connect(&m_session.document(), &Document::projectChanged, this, &TrackView::takeProject);
    connect(&m_session.selection(), &Selection::changed, this, &TrackView::showSelection);
    connect(&m_session.playback(), &Playback::timeChanged, this, repaint);
    connect(&m_session.playback(), &Playback::endChanged, this, [this, repaint] { arrange(), repaint(); });
    takeProject();
}

void TrackView::takeProject() {
    m_grabbed.reset();
    m_rows.clear();
    if (!m_session.document().isEmpty())
        std::visit(
            [this](const auto& design) {
                for (const auto& handle : design.handles) {
                    const int h = static_cast<int>(m_rows.size());
                    Row row{QString::fromStdString(handle.name),
                            pinColour(h, handle.traits),
                            {h, kHold, {handle.activeFrom, handle.activeTo}},
                            {}};
                    for (const auto& motion : handle.motions)
                        row.bars.push_back({h,
                                            static_cast<int>(row.bars.size()),
                                            {motion.start, motion.end},
                                            motion.ease,
                                            kindOf(motion)});
                    m_rows.push_back(std::move(row));
                }
            },
            m_session.document().project()->design);
    const auto& rows = m_rows;
    if (m_chosen && (m_chosen->handle >= static_cast<int>(rows.size()) ||
                     m_chosen->motion >= static_cast<int>(rows[m_chosen->handle].bars.size())))
        m_chosen.reset();
    arrange();
    viewport()->update();
}

void TrackView::arrange() {
    const int whole = end() > 0 ? static_cast<int>(kRowHeight * static_cast<double>(m_rows.size())) : 0;
    const int room = static_cast<int>(viewport()->height() - kRuler);
    verticalScrollBar()->setRange(0, std::max(whole - room, 0));
    verticalScrollBar()->setPageStep(room);
    verticalScrollBar()->setSingleStep(static_cast<int>(kRowHeight));
}

/// A film begins with what moves in view.
void TrackView::showFirstMotion() {
    const int generation = m_session.document().generation();
    if (end() <= 0 || !isVisible() || std::exchange(m_generation, generation) == generation) return;
    const auto moves = std::ranges::find_if(m_rows, [](const Row& row) { return !row.bars.empty(); });
    if (moves != m_rows.end()) bringIntoView(static_cast<int>(moves - m_rows.begin()));
}

void TrackView::bringIntoView(int row) {
    const double below = rowRect(row).bottom() - viewport()->height(), above = kRuler - rowRect(row).top();
    const double way = below > 0 ? below : std::min(-above, 0.0);
    verticalScrollBar()->setValue(verticalScrollBar()->value() + static_cast<int>(std::lround(way)));
}

/// A pin that is chosen alone is brought into view.
void TrackView::showSelection() {
    if (const int row = m_session.singleHandle(); row >= 0) bringIntoView(row);
    viewport()->update();
}

void TrackView::setWay(const QRect& way) {
    m_way = way;
    viewport()->update();
}

double TrackView::end() const {
    return m_session.playback().end();
}

double TrackView::xOf(double time) const {
    return m_way.x() + (end() > 0 ? time / end() * m_way.width() : 0);
}

double TrackView::timeAt(double x) const {
    return (x - m_way.x()) / m_way.width() * end();
}

QRectF TrackView::rowRect(int row) const {
    return {0, kRuler + row * kRowHeight - verticalScrollBar()->value(), double(viewport()->width()),
            kRowHeight};
}

/// Within the film, and where it is dragged.
MotionTime TrackView::timeOf(const Bar& bar) const {
    const MotionTime time = m_grabbed && m_grabbed->bar == bar ? m_grabbed->time : bar.time;
    return {std::max(time.start, 0.0), bar.motion == kHold ? std::min(time.end, end()) : time.end};
}

QRectF TrackView::barRect(const Bar& bar) const {
    const MotionTime time = timeOf(bar);
    const QRectF row = rowRect(bar.handle);
    return {xOf(time.start), row.center().y() - kBarHeight / 2,
            std::max(xOf(time.end) - xOf(time.start), 4.0), kBarHeight};
}

QRectF TrackView::barOf(int handle, int motion) const {
    if (handle < 0 || handle >= static_cast<int>(m_rows.size())) return {};
    if (motion == kHold) return barRect(m_rows[static_cast<std::size_t>(handle)].hold);
    const auto& bars = m_rows[static_cast<std::size_t>(handle)].bars;
    return motion < static_cast<int>(bars.size()) ? barRect(bars[static_cast<std::size_t>(motion)])
                                                  : QRectF();
}

/// The end of the line along which the pin holds; where both are, the one that can go further.
std::optional<TrackView::Part> TrackView::endAt(const Bar& bar, const QPointF& at) const {
    const MotionTime time = timeOf(bar);
    const double toStart = std::abs(at.x() - xOf(time.start)), toEnd = std::abs(at.x() - xOf(time.end));
    if (std::min(toStart, toEnd) > kGrip) return {};
    return toStart < toEnd || (toStart == toEnd && bar.time.start > 0) ? Part::Start : Part::End;
}

/// A short bar is moved in its middle; its ends reach a little beyond it.
std::optional<std::pair<TrackView::Bar, TrackView::Part>> TrackView::barAt(const QPointF& at) const {
    const int row = rowAt(at);
    if (row < 0) return {};
    for (const Bar& bar : m_rows[static_cast<std::size_t>(row)].bars) {
        const QRectF box = barRect(bar);
        if (at.x() < box.left() - kGrip || at.x() > box.right() + kGrip) continue;
        const double inner = std::min(kGrip, box.width() / 4);
        if (at.x() < box.left() + inner) return std::pair{bar, Part::Start};
        return std::pair{bar, at.x() > box.right() - inner ? Part::End : Part::Body};
    }
    const Bar& hold = m_rows[static_cast<std::size_t>(row)].hold;
    const auto part = endAt(hold, at);
    return part ? std::optional(std::pair{hold, *part}) : std::nullopt;
}

int TrackView::rowAt(const QPointF& at) const {
    if (at.y() < kRuler) return -1;
    const int row = static_cast<int>((at.y() - kRuler + verticalScrollBar()->value()) / kRowHeight);
    return row < static_cast<int>(m_rows.size()) ? row : -1;
}

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
    const MotionTime room = roomOf(*m_session.document().project(), bar.handle, bar.motion);
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

void TrackView::change(const QString& what, const std::function<Project(const Project&)>& edit,
                       const QString& key) {
    m_session.playback().setPlaying(false);
    m_session.document().change(what, edit(*m_session.document().project()), key);
}

void TrackView::move(const Bar& bar, const MotionTime& time, const QString& what, const QString& key) {
    if (time == bar.time) return;
    change(
        what, [&](const Project& p) { return withMotionTime(p, bar.handle, bar.motion, time); }, key);
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
           [&](const Project& p) { return withHold(p, bar.handle, grabbed.time); });
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
            change(tr("Ease"),
                   [&](const Project& p) { return withMotionEase(p, bar.handle, bar.motion, ease); });
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
    change(tr("Remove motion"), [&](const Project& p) { return withoutMotion(p, bar.handle, bar.motion); });
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

void TrackView::resizeEvent(QResizeEvent*) {
    arrange();
}

/// As soon as it has its room.
void TrackView::showEvent(QShowEvent*) {
    QMetaObject::invokeMethod(this, &TrackView::showFirstMotion, Qt::QueuedConnection);
}

}  // namespace wend
