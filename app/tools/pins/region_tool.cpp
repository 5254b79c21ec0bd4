#include <QCoreApplication>
#include <functional>

#include "app/engine/motion/places.h"
#include "app/style/colours.h"
#include "app/style/marks.h"
#include "app/tools/pins/held_part.h"
#include "app/tools/region_outline.h"
#include "app/tools/tool_kinds.h"
#include "core/mesh/region.h"

namespace wend {

namespace {

/// Makes a handle of a region of a solid: a ball or block around a point of the surface, or the half-space
/// behind it. Shift adds its contents to the selected handle, Ctrl subtracts them.
class RegionTool : public ShapeTool<SolidShapeView> {
  public:
    enum class Shape { Ball, Block, Side };
    /// `done`: a region was taken hold of, and is there to be moved.
    RegionTool(SolidShapeView& view, Shape shape, std::function<void()> done)
        : ShapeTool<SolidShapeView>(view), m_shape(shape), m_done(std::move(done)) {}

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    void cancel() override { m_active = false; }
    void paint(QPainter& painter) const override;

  private:
    bool isClick() const { return QLineF(m_from, m_at).length() < 4; }
    Region<3> region() const;
    void take(Qt::KeyboardModifiers with);

    Shape m_shape;
    std::function<void()> m_done;
    bool m_active = false;
    QPointF m_from, m_at;
    // centre in the pose and at rest, and the solid's rotation there
    Vec3 m_centre = Vec3::Zero(), m_restCentre = Vec3::Zero();
    Mat3 m_turn = Mat3::Identity();
};

QString RegionTool::hint() const {
    if (m_shape == Shape::Ball)
        return QCoreApplication::translate(
            "RegionTool",
            "Drag from a point on the surface to hold a ball; Shift adds what is "
            "in it to the selected handle, Ctrl takes it away");
    if (m_shape == Shape::Side)
        return QCoreApplication::translate(
            "RegionTool",
            "Drag from a point on the surface towards the side to hold: all that lies beyond the point");
    return QCoreApplication::translate(
        "RegionTool",
        "Drag from a point on the surface to hold a box; Shift adds what is in it "
        "to the selected handle, Ctrl takes it away");
}

void RegionTool::press(const QMouseEvent& event) {
    m_from = m_at = event.position();
    const SolidHit hit = view().pick(m_at);
    const auto frame = session().motion().frame<3>();
    m_active = hit.cell >= 0 && frame;
    if (!m_active) return;
    m_centre = hit.point;
    m_restCentre = frame->restAt(frame->placeIn(hit.cell, hit.point));
    m_turn = frame->rotationOf(hit.cell);
}

void RegionTool::move(const QMouseEvent& event) {
    m_at = event.position();
    view().redraw();
}

/// Returns the region around the place in the rest shape, with the size drawn in the pose.
Region<3> RegionTool::region() const {
    const Vec3 way = m_turn.transpose() *
                     (acrossTheScreen(view(), m_centre, m_at) - acrossTheScreen(view(), m_centre, m_from));
    const double radius = way.norm();
    if (m_shape == Shape::Ball) return Ball<3>{m_restCentre, radius};
    if (m_shape == Shape::Side) return HalfSpace<3>{m_restCentre, way.normalized()};
    return Box<3>{m_restCentre.array() - radius, m_restCentre.array() + radius};
}

void RegionTool::release(const QMouseEvent& event) {
    m_at = event.position();
    if (std::exchange(m_active, false) && frame() && !isClick()) take(event.modifiers());
    view().redraw();
}

void RegionTool::take(Qt::KeyboardModifiers with) {
    const auto vertices = frame()->verticesInside(region());
    if (vertices.empty())
        return session().document().notify(
            QCoreApplication::translate("RegionTool", "There is no vertex in this region."));
    if (changePart(view(), vertices, with)) return;
    session().addHandle(region(), QCoreApplication::translate("RegionTool", "Region").toStdString());
    m_done();
}

bool RegionTool::key(const QKeyEvent& event) {
    if (event.key() != Qt::Key_Escape) return false;
    if (!std::exchange(m_active, false)) session().selection().clear();
    view().redraw();
    return true;
}

/// Draws the region where the solid now is, with the vertices in it.
void RegionTool::paint(QPainter& painter) const {
    const auto frame = session().motion().frame<3>();
    if (!m_active || isClick() || !frame) return;
    const Region<3> drawn = region();
    const auto& rest = frame->rest->points;
    painter.setPen(QPen(QColor(kAccent), marked(1.25)));
    painter.setBrush(Qt::NoBrush);
    for (const auto& line : regionOutline(drawn, rest.rowwise().minCoeff(), rest.rowwise().maxCoeff())) {
        QPolygonF screen;
        for (const Vec3& p : line) screen << view().onScreen(m_centre + m_turn * (p - m_restCentre));
        painter.drawPolyline(screen);
    }
    paintCaught(painter, view(), frame->verticesInside(drawn), m_at);
}

}  // namespace

ToolKind grabBallTool() {
    return toolKind(
        "ball", "area-ball", QT_TRANSLATE_NOOP("Tools", "Grab a B&all"),
        QT_TRANSLATE_NOOP("Tools", "Take hold of all that lies in a ball around a point on the surface"),
        "Shift+K", Mode::Pins, solidsOnly<RegionTool>(RegionTool::Shape::Ball, &Workbench::toSelect));
}

ToolKind grabBlockTool() {
    return toolKind(
        "block", "area-box", QT_TRANSLATE_NOOP("Tools", "Grab a Bloc&k"),
        QT_TRANSLATE_NOOP("Tools", "Take hold of all that lies in a block around a point on the surface"),
        "Shift+X", Mode::Pins, solidsOnly<RegionTool>(RegionTool::Shape::Block, &Workbench::toSelect));
}

ToolKind grabSideTool() {
    return toolKind("side", "area-half", QT_TRANSLATE_NOOP("Tools", "Grab &One Side"),
                    QT_TRANSLATE_NOOP(
                        "Tools", "Take hold of all that lies beyond a plane through a point on the surface"),
                    "Shift+P", Mode::Pins,
                    solidsOnly<RegionTool>(RegionTool::Shape::Side, &Workbench::toSelect));
}

}  // namespace wend
