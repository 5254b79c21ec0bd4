#include "app/window/film/track_view.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "app/base/connect_each.h"
#include "app/base/preferences.h"
#include "app/panels/fields/ease_names.h"
#include "app/panels/fields/panel_parts.h"
#include "app/project/design.h"
#include "app/project/edits/film_edits.h"
#include "app/session/shape_session.h"
#include "app/style/marks.h"
#include "app/style/theme.h"
#include "app/window/film/ease_editor.h"
#include "app/window/film/key_pose_strip.h"
#include "app/window/film/sound_track.h"
#include "app/window/film/time_ruler.h"

namespace wend {

namespace {

QString kindOf(const PinMotion& motion) {
    if (std::holds_alternative<Rotate<3>>(motion.kind)) return TrackView::tr("Rotate");
    const auto* curve = std::get_if<CurveMotion<3>>(&motion.kind);
    if (!curve || straightProgress(motion)) return TrackView::tr("Move");
    const auto isFirst = [&](const Vec3& p) { return p == curve->points.front(); };
    const bool stays = std::ranges::all_of(curve->points, isFirst);
    return stays && curve->scale != 1 ? TrackView::tr("Scale") : TrackView::tr("Path");
}

/// Returns the easing of a motion; nothing if it has a curve of its own.
std::optional<Ease> easeOf(const PinMotion& motion) {
    const auto straight = straightProgress(motion);
    return straight ? easeOf(*straight) : motion.ease;
}

void setChecked(QAction* action, bool checked) {
    action->setCheckable(true);
    action->setChecked(checked);
}

}  // namespace

TrackView::TrackView(ShapeSession& session, QWidget* parent)
    : QAbstractScrollArea(parent),
      m_session(session),
      m_choice(new TrackChoice(session, this)),
      m_scale(new TimeScale(session.document(), session.playback(), this)),
      m_sound(new SoundTrack(session.document(), session.playback(), this)),
      m_ruler(new TimeRuler(session.document(), session.playback(), *m_scale, *m_sound, viewport())),
      m_poses(new KeyPoseStrip(session.motion(), session.playback(), *m_scale, viewport())),
      m_layout{*m_scale} {
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
    Document& document = session.document();
    Playback& playback = session.playback();
    connectEach(this, &TrackView::takeProject, &document, &Document::opened, &document,
                &Document::projectChanged);
    connectEach(this, &TrackView::arrange, &playback, &Playback::endChanged, m_ruler,
                &TimeRuler::rowsChanged);
    connectEach(viewport(), qOverload<>(&QWidget::update), &playback, &Playback::timeChanged, m_scale,
                &TimeScale::changed, m_choice, &TrackChoice::changed);
    connect(&session.selection(), &Selection::changed, this, &TrackView::showSelection);
    takeProject();
}

void TrackView::takeProject() {
    m_layout.drag.reset();
    m_band.reset();
    m_layout.rows.clear();
    if (!m_session.document().isEmpty()) {
        const Design& design = m_choice->design();
        for (const Pin& pin : design.handles) {
            const int h = static_cast<int>(m_layout.rows.size());
            TrackLayout::Row row{QString::fromStdString(pin.name),
                                 pinColour(h, pin.traits),
                                 {{h, kHold}, {pin.activeFrom, pin.activeTo}}};
            for (const PinMotion& motion : pin.motions)
                row.bars.push_back({{h, static_cast<int>(row.bars.size())},
                                    {motion.start, motion.end},
                                    slowSidesOf(motion),
                                    kindOf(motion),
                                    easeOf(motion)});
            for (const double time : keyTimes(design, h)) row.keys.push_back({h, time});
            m_layout.rows.push_back(std::move(row));
        }
    }
    arrange();
}

/// Leaves the pictures of key poses out where rows would lack room.
void TrackView::arrange() {
    constexpr int kRowsAtLeast = 2;
    const int width = viewport()->width(), height = viewport()->height(), ruler = m_ruler->rows();
    const bool moves = m_scale->end() > 0;
    const bool posed = moves && preferences::keyPosesShown.value() &&
                       height - ruler - KeyPoseStrip::kHeight >= kRowsAtLeast * TrackLayout::kRowHeight;
    const int above = posed ? KeyPoseStrip::kHeight : 0, room = height - above - ruler;
    m_poses->setGeometry(0, 0, width, KeyPoseStrip::kHeight);
    m_poses->setVisible(posed);
    m_ruler->setGeometry(0, above, width, ruler);
    m_ruler->setVisible(moves);
    m_layout.area = QRectF(0, above + ruler, width, room);
    const auto rows = static_cast<double>(moves ? m_layout.rows.size() : 0);
    verticalScrollBar()->setRange(0, std::max(static_cast<int>(TrackLayout::kRowHeight * rows) - room, 0));
    verticalScrollBar()->setPageStep(room);
    verticalScrollBar()->setSingleStep(static_cast<int>(TrackLayout::kRowHeight));
    viewport()->update();
}

void TrackView::scrollContentsBy(int, int) {
    m_layout.scrolled = verticalScrollBar()->value();
    viewport()->update();
}

/// Scrolls to the first motion of a new film.
void TrackView::showFirstMotion() {
    const int generation = m_session.document().generation();
    if (m_scale->end() <= 0 || !isVisible() || std::exchange(m_generation, generation) == generation) return;
    const auto& rows = m_layout.rows;
    const auto moves = std::ranges::find_if(rows, [](const auto& row) { return !row.bars.empty(); });
    if (moves != rows.end()) bringIntoView(static_cast<int>(moves - rows.begin()));
}

void TrackView::bringIntoView(int row) {
    const QRectF rect = m_layout.rowRect(row);
    const double below = rect.bottom() - viewport()->height(), above = m_layout.area.top() - rect.top();
    const double way = below > 0 ? below : std::min(-above, 0.0);
    verticalScrollBar()->setValue(verticalScrollBar()->value() + static_cast<int>(std::lround(way)));
}

/// Brings a pin that is the only selected one into view.
void TrackView::showSelection() {
    if (const int row = m_session.selection().single(); row >= 0) bringIntoView(row);
    viewport()->update();
}

QSize TrackView::sizeHint() const {
    constexpr int kRowsAtFirst = 5;
    const int poses = preferences::keyPosesShown.value() ? KeyPoseStrip::kHeight : 0;
    return {400, int(22 + poses + kRowsAtFirst * TrackLayout::kRowHeight)};
}

QRectF TrackView::barOf(int handle, int motion) const {
    if (handle < 0 || handle >= std::ssize(m_layout.rows)) return {};
    const TrackLayout::Row& row = m_layout.rows[handle];
    if (motion == kHold) return m_layout.rectOf(row.hold);
    return motion < std::ssize(row.bars) ? m_layout.rectOf(row.bars[motion]) : QRectF();
}

/// Shows the first motion once the layout is done.
void TrackView::showEvent(QShowEvent*) {
    QMetaObject::invokeMethod(this, &TrackView::showFirstMotion, Qt::QueuedConnection);
}

/// Hides the curve editor, which edits the bars shown here.
void TrackView::hideEvent(QHideEvent*) {
    if (auto* editor = findChild<EaseEditor*>()) editor->hide();
}

// --- Mouse ---

/// Returns the item at a place. If several bars are chosen, their ends scale them and are no keys.
std::optional<TrackLayout::Hit> TrackView::hitAt(const QPointF& at) const {
    const auto bars = m_choice->bars();
    return m_layout.hitAt(at, bars.size() > 1 ? m_choice->endsOf(bars) : std::vector<KeyId>());
}

void TrackView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    const QPointF at = event->position();
    const double time = m_scale->timeAt(at.x());
    const bool joins = event->modifiers() & (Qt::ShiftModifier | Qt::ControlModifier);
    const auto hit = hitAt(at);
    const auto press = [&](auto chosen, const auto& one) {
        const bool among = isAmong(chosen, one);
        if (!joins && !among) chosen.clear();
        if (!among) chosen.push_back(one);
        if (joins && among) std::erase(chosen, one);
        m_choice->choose(chosen);
        if (!joins || !among) grab(*hit, time, among);
    };
    if (hit && hit->isKey()) return press(m_choice->keys(), hit->key);
    if (hit && !hit->isHold()) return press(m_choice->bars(), hit->bar);
    if (!joins) m_choice->set({});
    if (const int row = m_layout.rowAt(at); row >= 0)
        joins ? m_session.selection().toggle(row) : m_session.selection().set({row});
    if (hit)
        grab(*hit, time, false);
    else
        m_band = Band{at, at, m_choice->bars(), m_choice->keys()};
}

/// Drags what is chosen, or a hold, until it is dropped; `alone`: a click chooses it alone.
void TrackView::grab(const TrackLayout::Hit& hit, double at, bool alone) {
    if (!m_session.gestures().mayChange(hit.isKey() ? hit.key.handle : hit.bar.handle)) return;
    TrackLayout::Drag drag{hit, at, alone};
    if (hit.isKey()) {
        drag.keys = m_choice->changeableKeys();
    } else if (hit.isHold()) {
        drag.bars = {hit.bar};
        drag.from = hit.bar.time;
    } else {
        drag.bars = m_choice->changeableBars();
        drag.keys = m_choice->endsOf(drag.bars);
        drag.from = spanOf(m_choice->design(), drag.bars);
    }
    drag.to = drag.from;
    m_layout.drag = std::move(drag);
}

/// Adds the keys in the frame to the earlier choice; if there are none, the bars that it touches.
void TrackView::stretchBand(const QPointF& to) {
    m_band->to = to;
    auto [from, at, bars, keys] = *m_band;
    const QRectF frame = QRectF(from, to).normalized();
    for (const TrackLayout::Row& row : m_layout.rows) {
        for (const KeyId& key : row.keys)
            if (frame.contains(keySpot(key)) && !isAmong(keys, key)) keys.push_back(key);
        for (const TrackLayout::Bar& bar : row.bars)
            if (m_layout.rectOf(bar).intersects(frame) && !isAmong(bars, bar)) bars.push_back(bar);
    }
    m_choice->set(bars, keys);
}

void TrackView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    if (m_band) return stretchBand(at);
    if (m_layout.drag) {
        std::vector<double> marks = {0, m_scale->end(), m_session.playback().time()};
        for (const FilmMarks::Marker& marker : filmMarksOf(m_session.document()).markers)
            marks.push_back(marker.at);
        m_layout.dragTo(at.x(), m_choice->design(), marks);
        return viewport()->update();
    }
    const auto hit = hitAt(at);
    viewport()->setCursor(!hit                            ? Qt::ArrowCursor
                          : hit->isKey() || hit->isHold() ? Qt::SizeHorCursor
                                                          : Qt::OpenHandCursor);
}

void TrackView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    const auto band = std::exchange(m_band, std::nullopt);
    if (band && (!m_choice->keys().empty() || m_choice->bars() != band->bars))
        m_choice->choose(m_choice->bars(), m_choice->keys());
    if (const auto drag = std::exchange(m_layout.drag, std::nullopt)) drop(*drag);
    viewport()->update();
}

void TrackView::drop(const TrackLayout::Drag& drag) {
    const TrackLayout::Hit& hit = drag.hit;
    if (!drag.moves() && drag.alone) hit.isKey() ? m_choice->choose({hit.key}) : m_choice->choose({hit.bar});
    if (!drag.moves()) return;
    if (hit.isKey())
        m_choice->moveKeys(drag.to.start - drag.from.start);
    else if (hit.isHold())
        m_choice->change(tr("Change when it holds"),
                         withHold(m_choice->design(), hit.bar.handle, drag.to, m_session.document().end()));
    else
        m_choice->moveBars(drag.bars, drag.to,
                           hit.part == TrackLayout::Part::Body ? tr("Move in time") : tr("Change duration"));
}

/// Shows the time of a key, or the name and times of a bar.
bool TrackView::viewportEvent(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QAbstractScrollArea::viewportEvent(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    QString text;
    if (const auto hit = hitAt(help->pos()); hit && hit->isKey()) {
        text = tr("Key at %1").arg(m_scale->text(hit->key.time));
    } else if (hit) {
        const MotionTime time = m_layout.timeOf(hit->bar);
        const QString start = m_scale->text(time.start), end = m_scale->text(time.end);
        const auto& ease = hit->bar.ease;
        text = hit->isHold() ? tr("Holds from %1 to %2").arg(start, end)
                             : tr("%1: %2 to %3, %4")
                                   .arg(hit->bar.kind, start, end,
                                        (ease ? withoutKey(easeName(*ease)) : tr("Easing Curve")).toLower());
    }
    QToolTip::showText(help->globalPos(), text);
    return true;
}

// --- Menus and keys ---

void TrackView::contextMenuEvent(QContextMenuEvent* event) {
    if (m_layout.drag || m_scale->end() <= 0) return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const auto hit = hitAt(event->pos());
    if (hit && hit->isKey()) {
        if (!m_choice->contains(hit->key)) m_choice->choose({hit->key});
        fillMenu(*menu, hit->key);
    } else if (hit && !hit->isHold()) {
        if (!m_choice->contains(hit->bar)) m_choice->choose({hit->bar});
        fillMenu(*menu, hit->bar);
    } else if (const int row = m_layout.rowAt(event->pos()); row >= 0) {
        m_session.selection().set({row});
        addPasting(*menu);
    } else {
        return delete menu;
    }
    menu->popup(event->globalPos());
}

void TrackView::fillMenu(QMenu& menu, const TrackLayout::Bar& bar) {
    menu.addSection(tr("Easing"));
    for (const Ease ease : kEases)
        setChecked(menu.addAction(easeName(ease), m_choice, [this, ease] { m_choice->setEase(ease); }),
                   bar.ease == ease);
    menu.addAction(tr("Easing C&urve…") + QStringLiteral("\tE"), this, &TrackView::editEase);
    menu.addSeparator();
    menu.addAction(tr("&Straighten"), m_choice, &TrackChoice::straighten);
    QMenu* keys = menu.addMenu(tr("Simplify to &Keys"));
    for (const auto& [name, pixels] : {std::pair{tr("&Few"), 16}, {tr("&Some"), 4}, {tr("&Many"), 1}})
        keys->addAction(name, m_choice, [this, pixels = pixels] { m_choice->simplify(pixels); });
    menu.addSeparator();
    menu.addAction(m_choice->bars().size() > 1 ? tr("&Remove Motions") : tr("&Remove Motion"), m_choice,
                   &TrackChoice::remove);
}

void TrackView::fillMenu(QMenu& menu, const KeyId& key) {
    const KeyEase now = easeAt(m_choice->design(), key);
    const std::pair<QString, KeyEase> kinds[] = {{tr("&Linear"), {false, false}},
                                                 {tr("Slow &before It"), {true, false}},
                                                 {tr("Slow &after It"), {false, true}},
                                                 {tr("Slow on B&oth Sides"), {true, true}}};
    menu.addSection(tr("Easing"));
    for (const auto& [name, ease] : kinds)
        setChecked(menu.addAction(name, m_choice, [this, ease = ease] { m_choice->setKeyEase(ease); }),
                   now == ease);
    menu.addAction(tr("Easing C&urve…") + QStringLiteral("\tE"), this, &TrackView::editEase);
    menu.addSeparator();
    menu.addAction(tr("&Hold to the Next"), m_choice, &TrackChoice::holdKeys);
    menu.addAction(tr("&Mirror"), m_choice, &TrackChoice::mirror);
    menu.addSeparator();
    menu.addAction(tr("&Copy") + QStringLiteral("\tCtrl+C"), m_choice, &TrackChoice::copy);
    addPasting(menu);
    menu.addSeparator();
    menu.addAction(
        (m_choice->keys().size() > 1 ? tr("&Remove Keys") : tr("&Remove Key")) + QStringLiteral("\tDel"),
        m_choice, &TrackChoice::remove);
}

void TrackView::addPasting(QMenu& menu) {
    menu.addAction(tr("&Paste at the Time Shown") + QStringLiteral("\tCtrl+V"), this,
                   [this] { paste(false); })
        ->setEnabled(m_choice->hasCopies());
    menu.addAction(tr("Paste M&irrored") + QStringLiteral("\tCtrl+Shift+V"), this, [this] { paste(true); })
        ->setEnabled(m_choice->hasCopies());
}

void TrackView::paste(bool mirrored) {
    m_choice->paste(m_scale->onFrame(m_session.playback().time()), mirrored);
}

/// Opens the curve beside the tracks, or brings it back.
void TrackView::editEase() {
    auto* editor = findChild<EaseEditor*>();
    if (!editor) {
        editor = new EaseEditor(*m_choice, this);
        editor->adjustSize();
        constexpr int kFrame = 40;  // pixels, of the window's title
        const QPoint corner = mapToGlobal(QPoint(width(), 0));
        editor->move(corner - QPoint(editor->width() + kFrame, editor->height() + kFrame));
    }
    editor->show();
    editor->raise();
    editor->activateWindow();
}

/// Returns what a key does here rather than in the window: Delete is for the bars and keys that are chosen,
/// not for their pins. Nothing if it is not for the tracks.
std::function<void()> TrackView::commandOf(const QKeyEvent& event) {
    struct Command {
        QKeyCombination keys;
        bool can;
        std::function<void()> run;
    };
    const bool chosen = !m_choice->isEmpty(), copied = m_choice->hasCopies(), moves = m_scale->end() > 0;
    const Command commands[] = {
        {Qt::Key_Delete, chosen, [this] { m_choice->remove(); }},
        {Qt::Key_E, chosen, [this] { editEase(); }},
        {QKeyCombination(Qt::CTRL, Qt::Key_C), chosen, [this] { m_choice->copy(); }},
        {QKeyCombination(Qt::CTRL, Qt::Key_V), copied, [this] { paste(false); }},
        {Qt::CTRL | Qt::SHIFT | Qt::Key_V, copied, [this] { paste(true); }},
        {Qt::Key_I, moves, [this] { m_ruler->markCycle(0); }},
        {Qt::Key_O, moves, [this] { m_ruler->markCycle(1); }},
        {QKeyCombination(Qt::SHIFT, Qt::Key_M), moves, [this] { m_ruler->addMarker(); }}};
    for (const Command& command : commands)
        if (command.can && command.keys == event.keyCombination()) return command.run;
    return {};
}

bool TrackView::event(QEvent* event) {
    const bool isOurs =
        event->type() == QEvent::ShortcutOverride && commandOf(*static_cast<QKeyEvent*>(event));
    if (isOurs) event->accept();
    return isOurs || QAbstractScrollArea::event(event);
}

/// Moves the chosen bars or keys by Left and Right with Alt, otherwise the shown time.
void TrackView::keyPressEvent(QKeyEvent* event) {
    const int side = event->key() == Qt::Key_Left ? -1 : event->key() == Qt::Key_Right ? 1 : 0;
    const int step = event->key() == Qt::Key_Up ? -1 : event->key() == Qt::Key_Down ? 1 : 0;
    if (side != 0 && event->modifiers() & Qt::AltModifier) return m_choice->nudge(side * m_scale->step());
    if (side != 0) {
        Playback& playback = m_session.playback();
        playback.setPlaying(false);
        return playback.setTime(m_scale->onFrame(playback.time() + side * m_scale->step()));
    }
    if (const auto run = commandOf(*event)) return run();
    if (event->key() == Qt::Key_Escape && (m_layout.drag || m_band)) {
        if (m_band) m_choice->set(m_band->bars, m_band->keys);
        m_layout.drag.reset();
        m_band.reset();
        return viewport()->update();
    }
    if (step == 0 || m_layout.rows.empty()) return QAbstractScrollArea::keyPressEvent(event);
    const int last = static_cast<int>(m_layout.rows.size()) - 1, now = m_session.selection().single();
    const int next = std::clamp(now < 0 ? 0 : now + step, 0, last);
    m_session.selection().set({next});
    const auto& bars = m_layout.rows[next].bars;
    m_choice->set({bars.begin(), bars.begin() + (bars.empty() ? 0 : 1)});
}

// --- Drawing ---

void TrackView::paintEvent(QPaintEvent*) {
    QPainter painter(viewport());
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme theme = Theme::of(palette());
    painter.fillRect(viewport()->rect(), palette().color(QPalette::Window));
    if (m_scale->end() <= 0) {
        painter.setPen(theme.secondText);
        painter.drawText(viewport()->rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Nothing moves yet. Drag a pin, or record it with Ctrl held: what you do appears "
                            "here, pin by pin."));
        return;
    }
    painter.save();
    painter.setClipRect(m_layout.area);
    for (const TrackLayout::Row& row : m_layout.rows) paintRow(painter, row);
    QColor ground = theme.accent;
    ground.setAlphaF(0.2F);
    painter.setPen(theme.accentText);
    painter.setBrush(ground);
    if (m_band) painter.drawRect(QRectF(m_band->from, m_band->to).normalized());
    painter.restore();
    const double now = m_scale->xOf(m_session.playback().time());
    painter.setPen(QPen(theme.accentText, 1.5));
    painter.drawLine(QPointF(now, m_layout.area.top()), QPointF(now, viewport()->height()));
}

void TrackView::paintRow(QPainter& painter, const TrackLayout::Row& row) const {
    const QRectF rect = m_layout.rowRect(row.hold.handle);
    QColor ground = Theme::of(palette()).accent;
    ground.setAlphaF(0.14F);
    if (m_session.selection().contains(row.hold.handle)) painter.fillRect(rect, ground);
    painter.setPen(Qt::NoPen);
    painter.setBrush(row.colour);
    painter.drawEllipse(QPointF(16, rect.center().y()), 4, 4);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect.adjusted(28, 0, m_scale->way().x() - 8 - rect.width(), 0),
                     Qt::AlignVCenter | Qt::AlignLeft,
                     painter.fontMetrics().elidedText(row.name, Qt::ElideRight, m_scale->way().x() - 36));
    paintHold(painter, row.hold);
    for (const TrackLayout::Bar& bar : row.bars) paintBar(painter, bar, row.colour);
    for (const KeyId& key : row.keys) paintKey(painter, key);
}

/// Paints a key pose; a chosen one is larger.
void TrackView::paintKey(QPainter& painter, const KeyId& key) const {
    const bool chosen = m_choice->contains(key);
    const double half = chosen ? 6.5 : 4.5;
    const QPointF at = keySpot(key);
    painter.setPen(QPen(palette().color(QPalette::Window), 1));
    painter.setBrush(chosen ? Theme::of(palette()).accentText : palette().color(QPalette::WindowText));
    painter.drawPolygon(QPolygonF(
        {at + QPointF(-half, 0), at + QPointF(0, -half), at + QPointF(half, 0), at + QPointF(0, half)}));
}

/// Paints a line with stops at its ends, by which it is dragged.
void TrackView::paintHold(QPainter& painter, const TrackLayout::Bar& hold) const {
    const QRectF box = m_layout.rectOf(hold);
    const double y = box.center().y(), left = box.left();
    const double right = std::max(left, m_scale->xOf(m_layout.timeOf(hold).end));
    painter.setPen(QPen(Theme::of(palette()).secondText, 1.5));
    painter.drawLine(QPointF(left, y), QPointF(right, y));
    for (const double x : {left, right}) painter.drawLine(QPointF(x, y - 5), QPointF(x, y + 5));
}

/// Paints a bar with full opacity at constant speed, lighter where the motion eases.
void TrackView::paintBar(QPainter& painter, const TrackLayout::Bar& bar, const QColor& colour) const {
    const Theme theme = Theme::of(palette());
    const QRectF box = m_layout.rectOf(bar).adjusted(0.5, 0, -0.5, 0);
    const bool chosen = m_choice->contains(bar);
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
