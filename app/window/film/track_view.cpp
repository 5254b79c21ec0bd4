#include "app/window/film/track_view.h"

#include <QPainter>
#include <QScrollBar>
#include <algorithm>
#include <cmath>

#include "app/base/connect_each.h"
#include "app/base/preferences.h"
#include "app/project/design.h"
#include "app/style/marks.h"
#include "app/style/theme.h"
#include "app/window/film/key_pose_strip.h"
#include "app/window/film/sound_track.h"
#include "app/window/film/time_ruler.h"
#include "app/window/film/time_strip.h"

namespace wend {

namespace {

QString kindOf(const PinMotion& motion) {
    if (std::holds_alternative<Rotate<3>>(motion.kind)) return TrackView::tr("Rotate");
    const auto* curve = std::get_if<CurveMotion<3>>(&motion.kind);
    if (!curve || straightProgress(motion)) return TrackView::tr("Move");
    const bool stays = std::all_of(curve->points.begin(), curve->points.end(),
                                   [&](const Vec3& p) { return p == curve->points.front(); });
    return stays && curve->scale != 1 ? TrackView::tr("Scale") : TrackView::tr("Path");
}

/// Returns the easing of a motion; nothing if it has a curve of its own.
std::optional<Ease> easeOf(const PinMotion& motion) {
    const auto straight = straightProgress(motion);
    return straight ? easeOf(*straight) : motion.ease;
}

}  // namespace

TrackView::TrackView(ShapeSession& session, QWidget* parent)
    : QAbstractScrollArea(parent),
      m_session(session),
      m_scale(new TimeScale(session.document(), session.playback(), this)),
      m_sound(new SoundTrack(session.document(), session.playback(), this)),
      m_ruler(new TimeRuler(session.document(), session.playback(), *m_scale, *m_sound, viewport())),
      m_poses(new KeyPoseStrip(session.motion(), session.playback(), *m_scale, viewport())) {
    setObjectName(QStringLiteral("trackView"));
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::StrongFocus);
    viewport()->setMouseTracking(true);
    setAccessibleName(tr("Tracks"));
    setAccessibleDescription(
        tr("A row for each pin, with a bar for each of its motions; Up and Down choose a pin, Left and Right "
           "another time, with Alt they move the chosen bar or keys"));
    setStatusTip(tr(
        "Drag a key (a diamond) or a bar to another time; Shift, Ctrl or a frame around them choose several. "
        "A right-click eases, holds, copies, mirrors. The ends of the line show when the pin holds"));
    const auto repaint = [this] { viewport()->update(); };
    const auto rearrange = [this, repaint] { arrange(), repaint(); };
    const Document* document = &m_session.document();
    const Playback* playback = &m_session.playback();
    connectEach(this, &TrackView::takeProject, document, &Document::opened, document,
                &Document::projectChanged);
    connect(&m_session.selection(), &Selection::changed, this, &TrackView::showSelection);
    connectEach(this, repaint, playback, &Playback::timeChanged, m_scale, &TimeScale::changed);
    connectEach(this, rearrange, playback, &Playback::endChanged, m_ruler, &TimeRuler::rowsChanged);
    takeProject();
}

void TrackView::takeProject() {
    m_grabbed.reset();
    m_grabbedKeys.reset();
    m_band.reset();
    m_rows.clear();
    if (!m_session.document().isEmpty())
        for (const Pin& handle : m_session.document().design().handles) {
            const int h = static_cast<int>(m_rows.size());
            Row row{QString::fromStdString(handle.name),
                    pinColour(h, handle.traits),
                    {{h, kHold}, {handle.activeFrom, handle.activeTo}},
                    {}};
            for (const PinMotion& motion : handle.motions)
                row.bars.push_back({{h, static_cast<int>(row.bars.size())},
                                    {motion.start, motion.end},
                                    slowSidesOf(motion),
                                    kindOf(motion),
                                    easeOf(motion)});
            m_rows.push_back(std::move(row));
        }
    const auto& rows = m_rows;
    std::erase_if(m_chosen, [&rows](const MotionId& id) {
        return id.handle >= static_cast<int>(rows.size()) ||
               id.motion >= static_cast<int>(rows[id.handle].bars.size());
    });
    std::erase_if(m_keys, [this](const KeyId& key) {
        return key.handle >= static_cast<int>(m_rows.size()) || !isAmong(keysIn(key.handle), key.time);
    });
    arrange();
    viewport()->update();
    emit choiceChanged();
}

void TrackView::arrange() {
    const int above = showsPoses() ? KeyPoseStrip::kHeight : 0;
    m_poses->setGeometry(0, 0, viewport()->width(), KeyPoseStrip::kHeight);
    m_poses->setVisible(above > 0);
    m_ruler->setGeometry(0, above, viewport()->width(), m_ruler->rows());
    m_ruler->setVisible(end() > 0);
    const int whole = end() > 0 ? static_cast<int>(kRowHeight * static_cast<double>(m_rows.size())) : 0;
    const int room = static_cast<int>(viewport()->height() - top());
    verticalScrollBar()->setRange(0, std::max(whole - room, 0));
    verticalScrollBar()->setPageStep(room);
    verticalScrollBar()->setSingleStep(static_cast<int>(kRowHeight));
}

/// Scrolls to the first motion of a new film.
void TrackView::showFirstMotion() {
    const int generation = m_session.document().generation();
    if (end() <= 0 || !isVisible() || std::exchange(m_generation, generation) == generation) return;
    const auto moves = std::ranges::find_if(m_rows, [](const Row& row) { return !row.bars.empty(); });
    if (moves != m_rows.end()) bringIntoView(static_cast<int>(moves - m_rows.begin()));
}

void TrackView::bringIntoView(int row) {
    const double below = rowRect(row).bottom() - viewport()->height(), above = top() - rowRect(row).top();
    const double way = below > 0 ? below : std::min(-above, 0.0);
    verticalScrollBar()->setValue(verticalScrollBar()->value() + static_cast<int>(std::lround(way)));
}

/// A pin that is chosen alone is brought into view.
void TrackView::showSelection() {
    if (const int row = m_session.selection().single(); row >= 0) bringIntoView(row);
    viewport()->update();
}

/// Where the rows begin, below the ruler.
double TrackView::top() const {
    return m_ruler->y() + m_ruler->rows();
}

QSize TrackView::sizeHint() const {
    const int poses = preferences::keyPosesShown.value() ? KeyPoseStrip::kHeight : 0;
    return {400, int(22 + poses + kRowsAtFirst * kRowHeight)};
}

/// Leaves the pictures of key poses out where rows would lack room.
bool TrackView::showsPoses() const {
    constexpr int kRowsAtLeast = 2;
    const int room = viewport()->height() - m_ruler->rows() - KeyPoseStrip::kHeight;
    return end() > 0 && preferences::keyPosesShown.value() && room >= kRowsAtLeast * kRowHeight;
}

double TrackView::end() const {
    return m_session.playback().end();
}

double TrackView::xOf(double time) const {
    return m_scale->xOf(time);
}

double TrackView::timeAt(double x) const {
    return m_scale->timeAt(x);
}

QRectF TrackView::rowRect(int row) const {
    return {0, top() + row * kRowHeight - verticalScrollBar()->value(), double(viewport()->width()),
            kRowHeight};
}

/// Returns the interval of a bar, clipped to the film, or its dragged one.
MotionTime TrackView::timeOf(const Bar& bar) const {
    MotionTime time = bar.time;
    if (m_grabbed && bar.motion == kHold && m_grabbed->bar == bar) time = m_grabbed->time;
    if (m_grabbed && isAmong<MotionId>(m_grabbed->motions, bar))
        time = {carried(time.start, m_grabbed->span, m_grabbed->time),
                carried(time.end, m_grabbed->span, m_grabbed->time)};
    if (m_grabbedKeys && bar.motion != kHold)
        time = {shownTime(bar.handle, time.start), shownTime(bar.handle, time.end)};
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

/// Returns the end of a pin's hold within reach; of two, the one that can move further.
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
    if (at.y() < top()) return -1;
    const int row = static_cast<int>((at.y() - top() + verticalScrollBar()->value()) / kRowHeight);
    return row < static_cast<int>(m_rows.size()) ? row : -1;
}

void TrackView::resizeEvent(QResizeEvent*) {
    arrange();
}

/// Shows the first motion once the layout is done.
void TrackView::showEvent(QShowEvent*) {
    QMetaObject::invokeMethod(this, &TrackView::showFirstMotion, Qt::QueuedConnection);
}

// --- Drawing ---

void TrackView::paintEvent(QPaintEvent*) {
    QPainter painter(viewport());
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme theme = Theme::of(palette());
    painter.fillRect(viewport()->rect(), palette().color(QPalette::Window));
    if (end() <= 0) {
        painter.setPen(theme.secondText);
        painter.drawText(viewport()->rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Nothing moves yet. Drag a pin, or record it with Ctrl held: what you do appears "
                            "here, pin by pin."));
        return;
    }
    painter.save();
    painter.setClipRect(QRectF(0, top(), viewport()->width(), viewport()->height() - top()));
    for (int row = 0; row < static_cast<int>(m_rows.size()); ++row) paintRow(painter, row);
    if (m_band) paintBand(painter);
    painter.restore();
    const double now = xOf(m_session.playback().time());
    painter.setPen(QPen(theme.accentText, 1.5));
    painter.drawLine(QPointF(now, top()), QPointF(now, viewport()->height()));
}

void TrackView::paintRow(QPainter& painter, int row) const {
    const Theme theme = Theme::of(palette());
    const Row& own = m_rows[static_cast<std::size_t>(row)];
    const QRectF rect = rowRect(row);
    const bool selected = m_session.selection().contains(row);
    QColor ground = theme.accent;
    ground.setAlphaF(0.14F);
    if (selected) painter.fillRect(rect, ground);
    painter.setPen(Qt::NoPen);
    painter.setBrush(own.colour);
    painter.drawEllipse(QPointF(16, rect.center().y()), 4, 4);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect.adjusted(28, 0, m_scale->way().x() - 8 - rect.width(), 0),
                     Qt::AlignVCenter | Qt::AlignLeft,
                     painter.fontMetrics().elidedText(own.name, Qt::ElideRight, m_scale->way().x() - 36));
    paintHold(painter, own.hold);
    for (const Bar& bar : own.bars) paintBar(painter, bar, own.colour);
    const QColor ink = palette().color(QPalette::WindowText);
    for (const double time : keysIn(row))
        paintKey(painter, {row, time}, isChosen(KeyId{row, time}) ? theme.accentText : ink);
}

/// Paints a key pose; a chosen one is larger.
void TrackView::paintKey(QPainter& painter, const KeyId& key, const QColor& colour) const {
    const double half = isChosen(key) ? 6.5 : 4.5;
    const QPointF at = keySpot(key);
    painter.setPen(QPen(palette().color(QPalette::Window), 1));
    painter.setBrush(colour);
    painter.drawPolygon(QPolygonF(
        {at + QPointF(-half, 0), at + QPointF(0, -half), at + QPointF(half, 0), at + QPointF(0, half)}));
}

/// Paints a line with stops at its ends, by which it is dragged.
void TrackView::paintHold(QPainter& painter, const Bar& hold) const {
    const QRectF box = barRect(hold);
    const double y = box.center().y(), left = box.left(), right = std::max(left, xOf(timeOf(hold).end));
    painter.setPen(QPen(Theme::of(palette()).secondText, 1.5));
    painter.drawLine(QPointF(left, y), QPointF(right, y));
    for (const double x : {left, right}) painter.drawLine(QPointF(x, y - 5), QPointF(x, y + 5));
}

void TrackView::paintBand(QPainter& painter) const {
    const Theme theme = Theme::of(palette());
    QColor ground = theme.accent;
    ground.setAlphaF(0.2F);
    painter.setPen(theme.accentText);
    painter.setBrush(ground);
    painter.drawRect(QRectF(m_band->from, m_band->to).normalized());
}

/// Paints a bar with full opacity at constant speed, lighter where the motion eases.
void TrackView::paintBar(QPainter& painter, const Bar& bar, const QColor& colour) const {
    const Theme theme = Theme::of(palette());
    const QRectF box = barRect(bar).adjusted(0.5, 0, -0.5, 0);
    const bool chosen = isChosen(bar);
    QColor soft = colour;
    soft.setAlphaF(0.45F);
    QLinearGradient fill(box.topLeft(), box.topRight());
    fill.setColorAt(0, bar.slow.start ? soft : colour);
    fill.setColorAt(0.4, colour);
    fill.setColorAt(0.6, colour);
    fill.setColorAt(1, bar.slow.end ? soft : colour);
    painter.setPen(chosen ? QPen(theme.accentText, 2) : QPen(colour.darker(130), 1));
    painter.setBrush(fill);
    painter.drawRoundedRect(box, 4, 4);
    if (painter.fontMetrics().horizontalAdvance(bar.kind) + 10 > box.width()) return;
    painter.setPen(colour.lightnessF() > 0.55F ? QColor(kInk) : QColor(Qt::white));
    painter.drawText(box, Qt::AlignCenter, bar.kind);
}

}  // namespace wend
