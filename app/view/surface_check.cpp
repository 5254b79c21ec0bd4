#include "app/view/surface_check.h"

#include <Eigen/Geometry>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QSaveFile>
#include <QTextStream>
#include <QtConcurrent>

#include "app/panels/surface_panel.h"
#include "app/view/volume/solid_canvas.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/printable.h"
#include "core/mesh/skin_file.h"

namespace wend {

namespace {

const Vec<3> kAskew(-1, 1.4, -0.8);
const QRgb kFine = qRgb(199, 186, 164), kWrong = qRgb(214, 44, 60);

QStringList linesOf(const SurfaceProblems& problems) {
    return QString::fromStdString(problems.summary()).split(QStringLiteral(", "));
}

/// Against the triangle's outer side, a little from above.
Vec<3> intoTriangle(const Surface& surface, int triangle) {
    const auto& t = surface.triangles[triangle];
    const Vec<3> a = surface.points.col(t[0]);
    const Vec<3> normal = (surface.points.col(t[1]) - a).cross(surface.points.col(t[2]) - a);
    if (!normal.allFinite() || normal.norm() == 0) return kAskew;
    return -normal.normalized() + Vec<3>(0.15, 0.25, -0.3);
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
        const Document& document = m_session.document();
        const bool surface =
            document.dimension() == 3 && document.project()->domain.kind == DomainKind::Surface;
        if (!text.isEmpty() && surface && m_canvas) look();
    });
    connect(&session.document(), &Document::opened, this, [this] {
        hide();
        preview();
    });
    connect(&panel, &SurfacePanel::showRequested, this, &SurfaceCheck::lookAtWrong);
    connect(&panel, &SurfacePanel::saveRequested, this, &SurfaceCheck::saveList);
    connect(&panel, &SurfacePanel::repairRequested, this, &SurfaceCheck::repair);
}

void SurfaceCheck::hide() {
    m_found.reset();
    m_panel.hide();
}

/// What is wrong with a file that cannot be read is told elsewhere.
void SurfaceCheck::preview() {
    const Document& document = m_session.document();
    if (document.dimension() != 3 || document.project()->domain.kind != DomainKind::Surface) return;
    const std::string path = pathIn(document.folder().toStdString(), document.project()->domain.path);
    const int generation = document.generation();
    const auto read = [path]() -> std::shared_ptr<const Skin> {
        try {
            return std::make_shared<const Skin>(readSkin(path));
        } catch (const std::exception&) {
            return {};
        }
    };
    QtConcurrent::run(read).then(this, [this, generation](const std::shared_ptr<const Skin>& skin) {
        if (skin && m_canvas && m_session.document().generation() == generation) m_canvas->showPreview(skin);
    });
}

void SurfaceCheck::look() {
    const Document& document = m_session.document();
    const std::string path = pathIn(document.folder().toStdString(), document.project()->domain.path);
    const int generation = document.generation();
    const int largestHole = document.project()->domain.largestHole;
    const auto check = [path, largestHole]() -> std::shared_ptr<const Found> {
        auto found = std::make_shared<Found>();
        try {
            const MeshFile file = readMeshFile(path);
            found->surface = {file.points, file.triangles, {}};
            found->problems = checkSurface(found->surface);
            RepairReport report;
            found->mendable = checkSurface(repairSurface(found->surface, largestHole, report)).boundsVolume();
        } catch (const std::exception& error) {
            found->error = QString::fromStdString(messageOf(error));
        }
        return found;
    };
    QtConcurrent::run(check).then(this, [this, generation](const std::shared_ptr<const Found>& found) {
        if (m_session.document().generation() == generation) take(found);
    });
}

/// Files whose trouble is another one (that cannot be read …) are told by the banner alone.
void SurfaceCheck::take(const std::shared_ptr<const Found>& found) {
    if (!found->error.isEmpty() || found->problems.summary().empty()) return;
    m_found = found;
    m_panel.showProblems(linesOf(found->problems),
                         static_cast<int>(found->problems.triangles(found->surface).size()),
                         found->mendable && !m_session.document().project()->domain.repair);
    m_panel.show();
    showSurface();
}

void SurfaceCheck::showSurface() {
    if (!m_found || !m_canvas) return;
    const Surface& surface = m_found->surface;
    const auto wrong = m_found->problems.triangles(surface);
    std::vector<QRgb> colours(surface.triangles.size(), kFine);
    for (const int t : wrong) colours[t] = kWrong;
    VolumePicture picture = pictureOfSurface(surface.points, surface.triangles, std::move(colours));
    picture.isOpen = true;
    m_canvas->setCutKind(CutKind::None);
    m_canvas->showRefused(std::move(picture), directionToWrong());
}

/// From where the first wrong triangle is seen.
Vec<3> SurfaceCheck::directionToWrong() const {
    const auto wrong = m_found->problems.triangles(m_found->surface);
    return wrong.empty() ? kAskew : intoTriangle(m_found->surface, wrong.front());
}

void SurfaceCheck::lookAtWrong() {
    if (!m_found || !m_canvas) return;
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

void SurfaceCheck::repair() {
    Document& document = m_session.document();
    Project next = *document.project();
    next.domain.repair = true;
    document.change(tr("Repair surface"), std::move(next));
}

}  // namespace wend
