#include "app/view/exporter.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QProgressDialog>
#include <QtConcurrent>
#include <cmath>

#include "app/session/fields.h"
#include "app/session/run.h"
#include "app/session/shape_file.h"
#include "core/mesh/error.h"
#include "core/mesh/mesh_file.h"
#include "warp/warped_picture.h"

namespace wend {

namespace {

const char* const kSolidFilter =
    "VTU (*.vtu);;VTK (*.vtk);;Medit (*.mesh);;Gmsh (*.msh);;TetGen (*.node);;glTF (*.glb);;Wavefront OBJ "
    "(*.obj);;PLY (*.ply);;STL (*.stl);;OFF (*.off)";
const char* const kSolidFramesFilter =
    "glTF (*.glb);;VTU (*.vtu);;Wavefront OBJ (*.obj);;PLY (*.ply);;STL (*.stl);;Medit (*.mesh);;VTK (*.vtk)";
const char* const kPictureFilter = "PNG (*.png);;TIFF (*.tif);;OpenEXR (*.exr);;JPEG (*.jpg);;WebP (*.webp)";

void writePicture(const std::string& path, const Image& source, const PosedFrame<2>& frame, int restMargin,
                  const std::function<void(double)>& progress, std::stop_token stop) {
    View view;
    view.width = source.width;
    view.height = source.height;
    WarpOptions options;
    options.restMargin = restMargin;
    options.stop = stop;
    options.progress = progress;
    writeWarped(path, WarpedPicture(source, *frame.rest, frame.pose, view, options));
}

/// What went wrong, or nothing. (Futures would slice the exception.)
template <class Job, class Progress>
QString errorOf(const Job& job, const Progress& progress, std::stop_token stop) {
    try {
        job(progress, stop);
        return {};
    } catch (const Cancelled&) {
        return {};
    } catch (const std::exception& error) {
        return QString::fromUtf8(error.what());
    }
}

}  // namespace

Exporter::Exporter(ShapeSession& session, QWidget& window)
    : QObject(&window), m_session(session), m_window(window) {}

/// What runs in the background reports to this object.
Exporter::~Exporter() {
    if (m_stop) m_stop->request_stop();
    m_running.waitForFinished();
}

QString Exporter::askName(const QString& title, const QString& suffix, const QString& filters) {
    const Document& document = m_session.document();
    const QString base = QFileInfo(document.displayName()).completeBaseName();
    const QString proposal = QDir(document.folder()).filePath(base + suffix);
    QString chosen;
    QString path = QFileDialog::getSaveFileName(&m_window, title, proposal, filters, &chosen);
    if (!path.isEmpty() && QFileInfo(path).suffix().isEmpty()) path += '.' + QFileInfo(suffix).suffix();
    return path;
}

FramePtr Exporter::shownFrame() {
    if (m_session.frame() && !m_session.isBusy() && !m_session.isStale()) return m_session.frame();
    emit failed(tr("The shape is still being computed. Try again in a moment."));
    return {};
}

void Exporter::run(const QString& what, const QString& path, Job job) {
    auto* dialog = new QProgressDialog(what, tr("Cancel"), 0, 1000, &m_window);
    dialog->setWindowModality(Qt::WindowModal);
    dialog->setMinimumDuration(400);
    dialog->setAutoReset(false);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setValue(0);
    auto source = std::make_shared<std::stop_source>();
    m_stop = source;
    connect(dialog, &QProgressDialog::canceled, this, [source] { source->request_stop(); });
    const Progress progress = [this, dialog = QPointer<QProgressDialog>(dialog)](double part) {
        QMetaObject::invokeMethod(this, [dialog, part] {
            if (dialog) dialog->setValue(static_cast<int>(1000 * part));
        });
    };
    const auto finish = [dialog = QPointer<QProgressDialog>(dialog)] {
        if (dialog) dialog->deleteLater();
    };
    m_running = QtConcurrent::run(
        [job = std::move(job), progress, source] { return errorOf(job, progress, source->get_token()); });
    m_running.then(this, [this, finish, source, path](const QString& error) {
        finish();
        if (!error.isEmpty())
            emit failed(tr("Nothing was written. %1").arg(error));
        else if (!source->stop_requested())
            emit done(tr("Written: %1").arg(QDir::toNativeSeparators(path)));
    });
}

void Exporter::exportPicture() {
    const auto frame = posed<2>(shownFrame());
    const auto picture = m_session.document().picture();
    if (!frame || !picture) return;
    const QString path =
        askName(tr("Export Picture"), QStringLiteral("-bent.png"), QString::fromLatin1(kPictureFilter));
    if (path.isEmpty()) return;
    const int restMargin = restMarginOf(m_session.document().project()->domain);
    run(tr("Writing the picture …"), path, [=](const Progress& progress, std::stop_token stop) {
        writePicture(path.toStdString(), *picture, *frame, restMargin, progress, stop);
    });
}

void Exporter::exportMesh() {
    const FramePtr shown = shownFrame();
    if (const auto solid = posed<3>(shown)) {
        exportSolid(solid);
        return;
    }
    const auto frame = posed<2>(shown);
    if (!frame) return;
    const QString path =
        askName(tr("Export Mesh"), QStringLiteral("-bent.obj"),
                QStringLiteral("Wavefront OBJ (*.obj);;PLY (*.ply);;OFF (*.off);;VTU (*.vtu);;VTK (*.vtk)"));
    if (path.isEmpty()) return;
    const auto project = m_session.document().project();
    Scene<2> made;  // of a picture; a mesh's file has more to pass on
    made.rest = frame->rest;
    made.picture = m_session.document().picture();
    run(tr("Writing the mesh …"), path, [=](const Progress&, std::stop_token) {
        const bool isMade = project->domain.kind == DomainKind::Image;
        const Scene<2> scene = isMade ? made : std::get<Scene<2>>(loadScene(*project, {}));
        writeMeshFile(path.toStdString(), poseFile<2>(scene, frame->pose));
    });
}

/// Tetrahedra with all fields, or their surface where the format has only triangles.
void Exporter::exportSolid(const PosedPtr<3>& frame) {
    const QString path =
        askName(tr("Export Mesh"), QStringLiteral("-bent.vtu"), QString::fromLatin1(kSolidFilter));
    if (path.isEmpty()) return;
    const auto project = m_session.document().project();
    const Points<3> velocity = velocityOf<3>(m_session.track(), *frame);
    run(tr("Writing the mesh …"), path, [=](const Progress& progress, std::stop_token stop) {
        const auto scene = std::get<Scene<3>>(loadScene(*project, {}, stop));
        progress(0.5);
        writeShape<3>(path.toStdString(), scene, frame->pose, shapeFields<3>(scene, frame->pose, velocity));
    });
}

void Exporter::exportFrames() {
    const Document& document = m_session.document();
    const bool solid = document.dimension() == 3;
    if (!shownFrame() || (!document.picture() && !solid)) return;
    const double seconds = m_session.playback().end() * Playback::kSecondsPerUnit;
    bool ok = false;
    const int count =
        QInputDialog::getInt(&m_window, tr("Export Frames"),
                             solid ? tr("How many shapes, from the start to the end?")
                                   : tr("How many pictures, from the start to the end?"),
                             static_cast<int>(std::lround(24 * seconds)) + 1, 2, 100000, 1, &ok);
    if (!ok) return;
    QString path =
        askName(tr("Export Frames"), solid ? QStringLiteral("-bent.glb") : QStringLiteral("_####.png"),
                QString::fromLatin1(solid ? kSolidFramesFilter : kPictureFilter));
    if (path.isEmpty()) return;
    const bool animation = QFileInfo(path).suffix().toLower() == QStringLiteral("glb");
    if (!path.contains('#') && !animation)
        path.insert(path.size() - QFileInfo(path).suffix().size() - 1, QStringLiteral("_####"));
    RunOptions options;
    options.outputs.frames = path.toStdString();
    options.outputs.count = count;
    options.outputs.framesPerSecond = seconds > 0 ? (count - 1) / seconds : 24;
    const auto project = document.project();
    const std::string name = QDir(document.folder()).filePath(document.displayName()).toStdString();
    run(solid ? tr("Writing %n shapes …", nullptr, count) : tr("Writing %n pictures …", nullptr, count), path,
        [=](const Progress& progress, std::stop_token stop) {
            RunWatch watch;
            watch.progress = [&progress](const std::string&, double fraction) { progress(fraction); };
            watch.stop = stop;
            const AdvanceResult result = runProject(*project, name, options, watch);
            if (result.outcome != Outcome::Done) throw InputError(result.message);
        });
}

void Exporter::exportStMap() {
    const auto frame = posed<2>(shownFrame());
    const auto picture = m_session.document().picture();
    if (!frame || !picture) return;
    const QString path = askName(tr("Export ST Map"), QStringLiteral("-stmap.exr"),
                                 QStringLiteral("OpenEXR (*.exr);;TIFF (*.tif)"));
    if (path.isEmpty()) return;
    run(tr("Writing the map …"), path, [=](const Progress&, std::stop_token) {
        View view;
        view.width = picture->width;
        view.height = picture->height;
        writeImage(path.toStdString(),
                   stMap(*frame->rest, frame->pose, view, picture->width, picture->height));
    });
}

}  // namespace wend
