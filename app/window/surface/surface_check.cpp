#include "app/window/surface/surface_check.h"

#include <Eigen/Geometry>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHash>
#include <QSaveFile>
#include <utility>

#include "app/base/in_background.h"
#include "app/base/said.h"
#include "app/engine/shape/shape.h"
#include "app/panels/surface_panel.h"
#include "app/project/domain.h"
#include "app/project/file/named_files.h"
#include "app/style/marks.h"
#include "app/views/volume/solid_canvas.h"
#include "app/window/surface/problem_list.h"
#include "app/window/surface/surface_place.h"
#include "core/base/error.h"
#include "core/mesh/mesh_of_file.h"
#include "core/mesh/skin_file.h"

namespace wend {

namespace {

const QRgb kFine = qRgb(199, 186, 164), kChosen = qRgb(255, 170, 0), kAdded = qRgb(46, 158, 92);

/// The triangles that are not as they should be.
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
    const auto check = [path, largestHole,
                        fixes = document.domain().fixes]() -> std::shared_ptr<const Found> {
        auto found = std::make_shared<Found>();
        try {
            const auto file = sharedMeshFile(path);
            found->source = {pointsOf(*file), trianglesOf(*file), {}};
            found->fixes = possible(found->source, fixes);
            FixedSurface fixed = fixSurface(found->source, found->fixes);
            found->surface = std::move(fixed.surface);
            found->numbers = std::move(fixed.numbers);
            found->problems = checkSurface(found->surface);
            found->faults = faultsOf(found->surface, found->problems);
            found->repaired = std::make_shared<const Repaired>(found->surface, largestHole);
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
    if (!frame) return;
    if (frame->shape == m_shape) return keepPlace();
    m_shape = frame->shape;
    m_isCaged = frame->built->cage.has_value();
    hide();
    if (!m_isCaged && std::exchange(m_goesOn, false) && m_canvas) m_canvas->fit();  // nothing is left
    if (m_isCaged && m_session.document().domain().fit == Fit::Automatic && m_canvas) look();
}

/// Computing the same shape keeps the shown fault; moving it does not.
void SurfaceCheck::keepPlace() {
    if (m_session.isDragging() || m_session.playback().isPlaying()) m_isPlaceShown = false;
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
    if (!found->error.isEmpty() || found->problems.boundsVolume()) return;
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
    const Domain& domain = m_session.document().domain();
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

/// The next one of the kind that was fixed last, or else the first of all.
SurfaceCheck::Place SurfaceCheck::placeToBeginWith() const {
    const auto kind = std::ranges::find(m_found->faults, m_fixedKind, &FaultKind::name);
    if (kind == m_found->faults.end()) return {};
    const int last = static_cast<int>(kind->cases.size()) - 1;
    return {static_cast<int>(kind - m_found->faults.begin()), std::min(m_place.number, last)};
}

/// The triangles that are kept, in colours: wrong ones, and among them the chosen ones.
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
Vec<3> SurfaceCheck::directionToWrong() const {
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
    const Vec<3> direction =
        adds ? intoTriangle(m_fix->after.surface, m_fix->after.surface.triangleCount() - m_fix->added)
             : intoTriangle(surface, chosen.front());
    const Points<3> place = surroundingsOf(surface, chosen);
    VolumePicture marked = picture(notBefore(surface, place, direction), chosen, m_fix.get());
    m_canvas->setCutKind(CutKind::None);
    if (fromNear)
        m_canvas->showPlace(std::move(marked), direction, place);
    else
        m_canvas->showRefused(std::move(marked), direction);
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
        m_isCaged ? m_canvas->showSolid() : showSurface();
}

void SurfaceCheck::showSolid() {
    if (!m_canvas) return;
    m_isPlaceShown = false;
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
    const Vec<3> direction =
        kept < surface.triangleCount() ? intoTriangle(surface, kept) : directionToWrong();
    VolumePicture picture = pictureOfSurface(surface.points, surface.triangles, std::move(colours));
    picture.marked = markedIn(picture);
    picture.isOpen = !m_repaired->left.boundsVolume();
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
