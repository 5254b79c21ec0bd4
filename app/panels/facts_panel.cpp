#include "app/panels/facts_panel.h"

#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>
#include <algorithm>

#include "app/base/connect_each.h"
#include "app/engine/shape/inspection.h"
#include "app/engine/shape/shape.h"
#include "app/engine/shape/stated_units.h"
#include "app/panels/fields/controls.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/reasons.h"
#include "app/project/domain.h"
#include "app/project/file/named_files.h"

namespace wend {

namespace {

QString rounded(double x) {
    return QLocale().toString(x, 'g', 4);
}

QString asTable(const QString& title, const QString& lines) {
    return QStringLiteral("<b>%1</b><table>").arg(title.toHtmlEscaped()) + lines + QStringLiteral("</table>");
}

/// Returns the lines of the table.
QString factsText(const MeshInspection& found, const QString& unit) {
    const SurfaceFacts& facts = *found.facts;
    const auto with = [&unit](const QString& value, const char* power) {
        return unit.isEmpty() ? value : value + ' ' + unit + QString::fromUtf8(power);
    };
    const auto count = [](int n) { return QLocale().toString(n); };
    const Vec3 size = facts.high - facts.low;
    QString lines =
        tableLine(
            FactsPanel::tr("size"),
            with(QStringLiteral("%1 × %2 × %3").arg(rounded(size[0]), rounded(size[1]), rounded(size[2])),
                 "")) +
        tableLine(FactsPanel::tr("area"), with(rounded(facts.area), "²"));
    if (found.volume > 0) lines += tableLine(FactsPanel::tr("volume"), with(rounded(found.volume), "³"));
    lines += tableLine(FactsPanel::tr("triangles"), count(found.triangles > 0 ? found.triangles : 0)) +
             tableLine(
                 FactsPanel::tr("edges"),
                 with(FactsPanel::tr("%1 to %2").arg(rounded(facts.shortestEdge), rounded(facts.longestEdge)),
                      "")) +
             tableLine(FactsPanel::tr("mean edge"), with(rounded(facts.meanEdge), "")) +
             tableLine(FactsPanel::tr("parts"), count(facts.parts)) +
             tableLine(FactsPanel::tr("boundary loops"), count(facts.boundaryLoops));
    if (facts.genus) lines += tableLine(FactsPanel::tr("genus"), count(*facts.genus));
    if (facts.sides == 1) lines += tableLine(FactsPanel::tr("sides"), count(1));
    if (found.intersectingPairs)
        lines += tableLine(FactsPanel::tr("crossing pairs"), count(*found.intersectingPairs));
    return lines;
}

QString factsOfFile(const std::string& path) {
    const MeshInspection found = inspectFile(path);
    const QString unit = QString::fromStdString(statedUnits(path));
    return found.facts ? factsText(found, unit) : QString();
}

int nearestCell(const SimplicialMesh<3>& mesh, const Vec3& place) {
    double least = std::numeric_limits<double>::infinity();
    int nearest = -1;
    for (int c = 0; c < mesh.cellCount(); ++c) {
        Vec3 centre = Vec3::Zero();
        for (const int v : mesh.cells[c]) centre += mesh.points.col(v) / 4;
        const double distance = (centre - place).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        nearest = c;
    }
    return nearest;
}

}  // namespace

FactsPanel::FactsPanel(Document& document, ShapeMotion& motion, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_motion(motion),
      m_surface(secondLabel({}, this)),
      m_mesh(secondLabel({}, this)),
      m_cage(secondLabel({}, this)),
      m_worst(pushButton(this, "", tr("Worst cell"), tr("Goes to the tetrahedron with the largest ratio."),
                         [this] {
                             const auto frame = m_motion.frame<3>();
                             if (frame && frame->built->verdict)
                                 emit cellWanted(frame->built->verdict->worstCell);
                         })),
      m_gap(pushButton(this, "", tr("Next gap"),
                       tr("Goes through the gaps that the cage closes, one after another."),
                       &FactsPanel::goToGap)),
      m_open(pushButton(this, "", tr("Open the widest"),
                        tr("Makes the cage so fine that the widest of these gaps stays open."),
                        &FactsPanel::openGap)) {
    arrange();
    describe(m_surface, tr("Facts of the file"),
             tr("The surface as it is in its file. Lengths are in the file's units, which few files name."));
    describe(m_mesh, tr("Quality of the cells"),
             tr("Circumradius over shortest edge of the worst tetrahedron, what was asked for, how many are "
                "above that, and how many triangles of the surface force them."));
    describe(m_cage, tr("Closed gaps"),
             tr("Gaps within one part that the cage closes: what lies on both sides moves together."));
    connectEach(this, &FactsPanel::refresh, &motion, &ShapeMotion::frameChanged, &document,
                &Document::projectChanged);
}

void FactsPanel::arrange() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 4, 16, 14);
    layout->setSpacing(10);
    m_surface->setObjectName(QStringLiteral("factsOfFile"));
    m_mesh->setObjectName(QStringLiteral("factsOfCells"));
    m_cage->setObjectName(QStringLiteral("factsOfCage"));
    for (QLabel* label : {m_surface, m_mesh, m_cage}) {
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        label->setTextFormat(Qt::RichText);
    }
    layout->addWidget(m_surface);
    layout->addWidget(m_mesh);
    layout->addWidget(m_worst);
    layout->addWidget(m_cage);
    layout->addLayout(sideBySide({m_gap, m_open}));
}

void FactsPanel::showEvent(QShowEvent*) {
    refresh();
}

void FactsPanel::refresh() {
    if (!isVisible() || m_motion.isDragging() || m_document.dimension() != 3) return;
    lookAtFile();
    const auto frame = m_motion.frame<3>();
    const Shape<3> none;
    const Shape<3>& shape = frame ? *frame->built : none;
    if (frame && std::exchange(m_shape, frame->shape) != frame->shape) m_nextGap = 0;
    showMesh(shape);
    showCage(shape);
}

/// Reads each opened file once.
void FactsPanel::lookAtFile() {
    const Document& document = m_document;
    const QString path =
        QString::fromStdString(pathIn(document.folder().toStdString(), document.domain().path));
    if (path == m_path && document.generation() == m_generation) return;
    m_path = path;
    m_generation = document.generation();
    m_surface->setText(tr("Looking at the file …"));
    const auto look = [path]() -> QString { return factsOfFile(path.toStdString()); };
    m_looking.ask(look, [this](const Answer<QString>& lines) {  // what is wrong is reported elsewhere
        m_surface->setVisible(!lines.value.isEmpty());
        m_surface->setText(asTable(tr("Surface of the file"), lines.value));
    });
}

void FactsPanel::showMesh(const Shape<3>& shape) {
    const auto& verdict = shape.verdict;
    for (QWidget* widget : std::initializer_list<QWidget*>{m_mesh, m_worst})
        widget->setVisible(verdict.has_value());
    if (!verdict) return;
    const QLocale locale;
    QString lines = tableLine(tr("worst ratio"), rounded(verdict->got)) +
                    tableLine(tr("asked for"), rounded(verdict->asked)) +
                    tableLine(tr("cells above"), locale.toString(verdict->cellsAbove));
    if (!verdict->facets.empty())
        lines += tableLine(tr("forced by triangles"), locale.toString(int(verdict->facets.size())));
    m_mesh->setText(asTable(tr("Tetrahedra"), lines));
}

void FactsPanel::showCage(const Shape<3>& shape) {
    const int gaps = shape.cage ? static_cast<int>(shape.cage->gaps.size()) : 0;
    for (QWidget* widget : std::initializer_list<QWidget*>{m_cage, m_gap, m_open})
        widget->setVisible(gaps > 0);
    if (gaps == 0) return;
    allow(m_open, shape.cage->opener.helps(), tr("That would take more than a million vertices."));
    m_cage->setText(
        asTable(tr("Cage"), tableLine(tr("closed gaps"), QLocale().toString(gaps)) +
                                tableLine(tr("narrowest"), rounded(shape.cage->gaps.front().width))));
}

void FactsPanel::goToGap() {
    const auto frame = m_motion.frame<3>();
    if (!frame || !frame->built->cage || frame->built->cage->gaps.empty()) return;
    const auto& gaps = frame->built->cage->gaps;
    emit cellWanted(nearestCell(*frame->rest, gaps[m_nextGap++ % gaps.size()].place));
}

void FactsPanel::openGap() {
    const auto frame = m_motion.frame<3>();
    if (!frame || !frame->built->cage) return;
    Document& document = m_document;
    Domain next = document.domain();
    frame->built->cage->opener.applyTo(next);
    document.changeDomain(tr("Open a gap"), std::move(next));
}

}  // namespace wend
