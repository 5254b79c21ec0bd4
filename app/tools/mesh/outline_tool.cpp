#include "app/tools/mesh/outline_tool.h"

#include <Eigen/Geometry>
#include <QCoreApplication>
#include <algorithm>

#include "app/engine/shape/flat_shape.h"
#include "app/engine/shape/shape.h"
#include "app/project/domain.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/part_edits.h"
#include "app/session/part_making.h"
#include "app/session/shape_session.h"
#include "app/style/colours.h"
#include "app/style/marks.h"
#include "app/tools/drawn_outline.h"
#include "app/tools/in_steps.h"
#include "core/base/error.h"
#include "core/meshing/outline_combination.h"
#include "core/meshing/outline_simplify.h"
#include "warp/colour_outline.h"

namespace wend {

namespace {

constexpr double kCut = 2;  // pixels of the screen: a cut while it is drawn
constexpr double kSlit =
    0.002;                    // pixels of the picture: wide enough to separate parts, too thin to be visible
constexpr double kClose = 8;  // pixels of the screen
constexpr double kOutlineDetail = 0.5;  // pixels of the screen that the drawn outline may deviate
constexpr double kSmallest = 9;         // pixels² of the picture: parts and holes below it are noise
constexpr QRgb kAway = 0xB3261E;
constexpr double kThin = 3;               // pixels of the screen below which a shape counts as a line
const QColor kLeftOut(90, 92, 100, 150);  // a veil

Outline shifted(Outline outline, const Vec2& by) {
    for (auto& loop : outline.loops)
        for (Vec2& p : loop) p += by;
    return outline;
}

}  // namespace

OutlineTool::OutlineTool(PictureShapeView& view, Shape shape, OutlinePen& pen)
    : ShapeTool<PictureShapeView>(view), m_shape(shape), m_pen(pen) {
    QObject::connect(&m_pen, &OutlinePen::changed, &m_listener, [this] { takeAgain(); });
}

/// Returns true while the whole picture is deformed, without an outline of the user.
bool OutlineTool::isFirst() const {
    const Document& document = session().document();
    return document.picture() && domainOf(*wholeOf(*document.project())).outline == OutlineKind::Frame &&
           m_pen.now().use == OutlineUse::Add;
}

/// Returns the place of the part whose outline is drawn; −1 for none, or in a picture without parts.
int OutlineTool::part() const {
    const std::vector<PicturePart>& parts = session().document().domain().parts;
    const auto found = std::ranges::find(parts, m_pen.now().part, &PicturePart::name);
    return found == parts.end() ? -1 : static_cast<int>(found - parts.begin());
}

bool OutlineTool::isLocked(const std::string& name) const {
    const std::vector<PicturePart>& parts = session().document().domain().parts;
    const auto found = std::ranges::find(parts, name, &PicturePart::name);
    return found != parts.end() && found->locked;
}

/// Returns the picture whose outline is drawn; none while that of a part is not known.
Sheet OutlineTool::sheet() const {
    const Document& document = session().document();
    if (document.domain().parts.empty()) return Sheet{document.picture()};
    const auto frame = session().motion().frame<2>();
    const Texture* texture = frame && frame->built ? frame->built->texture.get() : nullptr;
    if (texture && texture->drawn)
        for (std::size_t i = 0; i < texture->sheets.size(); ++i)
            if (texture->drawn->parts[i].name == m_pen.now().part) return texture->sheets[i];
    return {};
}

/// Returns the project with the outline that is drawn as that of its domain.
std::shared_ptr<const Project> OutlineTool::wholeOf(const Project& project) const {
    const int one = part();
    return one < 0 ? std::shared_ptr<const Project>(copyOf(project)) : asWhole(project, one);
}

QString OutlineTool::hint() const {
    if (makesPart())
        return QCoreApplication::translate(
            "OutlineTool",
            "Mark what becomes a part of its own, up to where it hangs on the rest; Esc cancels");
    if (isLive())
        return QCoreApplication::translate("OutlineTool",
                                           "The tolerance, or [ and ], changes what was taken; click another "
                                           "colour to take it too, with Ctrl to take it away");
    switch (m_shape) {
        case Shape::Lasso:
            return isFirst()
                       ? QCoreApplication::translate(
                             "OutlineTool", "Draw around what should bend; Ctrl takes it away, Esc cancels")
                       : QCoreApplication::translate(
                             "OutlineTool",
                             "Draw around what should bend, too; Ctrl takes it away, Esc cancels");
        case Shape::Polygon:
            return QCoreApplication::translate(
                "OutlineTool",
                "Click corner by corner, Shift snaps to 45°, a double-click closes; Ctrl "
                "takes away, Backspace removes the last corner, Esc cancels");
        case Shape::Brush:
            return isFirst() ? QCoreApplication::translate(
                                   "OutlineTool",
                                   "Brush over what should bend; Ctrl takes it away, [ and ] change the size")
                             : QCoreApplication::translate(
                                   "OutlineTool",
                                   "Brush over what should bend, too; Ctrl takes it away, [ and "
                                   "] change the size");
        case Shape::Wand:
            return isFirst()
                       ? QCoreApplication::translate("OutlineTool",
                                                     "Click a colour that should bend; Ctrl takes it away, "
                                                     "[ and ] take fewer or more colours")
                       : QCoreApplication::translate("OutlineTool",
                                                     "Click a colour that should bend, too; Ctrl takes it "
                                                     "away, [ and ] take fewer or more colours");
        case Shape::Cut:
            break;
    }
    return QCoreApplication::translate("OutlineTool",
                                       "Draw a line along which to part the shape; Esc cancels");
}

/// Moves to the rest shape, on which outlines are drawn.
bool OutlineTool::isReady() {
    const Document& document = session().document();
    if (document.isEmpty() || !document.picture() || document.domain().kind != DomainKind::Image)
        return false;
    if (!document.domain().parts.empty() && !makesPart() && !sheet().picture) {
        session().document().notify(QCoreApplication::translate(
            "OutlineTool",
            "This picture has parts: choose the one in the list that this outline is for, or Make a Part to "
            "cut another one out."));
        return false;
    }
    if (!makesPart() && isLocked(m_pen.now().part)) {
        session().document().notify(
            QCoreApplication::translate("OutlineTool", "“%1” is locked. The list of parts unlocks it.")
                .arg(QString::fromStdString(m_pen.now().part)));
        return false;
    }
    Playback& playback = session().playback();
    if (playback.isPlaying()) playback.setPlaying(false);
    if (playback.time() > 0) {
        m_left = Left{document.generation(), playback.time()};
        playback.setTime(0);
    }
    return true;
}

/// Restores the time, unless it was changed meanwhile.
void OutlineTool::dismiss() {
    m_taken.reset();
    const auto left = std::exchange(m_left, {});
    Playback& playback = session().playback();
    if (left && left->generation == session().document().generation() && playback.time() == 0)
        playback.setTime(std::min(left->time, playback.end()));
}

bool OutlineTool::takesAway(Qt::KeyboardModifiers modifiers) const {
    if (m_shape == Shape::Cut || makesPart()) return m_shape == Shape::Cut;
    return (m_pen.now().use == OutlineUse::TakeAway) != bool(modifiers & Qt::ControlModifier);
}

bool OutlineTool::makesPart() const {
    return m_shape != Shape::Cut && m_pen.now().use == OutlineUse::MakePart;
}

/// Shift constrains the next side of a polygon to eight directions.
void OutlineTool::takePointer(const QMouseEvent& event) {
    m_at = event.position();
    m_modifiers = event.modifiers();
    if (m_active && m_shape == Shape::Polygon && m_modifiers & Qt::ShiftModifier)
        m_at = m_line.last() + inSteps(m_at - m_line.last());
}

void OutlineTool::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || !isReady()) return;
    takePointer(event);
    m_over = true;
    if (m_shape == Shape::Wand) return takeColour(event);
    const bool closes = m_shape == Shape::Polygon && m_line.size() > 2 &&
                        QLineF(m_at, m_line.first()).length() < marked(kClose);
    if (m_shape == Shape::Polygon && m_active && !closes) {
        m_line << m_at;
    } else if (closes) {
        finish(event.modifiers());
    } else {
        m_line = {m_at};
        m_active = true;
    }
    view().redraw();
}

void OutlineTool::move(const QMouseEvent& event) {
    m_cross.hide();
    takePointer(event);
    m_over = isReady();
    if (m_active && isDrawn()) m_line << m_at;
    view().redraw();
}

void OutlineTool::release(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || !m_active || !isDrawn()) return;
    m_at = event.position();
    m_line << m_at;
    finish(event.modifiers());
    view().redraw();
}

/// Closes the polygon, whose last corner was set by the first click.
void OutlineTool::doubleClick(const QMouseEvent& event) {
    if (m_shape == Shape::Polygon && m_active)
        finish(event.modifiers());
    else
        press(event);
    view().redraw();
}

bool OutlineTool::ownsKey(const QKeyEvent& event) const {
    const bool edits =
        event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter || event.key() == Qt::Key_Backspace;
    return m_active && m_shape == Shape::Polygon && edits;
}

bool OutlineTool::key(const QKeyEvent& event) {
    if (m_shape == Shape::Wand && m_cross.clicks(event, view(), *this)) return true;
    const bool smaller = event.text() == QStringLiteral("["), larger = event.text() == QStringLiteral("]");
    if (event.key() == Qt::Key_Escape && m_active) {
        cancel();
    } else if (ownsKey(event) && event.key() == Qt::Key_Backspace) {
        m_line.removeLast();
        m_active = !m_line.isEmpty();
    } else if (ownsKey(event)) {
        finish(m_modifiers);
    } else if ((smaller || larger) && (m_shape == Shape::Brush || m_shape == Shape::Wand)) {
        scale(smaller ? 0.8 : 1.25);
    } else {
        return false;
    }
    view().redraw();
    return true;
}

/// Scales the brush, or the tolerance of the wand.
void OutlineTool::scale(double factor) {
    OutlineSettings next = m_pen.now();
    if (m_shape == Shape::Brush)
        next.radius *= factor;
    else
        next.tolerance = std::max(0.01, next.tolerance * factor);
    m_pen.set(next);
}

void OutlineTool::cancel() {
    m_active = false;
    m_line.clear();
}

/// Returns the drawn area on the screen.
QPainterPath OutlineTool::area() const {
    if (m_line.isEmpty()) return {};
    if (m_shape == Shape::Lasso || m_shape == Shape::Polygon) return insideOf(m_line);
    return brushedAlong(m_line, m_shape == Shape::Cut ? kCut / 2 : m_pen.now().radius);
}

Outline OutlineTool::inPicture(const QPainterPath& area) const {
    Outline outline;
    for (const QPolygonF& polygon : area.simplified().toSubpathPolygons()) {
        auto& loop = outline.loops.emplace_back();
        for (const QPointF& p : polygon) loop.push_back(view().toShape(p));
        if (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    }
    std::erase_if(outline.loops, [](const auto& loop) { return loop.size() < 3; });
    return outline;
}

/// Returns the drawn line as a band of width kSlit. The normal of a corner is the mean of its sides' normals.
Outline OutlineTool::slit(double tolerance) const {
    std::vector<Vec2> way;
    for (const QPointF& p : m_line) way.push_back(view().toShape(p));
    way = wend::simplified<2>(way, tolerance);
    if (way.size() < 2) return {};
    const auto side = [&](std::size_t i) { return Vec2((way[i + 1] - way[i]).unitOrthogonal()); };
    std::vector<Vec2> loop(2 * way.size());
    for (std::size_t i = 0; i < way.size(); ++i) {
        const Vec2 before = side(i > 0 ? i - 1 : 0), after = side(std::min(i, way.size() - 2));
        const Vec2 sum = before + after, normal = sum.norm() > 0.1 ? sum.normalized() : before;
        loop[i] = way[i] + kSlit / 2 * normal;
        loop[loop.size() - 1 - i] = way[i] - kSlit / 2 * normal;
    }
    return combined({{loop}}, {}, OutlineOperation::Add);
}

Outline OutlineTool::piece() const {
    const double pixel = (view().toShape({1, 0}) - view().toShape({0, 0})).norm();
    if (m_shape == Shape::Cut) return slit(kOutlineDetail * pixel);
    const Outline clean = combined(inPicture(area()), {}, OutlineOperation::Add);
    return m_shape == Shape::Polygon ? clean : simplified(clean, kOutlineDetail * pixel);
}

/// Judges by the mean width: twice the area divided by the length of the border.
bool OutlineTool::isThin(const Outline& drawn) const {
    if (m_shape != Shape::Lasso && m_shape != Shape::Polygon) return false;
    double length = 0;
    for (const auto& loop : drawn.loops)
        for (std::size_t i = 0; i < loop.size(); ++i)
            length += (loop[(i + 1) % loop.size()] - loop[i]).norm();
    const double pixel = (view().toShape({1, 0}) - view().toShape({0, 0})).norm();
    return 2 * areaOf(drawn) < kThin * pixel * length;
}

/// Computed again only where it must be.
const Outline& OutlineTool::outlineOf(const Domain& domain) const {
    if (domain.outline == OutlineKind::Polygons) return domain.polygons;
    const Sheet own = sheet();
    if (!m_known || m_known->picture != own.picture || m_known->at != own.at ||
        m_known->kind != domain.outline || m_known->alpha != domain.alpha) {
        m_known = Known{own.picture, own.at, domain.outline, domain.alpha, {}};
        try {
            m_known->outline = shifted(domainOutline(domain, *own.picture), own.at);
        } catch (const InputError&) {  // fully transparent: the drawn area becomes the outline
        }
    }
    return m_known->outline;
}

void OutlineTool::finish(Qt::KeyboardModifiers modifiers) {
    const Outline drawn = piece();
    const bool isLine = isThin(drawn);
    cancel();
    if (isLine)
        return session().document().notify(QCoreApplication::translate(
            "OutlineTool", "That was a line. Draw around a part of the picture."));
    if (drawn.loops.empty()) return;
    if (makesPart()) return makePart(session(), drawn);
    apply(*session().document().project(), drawn, takesAway(modifiers));
}

void OutlineTool::takeColour(const QMouseEvent& event) {
    Document& document = session().document();
    if (makesPart()) {
        const Outline found =
            outlineOfColour(*document.picture(), view().toShape(event.position()), m_pen.now().tolerance);
        if (!found.loops.empty()) makePart(session(), found);
        return;
    }
    m_taken = Taken{view().toShape(event.position()), takesAway(event.modifiers()),
                    QStringLiteral("wand %1").arg(document.undoStack()->index()), document.project(),
                    document.project()};
    takeAgain();
}

/// Returns true until something else changes after the last click of the wand.
bool OutlineTool::isLive() const {
    return m_taken && m_taken->after == session().document().project();
}

Outline OutlineTool::outlineOfColourAt(const Vec2& at) const {
    const Sheet own = sheet();
    if (!own.picture) return {};
    return shifted(outlineOfColour(*own.picture, at - own.at, m_pen.now().tolerance), own.at);
}

/// Returns a project with that outline; pins outside it are gone, of a part those that name it.
std::shared_ptr<const Project> OutlineTool::withOutline(const Project& project, Outline outline,
                                                        int& pinsGone) const {
    const int one = part();
    if (one < 0) {
        const auto changed = copyOf(project);
        pinsGone = setOutline(*changed, std::move(outline));
        return changed;
    }
    return withDrawnOutline(project, one, std::move(outline), pinsGone);
}

/// Repeats the last click with the current tolerance, in the same undo step.
void OutlineTool::takeAgain() {
    if (!isLive()) return;
    const Outline found = outlineOfColourAt(m_taken->at);
    if (!found.loops.empty()) apply(*m_taken->before, found, m_taken->takesAway, m_taken->key);
    m_taken->after = session().document().project();
    view().redraw();
}

void OutlineTool::apply(const Project& project, const Outline& piece, bool takesAway, const QString& key) {
    Document& document = session().document();
    const Sheet own = sheet();
    if (!own.picture) return;
    const auto whole = wholeOf(project);
    const Outline& before = outlineOf(domainOf(*whole));
    const OutlineKind kind = domainOf(*whole).outline;
    const bool replaces = !takesAway && kind == OutlineKind::Frame;
    const Outline inside =
        combined(piece, shifted(frameOutline(own.picture->width, own.picture->height), own.at),
                 OutlineOperation::Keep);
    const auto operation = takesAway ? OutlineOperation::TakeAway : OutlineOperation::Add;
    const double smallest = m_shape == Shape::Cut ? 0 : kSmallest;
    Outline next = replaces ? combined(inside, {}, OutlineOperation::Add, smallest)
                            : combined(before, inside, operation, smallest);
    if (next.loops.empty()) {
        session().document().notify(
            QCoreApplication::translate("OutlineTool", "Nothing would be left of the shape."));
        return;
    }
    int pinsGone = 0;
    const auto changed = withOutline(project, std::move(next), pinsGone);
    if (pinsGone > 0) {
        session().selection().clear();
        session().document().notify(QCoreApplication::translate(
            "OutlineTool", "Pins outside the new outline were removed: %n.", nullptr, pinsGone));
    }
    const char* const name = m_shape == Shape::Cut ? QT_TRANSLATE_NOOP("OutlineTool", "Cut")
                             : takesAway ? QT_TRANSLATE_NOOP("OutlineTool", "Take away from the outline")
                                         : QT_TRANSLATE_NOOP("OutlineTool", "Add to the outline");
    if (pinsGone == 0 && kind == OutlineKind::Alpha)
        session().document().notify(QCoreApplication::translate(
            "OutlineTool",
            "From now on the outline is as you draw it, and has no margin to change. "
            "Choose “Cut-out” as the outline to go back to the one that was found."));
    document.change(QCoreApplication::translate("OutlineTool", name), changed, key);
}

void OutlineTool::paintOutline(QPainter& painter) const {
    const Sheet own = sheet();
    if (!own.picture) return;
    QPainterPath path;
    const auto whole = wholeOf(*session().document().project());
    for (const auto& loop : outlineOf(domainOf(*whole)).loops) {
        QPolygonF polygon;
        for (const Vec2& p : loop) polygon << view().toWidget(p);
        path.addPolygon(polygon);
        path.closeSubpath();
    }
    QPainterPath all;
    const Vec2 end = own.at + Vec2(own.picture->width, own.picture->height);
    all.addRect(QRectF(view().toWidget(own.at), view().toWidget(end)));
    all.addPath(path);  // even-odd rule: removes the area
    painter.setPen(Qt::NoPen);
    painter.setBrush(kLeftOut);
    painter.drawPath(all);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(255, 255, 255, 216), marked(3.5)));
    painter.drawPath(path);
    painter.setPen(QPen(QColor(kAccent), marked(1.5)));
    painter.drawPath(path);
}

/// Draws the document's outline, even before it is meshed, and the one being drawn.
void OutlineTool::paint(QPainter& painter) const {
    const Document& document = session().document();
    if (!document.picture() || document.domain().kind != DomainKind::Image) return;
    if (!makesPart() && !sheet().picture) return;
    if (document.domain().parts.empty() || !makesPart()) paintOutline(painter);
    m_cross.paint(painter);
    QColor colour = takesAway(m_modifiers) ? QColor(kAway) : QColor(kAccent);
    painter.setPen(QPen(colour, marked(1.5)));
    if (m_shape == Shape::Brush && m_over) painter.drawEllipse(m_at, m_pen.now().radius, m_pen.now().radius);
    if (!m_active) return;
    QPainterPath drawn = area();
    if (m_shape == Shape::Polygon) drawn.lineTo(m_at);
    colour.setAlpha(50);
    painter.setBrush(colour);
    painter.drawPath(drawn);
    if (m_shape == Shape::Polygon) painter.drawPolyline(QPolygonF(m_line) << m_at);
}

}  // namespace wend
