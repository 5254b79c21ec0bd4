#include "app/window/surface/surface_check.h"

#include <Eigen/Geometry>
#include <QByteArray>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHash>
#include <QLocale>
#include <QSaveFile>
#include <QStringList>
#include <QTextStream>
#include <limits>
#include <map>
#include <utility>

#include "app/base/in_background.h"
#include "app/engine/motion/playback.h"
#include "app/engine/shape/shape.h"
#include "app/panels/surface_panel.h"
#include "app/project/domain.h"
#include "app/project/file/named_files.h"
#include "app/session/shape_motion.h"
#include "app/style/marks.h"
#include "app/views/volume/solid_canvas.h"
#include "core/base/disjoint_sets.h"
#include "core/base/error.h"
#include "core/mesh/mesh_of_file.h"
#include "core/mesh/skin_file.h"
#include "core/meshing/fix_all.h"
#include "core/meshing/surface.h"

namespace wend {

namespace {

/// The default direction of view on a surface.
const Vec3 kAskew(-1, 1.4, -0.8);

/// Returns points around some triangles, a little farther away than their corners.
Points3 surroundingsOf(const Surface& surface, const std::vector<int>& triangles) {
    Points3 corners(3, static_cast<Eigen::Index>(3 * triangles.size()));
    Eigen::Index count = 0;
    for (const int t : triangles)
        for (const int v : surface.triangles[t]) corners.col(count++) = surface.points.col(v);
    const Vec3 centre = (corners.rowwise().minCoeff() + corners.rowwise().maxCoeff()) / 2;
    return (1.5 * (corners.colwise() - centre)).colwise() + centre;
}

/// Returns false for triangles between the viewer and these points.
std::vector<bool> notBefore(const Surface& surface, const Points3& place, const Vec3& direction) {
    const Vec3 low = place.rowwise().minCoeff(), high = place.rowwise().maxCoeff();
    const Vec3 centre = (low + high) / 2, along = direction.normalized();
    const double radius = (high - low).norm() / 2;
    std::vector<bool> kept(surface.triangles.size(), true);
    for (int t = 0; t < surface.triangleCount(); ++t) {
        double last = -std::numeric_limits<double>::infinity(), beside = last;
        for (const int v : surface.triangles[t]) {
            const Vec3 away = surface.points.col(v) - centre;
            last = std::max(last, away.dot(along));
            beside = std::max(beside, -(away - away.dot(along) * along).norm());
        }
        kept[t] = last > -radius / 2 || -beside > 3 * radius;
    }
    return kept;
}

/// Returns the direction against the triangle's outer side, slightly from above.
Vec3 intoTriangle(const Surface& surface, int triangle) {
    const auto& t = surface.triangles[triangle];
    const Vec3 a = surface.points.col(t[0]);
    const Vec3 normal = (surface.points.col(t[1]) - a).cross(surface.points.col(t[2]) - a);
    if (!normal.allFinite() || normal.norm() == 0) return kAskew;
    return -normal.normalized() + Vec3(0.15, 0.25, -0.3);
}

template <class List, class Text>
void writeList(QTextStream& out, const char* title, const List& list, const Text& text) {
    if (list.empty()) return;
    out << title << ' ' << list.size() << '\n';
    for (const auto& entry : list) out << text(entry) << '\n';
}

/// Lists all faults of a surface as the text of a file; `numbers` are those of its triangles.
QByteArray listOf(const SurfaceProblems& problems, const std::vector<int>& numbers) {
    QByteArray text;
    QTextStream out(&text);
    const auto one = [&](int t) { return QString::number(numbers[t]); };
    const auto pair = [](int a, int b) { return QStringLiteral("%1 %2").arg(a).arg(b); };
    const auto two = [&](const std::array<int, 2>& p) { return pair(numbers[p[0]], numbers[p[1]]); };
    const auto edge = [&](const std::array<int, 2>& p) { return pair(p[0], p[1]); };
    const auto vertex = [](int v) { return QString::number(v); };
    out << "# Numbers count from 0. Triangles unless edges (two vertices) are named.\n";
    writeList(out, "degenerate", problems.degenerate, one);
    writeList(out, "duplicate", problems.duplicate, one);
    writeList(out, "bad_index", problems.badIndex, one);
    writeList(out, "intersecting_pairs", problems.intersecting, two);
    writeList(out, "open_edges", problems.openEdges, edge);
    writeList(out, "non_manifold_edges", problems.nonManifoldEdges, edge);
    writeList(out, "misoriented_edges", problems.misoriented, edge);
    writeList(out, "vertices_not_finite", problems.notFinite, vertex);
    out.flush();
    return text;
}

const QRgb kFine = qRgb(199, 186, 164), kChosen = qRgb(255, 170, 0), kAdded = qRgb(46, 158, 92);

/// Returns the triangles that have a fault or are chosen.
std::vector<int> markedIn(const VolumePicture& picture) {
    std::vector<int> marked;
    for (int t = 0; t < static_cast<int>(picture.cellColours.size()); ++t)
        if (picture.cellColours[t] != kFine) marked.push_back(t);
    return marked;
}

/// Returns nothing if the file has changed since the fixes were made.
std::vector<SurfaceFix> possible(const Surface& source, const std::vector<SurfaceFix>& fixes) {
    try {
        fixSurface(source, fixes);
        return fixes;
    } catch (const InputError&) {
        return {};
    }
}

}  // namespace

SurfaceCheck::SurfaceCheck(Document& document, const Playback& playback, const ShapeMotion& motion,
                           SurfacePanel& panel, QWidget& window)
    : QObject(&window),
      m_document(document),
      m_playback(playback),
      m_motion(motion),
      m_panel(panel),
      m_window(window) {
    connect(&motion, &ShapeMotion::problem, this, [this](const QString& text) {
        hide();
        m_isCaged = false;
        const bool surface = m_document.dimension() == 3 && m_document.domain().kind == DomainKind::Surface;
        if (!text.isEmpty() && surface && m_canvas) look();
    });
    connect(&document, &Document::opened, this, [this] {
        hide();
        m_checking.drop();
        m_reading.drop();
        preview();
    });
    connect(&motion, &ShapeMotion::frameChanged, this, &SurfaceCheck::takeShape);
    connect(&panel, &SurfacePanel::caseChosen, this, &SurfaceCheck::showCase);
    connect(&panel, &SurfacePanel::solidWanted, this, &SurfaceCheck::showSolid);
    connect(&panel, &SurfacePanel::fitRequested, this, &SurfaceCheck::fitCage);
    connect(&panel, &SurfacePanel::saveRequested, this, &SurfaceCheck::saveList);
    connect(&panel, &SurfacePanel::fixRequested, this, [this] { fix(m_fix, tr("Fix one fault")); });
    connect(&panel, &SurfacePanel::fixAllRequested, this, &SurfaceCheck::fixAll);
    connect(&panel, &SurfacePanel::fixOfAllShown, this, &SurfaceCheck::showFixOfAll);
    connect(&panel, &SurfacePanel::repairRequested, this, &SurfaceCheck::repair);
    connect(&panel, &SurfacePanel::limitChanged, this, &SurfaceCheck::tryLimit);
    connect(&panel, &SurfacePanel::repairShown, this, &SurfaceCheck::showRepair);
}

void SurfaceCheck::hide() {
    m_found.reset();
    m_fix.reset();
    m_all = {};
    m_isPlaceShown = false;
    m_panel.hide();
}

void SurfaceCheck::leave() {
    if (!m_isCaged || !m_canvas || !m_panel.leave()) return;
    m_isPlaceShown = false;
    m_canvas->showLooks();
}

/// Read errors are reported by the loader.
void SurfaceCheck::preview() {
    if (m_document.dimension() != 3 || m_document.domain().kind != DomainKind::Surface) return;
    const std::string path = pathIn(m_document.folder().toStdString(), m_document.domain().path);
    using SkinPtr = std::shared_ptr<const Skin>;
    const auto read = [path]() -> SkinPtr { return std::make_shared<const Skin>(readSkin(path)); };
    m_reading.ask(read, [this](const Answer<SkinPtr>& skin) {
        if (skin.value && m_canvas) m_canvas->showPreview(*skin.value);
    });
}

void SurfaceCheck::look() {
    const std::string path = pathIn(m_document.folder().toStdString(), m_document.domain().path);
    using FoundPtr = std::shared_ptr<const Found>;
    const int largestHole = m_document.domain().largestHole;
    const auto check = [path, largestHole, fixes = m_document.domain().fixes]() -> FoundPtr {
        auto found = std::make_shared<Found>();
        const auto file = sharedMeshFile(path);
        found->source = {pointsOf(*file), trianglesOf(*file), {}};
        found->fixes = possible(found->source, fixes);
        FixedSurface fixed = fixSurface(found->source, found->fixes);
        found->surface = std::move(fixed.surface);
        found->numbers = std::move(fixed.numbers);
        found->problems = checkSurface(found->surface);
        found->faults = faultsOf(found->surface, found->problems);
        found->repaired = std::make_shared<const Repaired>(found->surface, largestHole);
        return found;
    };
    m_checking.ask(check, [this](const Answer<FoundPtr>& found) { take(found.value); });
}

/// Takes over the new shape, and looks at the surface again if the cage was an automatic choice, which points
/// to faults.
void SurfaceCheck::takeShape() {
    const auto frame = m_motion.frame<3>();
    if (!frame) return;
    if (frame->shape == m_shape) return keepPlace();
    m_shape = frame->shape;
    m_isCaged = frame->built->cage.has_value();
    hide();
    if (!m_isCaged && std::exchange(m_goesOn, false) && m_canvas) m_canvas->fit();  // nothing is left
    if (m_isCaged && m_document.domain().fit == Fit::Automatic && m_canvas) look();
}

/// Computing the same shape keeps the shown fault; moving it does not.
void SurfaceCheck::keepPlace() {
    if (m_motion.isDragging() || m_playback.isPlaying()) m_isPlaceShown = false;
    if (!m_isPlaceShown) return;
    QMetaObject::invokeMethod(
        this,
        [this] {
            if (m_isPlaceShown && m_canvas) showPlace(false);
        },
        Qt::QueuedConnection);
}

/// Unreadable files are reported by the banner alone.
void SurfaceCheck::take(const std::shared_ptr<const Found>& found) {
    if (!found || found->problems.boundsVolume()) return;
    m_found = found;
    m_repaired = found->repaired;
    SurfacePanel::Contents contents;
    const QHash<QString, QString> names{
        {QStringLiteral("missing_vertex"), tr("Triangles with missing points")},
        {QStringLiteral("crossing"), tr("Triangles that cross")},
        {QStringLiteral("hole"), tr("Holes")},
        {QStringLiteral("crowded_edge"), tr("Edges of more than two")},
        {QStringLiteral("flat"), tr("Triangles without area")},
        {QStringLiteral("duplicate"), tr("Duplicate triangles")},
        {QStringLiteral("turned_edge"), tr("Turned neighbours")}};
    for (const FaultKind& kind : found->faults)
        contents.kinds.push_back(
            {names.value(QString::fromStdString(kind.name)), static_cast<int>(kind.cases.size())});
    if (found->problems.flat) contents.more << tr("All points lie in one plane.");
    const Domain& domain = m_document.domain();
    contents.isCaged = m_isCaged;
    contents.largestHole = domain.largestHole;
    const bool goesOn = std::exchange(m_goesOn, false) && !found->faults.empty();
    m_place = goesOn ? placeToBeginWith() : Place{};
    contents.kind = m_place.kind;
    contents.number = m_place.number;
    m_panel.showProblems(contents);
    tellOfRepair();
    m_panel.show();
    propose();
    if (goesOn)
        m_panel.showPlace();
    else if (!m_isCaged)
        showSurface();
}

/// Returns the next fault of the kind that was fixed last, or else the first of all.
SurfaceCheck::Place SurfaceCheck::placeToBeginWith() const {
    const auto kind = std::ranges::find(m_found->faults, m_fixedKind, &FaultKind::name);
    if (kind == m_found->faults.end()) return {};
    const int last = static_cast<int>(kind->cases.size()) - 1;
    return {static_cast<int>(kind - m_found->faults.begin()), std::min(m_place.number, last)};
}

/// Returns the triangles that are kept, with colours for faults and for chosen ones.
VolumePicture SurfaceCheck::picture(const std::vector<bool>& kept, const std::vector<int>& chosen,
                                    const FaultFix* fix) const {
    const Surface& surface = m_found->surface;
    std::vector<QRgb> all(surface.triangles.size(), kFine);
    for (const int t : m_found->problems.triangles(surface)) all[t] = kWrong;
    for (const int t : chosen) all[t] = kChosen;
    if (fix)
        for (const int t : fix->changed) all[t] = kChosen;
    std::vector<std::array<int, 3>> triangles;
    std::vector<QRgb> colours;
    for (std::size_t t = 0; t < all.size(); ++t) {
        if (!kept[t] && all[t] == kFine) continue;
        triangles.push_back(surface.triangles[t]);
        colours.push_back(all[t]);
    }
    if (fix) {
        const auto& after = fix->after.surface.triangles;
        triangles.insert(triangles.end(), after.end() - fix->added, after.end());
        colours.resize(triangles.size(), kAdded);
    }
    VolumePicture picture =
        pictureOfSurface(fix ? fix->after.surface.points : surface.points, triangles, std::move(colours));
    picture.marked = markedIn(picture);
    picture.isOpen = true;
    return picture;
}

/// Returns the whole surface, with the changes of a fix.
VolumePicture SurfaceCheck::picture(const FaultFix* fix) const {
    return picture(std::vector<bool>(m_found->surface.triangles.size(), true), {}, fix);
}

void SurfaceCheck::showSurface() {
    if (!m_found || !m_canvas) return;
    m_isPlaceShown = false;
    m_canvas->setCutKind(CutKind::None);
    m_canvas->showRefused(picture(nullptr), directionToWrong());
}

/// Returns a direction of view in which the first fault is visible.
Vec3 SurfaceCheck::directionToWrong() const {
    const auto wrong = m_found->problems.triangles(m_found->surface);
    return wrong.empty() ? kAskew : intoTriangle(m_found->surface, wrong.front());
}

void SurfaceCheck::showCase(int kind, int number) {
    if (!m_found || !m_canvas || kind >= static_cast<int>(m_found->faults.size())) return;
    m_isPlaceShown = true;
    const Place place{kind, number};
    if (std::exchange(m_place, place) != place) propose();
    proposeAll();
    showPlace(true);
}

/// Zooms to the fault, or marks it in the current view.
void SurfaceCheck::showPlace(bool fromNear) {
    const std::vector<int>& chosen = m_found->faults[m_place.kind].cases[m_place.number];
    if (chosen.empty()) return;
    const Surface& surface = m_found->surface;
    const bool adds = m_fix && m_fix->added > 0;
    const Vec3 direction =
        adds ? intoTriangle(m_fix->after.surface, m_fix->after.surface.triangleCount() - m_fix->added)
             : intoTriangle(surface, chosen.front());
    const Points3 place = surroundingsOf(surface, chosen);
    VolumePicture marked = picture(notBefore(surface, place, direction), chosen, m_fix.get());
    m_canvas->setCutKind(CutKind::None);
    if (!fromNear) return m_canvas->showRefused(std::move(marked), direction);
    m_canvas->setPicture(std::move(marked), false);
    m_canvas->camera().lookAlong(direction);
    m_canvas->viewpoint().zoomTo(place);
}

/// Previews the fix in the current view once it is known, and ends the preview.
void SurfaceCheck::showFixOfAll(bool shown) {
    if (!m_found || !m_canvas) return;
    const bool isKnown = m_all.fix && !m_all.fix->steps.empty();
    if (!shown && !m_isFixOfAllShown) return;
    m_isFixOfAllShown = shown && isKnown;
    if (m_isFixOfAllShown)
        m_canvas->showRefused(picture(m_all.fix.get()), directionToWrong());
    else if (m_isPlaceShown)
        showPlace(false);
    else if (!shown)
        m_isCaged ? showCaged() : showSurface();
}

void SurfaceCheck::showCaged() {
    m_canvas->showLooks();
    m_canvas->fit();
}

void SurfaceCheck::showSolid() {
    if (!m_canvas) return;
    m_isPlaceShown = false;
    if (m_isCaged) return showCaged();
    showSurface();
    m_canvas->viewpoint().lookAlong(directionToWrong());
}

void SurfaceCheck::saveList() {
    if (!m_found) return;
    const QString base = QFileInfo(m_document.displayName()).completeBaseName();
    const QString path = QFileDialog::getSaveFileName(
        &m_window, tr("Save List"),
        QDir(m_document.folder()).filePath(base + QStringLiteral("-problems.txt")), tr("Text (*.txt)"));
    if (path.isEmpty()) return;
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly | QIODevice::Text)) return;
    file.write(listOf(m_found->problems, m_found->numbers));
    file.commit();
}

/// Draws filled holes in a colour of their own.
void SurfaceCheck::showRepair(bool shown) {
    if (!m_found || !m_canvas) return;
    if (!shown) return showSolid();
    m_isPlaceShown = false;
    const Surface& surface = m_repaired->surface;
    const int kept = surface.triangleCount() - m_repaired->report.addedTriangles;
    std::vector<QRgb> colours(surface.triangles.size(), kFine);
    std::fill(colours.begin() + kept, colours.end(), kAdded);
    for (const int t : m_repaired->left.triangles(surface)) colours[t] = kWrong;
    const Vec3 direction = kept < surface.triangleCount() ? intoTriangle(surface, kept) : directionToWrong();
    VolumePicture picture = pictureOfSurface(surface.points, surface.triangles, std::move(colours));
    picture.marked = markedIn(picture);
    picture.isOpen = !m_repaired->left.boundsVolume();
    m_canvas->setCutKind(CutKind::None);
    m_canvas->showRefused(std::move(picture), direction);
}

void SurfaceCheck::fitCage(bool cage) {
    Domain next = m_document.domain();
    next.fit = cage ? Fit::Cage : Fit::Exact;
    m_document.changeDomain(cage ? tr("Fit a cage") : tr("Exact surface only"), std::move(next));
}

// --- Fixes of a surface's faults, computed in the background and previewed ---

/// Computes the fix of this fault.
void SurfaceCheck::propose() {
    m_fix.reset();
    if (m_all.kind != m_place.kind || m_all.found != m_found) m_all = {m_found, m_place.kind};
    tellOfFix();
    if (m_found->faults.empty()) return;
    const auto find = [found = m_found, place = m_place] {
        const FaultKind& kind = found->faults[place.kind];
        return std::make_shared<const FaultFix>(
            fixFor(found->source, found->fixes, kind.name, kind.cases[place.number]));
    };
    const auto take = [this, found = m_found, place = m_place](const std::shared_ptr<const FaultFix>& fix) {
        if (m_found != found || m_place != place) return;
        m_fix = fix;
        tellOfFix();
        if (m_isPlaceShown && m_canvas) showPlace(true);
    };
    inBackground(this, find, take);
}

/// Computes the fix of all faults of this kind once one of them is shown: it takes seconds for dense
/// surfaces.
void SurfaceCheck::proposeAll() {
    if (!m_found || m_all.isSought || m_found->faults[m_place.kind].cases.size() < 2) return;
    m_all.isSought = true;
    const auto find = [found = m_found, kind = m_place.kind, largestHole = m_panel.largestHole()] {
        return std::make_shared<const FaultFix>(
            fixForAll(found->source, found->fixes, found->faults[kind].name, largestHole));
    };
    const auto take = [this, sought = m_all](const std::shared_ptr<const FaultFix>& all) {
        if (m_all.found != sought.found || m_all.kind != sought.kind || m_all.limit != sought.limit) return;
        m_all.fix = all;
        const bool isWanted = std::exchange(m_all.isWanted, false);
        tellOfFix();
        if (isWanted) fixAll();
    };
    inBackground(this, find, take);
}

QString SurfaceCheck::textOf(const FaultFix& fix) const {
    int all = 0;
    for (const FaultKind& kind : m_found->faults) all += static_cast<int>(kind.cases.size());
    const QString does = wouldDo({{tr("drop triangles (%1)"), fix.dropped},
                                  {tr("turn triangles (%1)"), fix.turned},
                                  {tr("add triangles (%1)"), fix.added}});
    return does + ' ' +
           tr("It would leave %1 of %2 faults.").arg(QLocale().toString(fix.faults), QLocale().toString(all));
}

void SurfaceCheck::tellOfFix() {
    const auto textOr = [this](const std::shared_ptr<const FaultFix>& fix, const QString& none) {
        if (!fix) return QString();
        return fix->steps.empty() ? none : textOf(*fix);
    };
    if (m_all.isWanted) {
        m_panel.showFix(tr("Looking for what fixes all of these …"), false);
        return m_panel.showFixOfAll({}, false);
    }
    m_panel.showFix(textOr(m_fix, tr("No simple step fixes this one.")), m_fix && !m_fix->steps.empty());
    m_panel.showFixOfAll(textOr(m_all.fix, tr("No simple steps fix all of these.")),
                         !m_all.fix || !m_all.fix->steps.empty());
}

/// Applies a fix in one undo step and shows the next fault of the kind.
void SurfaceCheck::fix(const std::shared_ptr<const FaultFix>& fix, const QString& name) {
    if (!m_found || !fix || fix->steps.empty()) return;
    Domain next = m_document.domain();
    next.fixes = m_found->fixes;
    next.fixes.insert(next.fixes.end(), fix->steps.begin(), fix->steps.end());
    m_goesOn = true;
    m_fixedKind = m_found->faults[m_place.kind].name;
    m_fix.reset();
    m_all = {};
    m_panel.showFix({}, false);  // once only
    m_panel.showFixOfAll({}, false);
    m_document.changeDomain(name, std::move(next));
}

/// Applies the fix of all faults of the kind; if it is still being computed, as soon as it is known.
void SurfaceCheck::fixAll() {
    if (const auto known = m_all.fix) return fix(known, tr("Fix all faults of a kind"));
    m_all.isWanted = true;
    tellOfFix();
    proposeAll();
}

void SurfaceCheck::repair(int largestHole) {
    Domain next = m_document.domain();
    next.repair = true;
    next.largestHole = largestHole;
    m_document.changeDomain(tr("Repair surface"), std::move(next));
}

/// Previews the repair with another limit.
void SurfaceCheck::tryLimit(int largestHole) {
    if (!m_found) return;
    m_all = {m_found, m_place.kind, largestHole};
    tellOfFix();
    if (m_isPlaceShown) proposeAll();
    const auto attempt = [found = m_found, largestHole] {
        return std::make_shared<const Repaired>(found->surface, largestHole);
    };
    inBackground(this, attempt,
                 [this, found = m_found, largestHole](const std::shared_ptr<const Repaired>& repaired) {
                     if (m_found != found || m_panel.largestHole() != largestHole) return;
                     m_repaired = repaired;
                     tellOfRepair();
                 });
}

/// Returns the numbers of edges of the holes: open edges that hang together.
std::vector<int> SurfaceCheck::holesIn(const SurfaceProblems& problems) {
    std::map<int, int> places;  // of vertices
    for (const auto& edge : problems.openEdges)
        for (const int v : edge) places.try_emplace(v, static_cast<int>(places.size()));
    DisjointSets sets(static_cast<int>(places.size()));
    for (const auto& edge : problems.openEdges) sets.join(places[edge[0]], places[edge[1]]);
    std::map<int, int> counts;
    for (const auto& edge : problems.openEdges) ++counts[sets.root(places[edge[0]])];
    std::vector<int> edges;
    for (const auto& [set, count] : counts) edges.push_back(count);
    return edges;
}

void SurfaceCheck::tellOfRepair() {
    m_panel.tellOfHoles(m_document.domain().repair ? std::vector<int>() : holesIn(m_repaired->left));
    const bool done = m_document.domain().repair;
    m_panel.tellOfRepair(!done && m_repaired->left.boundsVolume(), done ? QString() : repairText());
}

QString SurfaceCheck::repairText() const {
    const RepairReport& report = m_repaired->report;
    return wouldDo({{tr("merge points (%1)"), report.mergedVertices},
                    {tr("drop triangles (%1)"), report.droppedDegenerate + report.droppedDuplicate},
                    {tr("turn triangles (%1)"), report.flipped},
                    {tr("fill holes (%1)"), report.filledHoles}});
}

/// Describes the effect of those that change something; empty if none does.
QString SurfaceCheck::wouldDo(const std::vector<std::pair<QString, int>>& repairs) {
    QStringList parts;
    for (const auto& [text, count] : repairs)
        if (count > 0) parts << text.arg(QLocale().toString(count));
    return parts.isEmpty() ? QString() : tr("It would %1.").arg(parts.join(QStringLiteral(", ")));
}

}  // namespace wend
