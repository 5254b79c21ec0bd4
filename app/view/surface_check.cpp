#include "app/view/surface_check.h"

#include <Eigen/Geometry>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHash>
#include <QLocale>
#include <QSaveFile>
#include <QTextStream>

#include "app/document/domain.h"
#include "app/document/in_background.h"
#include "app/document/named_files.h"
#include "app/document/said.h"
#include "app/panels/marks.h"
#include "app/panels/surface_panel.h"
#include "app/session/caged_solid.h"
#include "app/view/volume/solid_canvas.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/skin_file.h"

namespace wend {

namespace {

const Vec<3> kAskew(-1, 1.4, -0.8);
const QRgb kFine = qRgb(199, 186, 164), kChosen = qRgb(255, 170, 0), kAdded = qRgb(46, 158, 92);

/// Points around some triangles, a little farther off than their corners.
Points<3> surroundingsOf(const Surface& surface, const std::vector<int>& triangles) {
    Points<3> corners(3, static_cast<Eigen::Index>(3 * triangles.size()));
    Eigen::Index count = 0;
    for (const int t : triangles)
        for (const int v : surface.triangles[t]) corners.col(count++) = surface.points.col(v);
    const Vec<3> centre = (corners.rowwise().minCoeff() + corners.rowwise().maxCoeff()) / 2;
    return (1.5 * (corners.colwise() - centre)).colwise() + centre;
}

/// False for what stands between the viewer and these points.
std::vector<bool> notBefore(const Surface& surface, const Points<3>& place, const Vec<3>& direction) {
    const Vec<3> low = place.rowwise().minCoeff(), high = place.rowwise().maxCoeff();
    const Vec<3> centre = (low + high) / 2, along = direction.normalized();
    const double radius = (high - low).norm() / 2;
    std::vector<bool> kept(surface.triangles.size(), true);
    for (int t = 0; t < surface.triangleCount(); ++t) {
        double last = -std::numeric_limits<double>::infinity(), beside = last;
        for (const int v : surface.triangles[t]) {
            const Vec<3> away = surface.points.col(v) - centre;
            last = std::max(last, away.dot(along));
            beside = std::max(beside, -(away - away.dot(along) * along).norm());
        }
        kept[t] = last > -radius / 2 || -beside > 3 * radius;
    }
    return kept;
}

/// Against the triangle's outer side, a little from above.
Vec<3> intoTriangle(const Surface& surface, int triangle) {
    const auto& t = surface.triangles[triangle];
    const Vec<3> a = surface.points.col(t[0]);
    const Vec<3> normal = (surface.points.col(t[1]) - a).cross(surface.points.col(t[2]) - a);
    if (!normal.allFinite() || normal.norm() == 0) return kAskew;
    return -normal.normalized() + Vec<3>(0.15, 0.25, -0.3);
}

/// The triangles that are not as they should be.
std::vector<int> markedIn(const VolumePicture& picture) {
    std::vector<int> marked;
    for (int t = 0; t < static_cast<int>(picture.cellColours.size()); ++t)
        if (picture.cellColours[t] != kFine) marked.push_back(t);
    return marked;
}

template <class List, class Text>
void writeList(QTextStream& out, const char* title, const List& list, const Text& text) {
    if (list.empty()) return;
    out << title << ' ' << list.size() << '\n';
    for (const auto& entry : list) out << text(entry) << '\n';
}

void writeProblems(QTextStream& out, const SurfaceProblems& problems) {
    const auto one = [](int i) { return QString::number(i); };
    const auto two = [](const std::array<int, 2>& p) { return QStringLiteral("%1 %2").arg(p[0]).arg(p[1]); };
    out << "# Numbers count from 0. Triangles unless edges (two vertices) are named.\n";
    writeList(out, "degenerate", problems.degenerate, one);
    writeList(out, "duplicate", problems.duplicate, one);
    writeList(out, "bad_index", problems.badIndex, one);
    writeList(out, "intersecting_pairs", problems.intersecting, two);
    writeList(out, "open_edges", problems.openEdges, two);
    writeList(out, "non_manifold_edges", problems.nonManifoldEdges, two);
    writeList(out, "misoriented_edges", problems.misoriented, two);
    writeList(out, "vertices_not_finite", problems.notFinite, one);
}

}  // namespace

SurfaceCheck::SurfaceCheck(ShapeSession& session, SurfacePanel& panel, QWidget& window)
    : QObject(&window), m_session(session), m_panel(panel), m_window(window) {
    connect(&session, &ShapeSession::problem, this, [this](const QString& text) {
        hide();
        m_isCaged = false;
        const Document& document = m_session.document();
        const bool surface = document.dimension() == 3 && document.domain().kind == DomainKind::Surface;
        if (!text.isEmpty() && surface && m_canvas) look();
    });
    connect(&session.document(), &Document::opened, this, [this] {
        hide();
        preview();
    });
    connect(&session, &ShapeSession::frameChanged, this, &SurfaceCheck::takeShape);
    connect(&panel, &SurfacePanel::caseChosen, this, &SurfaceCheck::showCase);
    connect(&panel, &SurfacePanel::solidWanted, this, &SurfaceCheck::showSolid);
    connect(&panel, &SurfacePanel::fitRequested, this, &SurfaceCheck::fitCage);
    connect(&panel, &SurfacePanel::saveRequested, this, &SurfaceCheck::saveList);
    connect(&panel, &SurfacePanel::repairRequested, this, &SurfaceCheck::repair);
    connect(&panel, &SurfacePanel::repairShown, this, &SurfaceCheck::showRepair);
}

void SurfaceCheck::hide() {
    m_found.reset();
    m_panel.hide();
}

/// What is wrong with a file that cannot be read is told elsewhere.
void SurfaceCheck::preview() {
    const Document& document = m_session.document();
    if (document.dimension() != 3 || document.domain().kind != DomainKind::Surface) return;
    const std::string path = pathIn(document.folder().toStdString(), document.domain().path);
    const int generation = document.generation();
    const auto read = [path]() -> std::shared_ptr<const Skin> {
        try {
            return std::make_shared<const Skin>(readSkin(path));
        } catch (const std::exception&) {
            return {};
        }
    };
    inBackground(this, read, [this, generation](const std::shared_ptr<const Skin>& skin) {
        if (skin && m_canvas && m_session.document().generation() == generation) m_canvas->showPreview(skin);
    });
}

void SurfaceCheck::look() {
    const Document& document = m_session.document();
    const std::string path = pathIn(document.folder().toStdString(), document.domain().path);
    const int generation = document.generation();
    const int largestHole = document.domain().largestHole;
    const auto check = [path, largestHole]() -> std::shared_ptr<const Found> {
        auto found = std::make_shared<Found>();
        try {
            const MeshFile file = readMeshFile(path);
            found->surface = {file.points, file.triangles, {}};
            found->problems = checkSurface(found->surface);
            found->faults = faultsOf(found->surface, found->problems);
            found->repaired = repairSurface(found->surface, largestHole, found->report);
            found->left = checkSurface(found->repaired);
        } catch (const std::exception& error) {
            found->error = said(error);
        }
        return found;
    };
    inBackground(this, check, [this, generation](const std::shared_ptr<const Found>& found) {
        if (m_session.document().generation() == generation) take(found);
    });
}

/// A cage that was chosen since something is wrong is no reason not to look at it.
void SurfaceCheck::takeShape() {
    const auto frame = m_session.frame<3>();
    if (!frame || frame->shape == m_shape) return;
    m_shape = frame->shape;
    m_isCaged =
        frame->built->source && frame->built->skin && isCage(*frame->built->source, *frame->built->skin);
    hide();
    if (m_isCaged && m_session.document().domain().fit == Fit::Automatic && m_canvas) look();
}

/// Files whose trouble is another one (that cannot be read …) are told by the banner alone.
void SurfaceCheck::take(const std::shared_ptr<const Found>& found) {
    if (!found->error.isEmpty() || found->problems.boundsVolume()) return;
    m_found = found;
    SurfacePanel::Contents contents;
    const QHash<QString, QString> names{{QStringLiteral("missing_vertex"), tr("Triangles of missing points")},
                                        {QStringLiteral("crossing"), tr("Triangles that cross")},
                                        {QStringLiteral("hole"), tr("Holes")},
                                        {QStringLiteral("crowded_edge"), tr("Edges of more than two")},
                                        {QStringLiteral("flat"), tr("Triangles without area")},
                                        {QStringLiteral("duplicate"), tr("Double triangles")},
                                        {QStringLiteral("turned_edge"), tr("Turned neighbours")}};
    for (const FaultKind& kind : found->faults)
        contents.kinds.push_back(
            {names.value(QString::fromStdString(kind.name)), static_cast<int>(kind.cases.size())});
    if (found->problems.flat) contents.more << tr("All points lie in one plane.");
    const Domain& domain = m_session.document().domain();
    contents.mayRepair = found->left.boundsVolume() && !domain.repair;
    contents.repair = domain.repair ? QString() : repairText();
    contents.isCaged = m_isCaged;
    contents.largestHole = domain.largestHole;
    m_panel.showProblems(contents);
    m_panel.show();
    if (!m_isCaged) showSurface();
}

/// The triangles that are kept, in colours: wrong ones, and among them the chosen ones.
VolumePicture SurfaceCheck::picture(const std::vector<bool>& kept, const std::vector<int>& chosen) const {
    const Surface& surface = m_found->surface;
    std::vector<QRgb> all(surface.triangles.size(), kFine);
    for (const int t : m_found->problems.triangles(surface)) all[t] = kWrong;
    for (const int t : chosen) all[t] = kChosen;
    std::vector<std::array<int, 3>> triangles;
    std::vector<QRgb> colours;
    for (std::size_t t = 0; t < all.size(); ++t) {
        if (!kept[t] && all[t] == kFine) continue;
        triangles.push_back(surface.triangles[t]);
        colours.push_back(all[t]);
    }
    VolumePicture picture = pictureOfSurface(surface.points, triangles, std::move(colours));
    picture.marked = markedIn(picture);
    picture.isOpen = true;
    return picture;
}

void SurfaceCheck::showSurface() {
    if (!m_found || !m_canvas) return;
    m_canvas->setCutKind(CutKind::None);
    m_canvas->showRefused(picture(std::vector<bool>(m_found->surface.triangles.size(), true), {}),
                          directionToWrong());
}

/// From where the first wrong triangle is seen.
Vec<3> SurfaceCheck::directionToWrong() const {
    const auto wrong = m_found->problems.triangles(m_found->surface);
    return wrong.empty() ? kAskew : intoTriangle(m_found->surface, wrong.front());
}

void SurfaceCheck::showCase(int kind, int number) {
    if (!m_found || !m_canvas || kind >= static_cast<int>(m_found->faults.size())) return;
    const std::vector<int>& chosen = m_found->faults[kind].cases[number];
    if (chosen.empty()) return;
    const Surface& surface = m_found->surface;
    const Vec<3> direction = intoTriangle(surface, chosen.front());
    const Points<3> place = surroundingsOf(surface, chosen);
    m_canvas->setCutKind(CutKind::None);
    m_canvas->showPlace(picture(notBefore(surface, place, direction), chosen), direction, place);
}

void SurfaceCheck::showSolid() {
    if (!m_canvas) return;
    if (m_isCaged) return m_canvas->showSolid();
    showSurface();
    m_canvas->lookAlong(directionToWrong());
}

void SurfaceCheck::saveList() {
    if (!m_found) return;
    const Document& document = m_session.document();
    const QString base = QFileInfo(document.displayName()).completeBaseName();
    const QString path = QFileDialog::getSaveFileName(
        &m_window, tr("Save List"), QDir(document.folder()).filePath(base + QStringLiteral("-problems.txt")),
        tr("Text (*.txt)"));
    if (path.isEmpty()) return;
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly | QIODevice::Text)) return;
    QTextStream out(&file);
    writeProblems(out, m_found->problems);
    out.flush();
    file.commit();
}

void SurfaceCheck::repair(int largestHole) {
    Document& document = m_session.document();
    Domain next = document.domain();
    next.repair = true;
    next.largestHole = largestHole;
    document.changeDomain(tr("Repair surface"), std::move(next));
}

/// One part of a sentence for each repair that would change something.
QString SurfaceCheck::repairText() const {
    const RepairReport& report = m_found->report;
    QStringList parts;
    const auto add = [&parts](const QString& text, int count) {
        if (count > 0) parts << text.arg(QLocale().toString(count));
    };
    add(tr("merge points (%1)"), report.mergedVertices);
    add(tr("drop triangles (%1)"), report.droppedDegenerate + report.droppedDuplicate);
    add(tr("turn triangles (%1)"), report.flipped);
    add(tr("fill holes (%1)"), report.filledHoles);
    return parts.isEmpty() ? QString() : tr("It would %1.").arg(parts.join(QStringLiteral(", ")));
}

/// What fills holes in a colour of its own.
void SurfaceCheck::showRepair(bool shown) {
    if (!m_found || !m_canvas) return;
    if (!shown) return showSolid();
    const Surface& surface = m_found->repaired;
    const int kept = surface.triangleCount() - m_found->report.addedTriangles;
    std::vector<QRgb> colours(surface.triangles.size(), kFine);
    std::fill(colours.begin() + kept, colours.end(), kAdded);
    for (const int t : m_found->left.triangles(surface)) colours[t] = kWrong;
    const Vec<3> direction =
        kept < surface.triangleCount() ? intoTriangle(surface, kept) : directionToWrong();
    VolumePicture picture = pictureOfSurface(surface.points, surface.triangles, std::move(colours));
    picture.marked = markedIn(picture);
    picture.isOpen = !m_found->left.boundsVolume();
    m_canvas->setCutKind(CutKind::None);
    m_canvas->showRefused(std::move(picture), direction);
}

void SurfaceCheck::fitCage(bool cage) {
    Document& document = m_session.document();
    Domain next = document.domain();
    next.fit = cage ? Fit::Cage : Fit::Exact;
    document.changeDomain(cage ? tr("Fit a cage") : tr("Exact surface only"), std::move(next));
}

}  // namespace wend
