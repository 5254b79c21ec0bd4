#include "app/panels/measure_panel.h"

#include <QLabel>
#include <QLocale>
#include <cmath>
#include <numbers>
#include <set>

#include "app/engine/motion/fields.h"
#include "app/engine/motion/places.h"
#include "app/engine/shape/shape.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/legend.h"
#include "app/project/design.h"
#include "app/session/calm_follower.h"
#include "app/style/colour_map.h"
#include "core/mesh/quality.h"

namespace wend {

namespace {

constexpr double kLeastError = 1e-12;  // an error below it is none

QString inDigits(double x) {
    return QLocale().toString(x, 'g', 5);
}

QString place(const Vec3& p, double diagonal) {
    const auto one = [diagonal](double x) { return inDigits(std::abs(x) < 1e-9 * diagonal ? 0.0 : x); };
    return QStringLiteral("%1, %2, %3").arg(one(p.x()), one(p.y()), one(p.z()));
}

/// Returns the quality of one cell.
QualitySummary shapeOf(const Points3& points, const Cell<3>& cell) {
    SimplicialMesh<3> one;
    one.points.resize(3, 4);
    for (int k = 0; k < 4; ++k) one.points.col(k) = points.col(cell[k]);
    one.cells = {{0, 1, 2, 3}};
    return qualityOf<3>(one);
}

QString degrees(double radians) {
    return QLocale().toString(radians * 180 / std::numbers::pi, 'f', 1) + QStringLiteral("°");
}

/// Values at rest that are only rounding become zero.
double shownValue(const PosedFrame<3>& frame, const Eigen::MatrixXd& velocity, Measure measure, int cell) {
    const double value = cellValue(frame, measure, cell, velocity);
    return isDistortion(measure) && std::abs(value) < kLeastError ? 0 : value;
}

}  // namespace

MeasurePanel::MeasurePanel(ShapeMotion& motion, Selection& selection, const ShownPins& pins, QWidget* parent)
    : QWidget(parent),
      m_motion(motion),
      m_selection(selection),
      m_shown(pins),
      m_whole(secondLabel({}, this)),
      m_part(secondLabel({}, this)),
      m_point(secondLabel({}, this)),
      m_cell(secondLabel({}, this)) {
    auto* layout = sectionColumn(this);
    layout->addWidget(panelTitle(tr("Measures"), this));
    m_whole->setObjectName(QStringLiteral("measureWhole"));
    m_part->setObjectName(QStringLiteral("measurePart"));
    m_point->setObjectName(QStringLiteral("measurePoint"));
    m_cell->setObjectName(QStringLiteral("measureCell"));
    for (QLabel* label : {m_whole, m_part, m_point, m_cell}) {
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        label->setTextFormat(Qt::RichText);
        layout->addWidget(label);
    }
    describe(m_whole, tr("Size of the solid"), tr("Volume and area of the surface, now and at rest."));
    describe(m_part, tr("Size of what is selected"),
             tr("Volume of the tetrahedra and area of the outer triangles that the selected handles hold."));
    describe(m_point, tr("Vertex under the pointer"), tr("The nearest vertex and where it is."));
    describe(m_cell, tr("Tetrahedron under the pointer"), tr("All values of the tetrahedron."));
    new CalmFollower(
        motion, this, [this] { refresh(); }, &motion, &ShapeMotion::frameChanged, &selection,
        &Selection::changed);
}

void MeasurePanel::setPointed(int cell, int vertex, const Vec3& point) {
    m_pointedCell = cell;
    m_vertex = vertex;
    m_at = point;
    if (isVisible()) showPointed();
}

void MeasurePanel::showEvent(QShowEvent*) {
    refresh();
}

void MeasurePanel::refresh() {
    if (!isVisible() || m_motion.isDragging()) return;
    showSizes();
    showPointed();
}

void MeasurePanel::showSizes() {
    const auto frame = m_motion.frame<3>();
    if (!frame || !frame->built->facets) return;
    const auto text = [](const QString& title, const SolidSize& now, const SolidSize& rest) {
        const QString both = tr("%1, at rest %2");
        return QStringLiteral("<b>%1</b><table>").arg(title.toHtmlEscaped()) +
               tableLine(tr("volume"), both.arg(inDigits(now.volume), inDigits(rest.volume))) +
               tableLine(tr("area"), both.arg(inDigits(now.area), inDigits(rest.area))) +
               QStringLiteral("</table>");
    };
    m_whole->setText(text(tr("The whole"), sizeOf(*frame, frame->pose), sizeOf(*frame, frame->rest->points)));
    std::vector<int> held;
    for (const int handle : m_selection.handles())
        if (handle < static_cast<int>(m_motion.document().design().handles.size()))
            for (const int v : m_shown.verticesOf(handle)) held.push_back(v);
    m_part->setVisible(!held.empty());
    if (held.empty()) return;
    m_part->setText(text(tr("Selected vertices: %n", nullptr,
                            static_cast<int>(std::set<int>(held.begin(), held.end()).size())),
                         sizeOf(*frame, frame->pose, held), sizeOf(*frame, frame->rest->points, held)));
}

void MeasurePanel::showPointed() {
    const auto frame = m_motion.frame<3>();
    const bool has = frame && m_pointedCell >= 0 && m_pointedCell < frame->cells && m_vertex >= 0 &&
                     m_vertex < frame->vertices;
    if (!has) {
        m_point->setText(tr("Point at the solid to see the values there."));
        m_cell->clear();
        return;
    }
    const Eigen::MatrixXd velocity = m_motion.velocity();
    m_point->setText(QStringLiteral("<b>%1</b><table>").arg(tr("Vertex %1").arg(m_vertex)) +
                     tableLine(tr("place"), place(frame->pose.col(m_vertex), frame->diagonal)) +
                     tableLine(tr("at rest"), place(frame->rest->points.col(m_vertex), frame->diagonal)) +
                     tableLine(tr("pointed at"), place(m_at, frame->diagonal)) +
                     tableLine(tr("velocity"), velocity.cols()
                                                   ? place(velocity.col(m_vertex), frame->diagonal)
                                                   : QStringLiteral("–")) +
                     QStringLiteral("</table>"));
    const Cell<3>& cell = frame->rest->cells[m_pointedCell];
    QString rows =
        tableLine(tr("volume"), tr("%1, at rest %2")
                                    .arg(inDigits(std::abs(cellMeasure<3>(frame->pose, cell))),
                                         inDigits(std::abs(cellMeasure<3>(frame->rest->points, cell)))));
    const QualitySummary shape = shapeOf(frame->pose, cell);
    rows += tableLine(tr("dihedral angles"),
                      tr("%1 to %2").arg(degrees(shape.minAngle), degrees(shape.maxAngle)));
    rows += tableLine(tr("circumradius to shortest edge"), inDigits(shape.maxRadiusEdgeRatio));
    for (const Measure measure : measuresOf(3))
        rows += tableLine(measureName(measure, 3),
                          measureText(measure, shownValue(*frame, velocity, measure, m_pointedCell)));
    m_cell->setText(QStringLiteral("<b>%1</b><table>").arg(tr("Tetrahedron %1").arg(m_pointedCell)) + rows +
                    QStringLiteral("</table>"));
}

}  // namespace wend
