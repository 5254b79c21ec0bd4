#include "app/view/exporter.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QProgressDialog>
#include <QtConcurrent>
#include <cmath>

#include "app/session/opening.h"
#include "app/session/run.h"
#include "app/session/shape_file.h"
#include "app/session/velocity_probe.h"
#include "core/mesh/error.h"
#include "core/mesh/file_name.h"
#include "core/mesh/mesh_file.h"
#include "warp/warped_picture.h"

namespace wend {

namespace {

const char* const kSolidFilter =
    "VTU (*.vtu);;VTK (*.vtk);;Medit (*.mesh);;Gmsh 4.1 (*.msh);;Gmsh 2.2 (*.msh);;TetGen (*.node);;glTF "
    "(*.glb);;Wavefront OBJ "
    "(*.obj);;PLY (*.ply);;STL (*.stl);;OFF (*.off)";
const char* const kFlatFilter = "Wavefront OBJ (*.obj);;PLY (*.ply);;OFF (*.off);;VTU (*.vtu);;VTK (*.vtk)";
const char* const kSolidFramesFilter =
    "glTF (*.glb);;VTU (*.vtu);;Wavefront OBJ (*.obj);;PLY (*.ply);;STL (*.stl);;Medit (*.mesh);;VTK (*.vtk)";
const char* const kPictureFilter = "PNG (*.png);;TIFF (*.tif);;OpenEXR (*.exr);;JPEG (*.jpg);;WebP (*.webp)";

/// A frame in the pixels of its picture: the document's, or that of a file's mesh.
struct Pixels {
    std::shared_ptr<const Image> picture;
    std::shared_ptr<const SimplicialMesh<2>> rest;
    Points<2> pose;

    Pixels(const Document& document, const PosedPtr<2>& frame) {
        if (!frame) return;
        picture = document.picture();
        rest = frame->rest;
        pose = frame->pose;
        const auto& texture = frame->built->texture;
        if (picture || !texture) return;
        picture = texture->picture;
        rest = texture->rest;
        pose = texture->toPixels(frame->pose);
    }
    View view() const { return {picture->width, picture->height, Vec<2>::Zero(), 1}; }
};

void writePicture(const std::string& path, const Pixels& pixels, int restMargin,
                  const std::function<void(double)>& progress, std::stop_token stop) {
    WarpOptions options;
    options.restMargin = restMargin;
    options.stop = stop;
    options.progress = progress;
    writeWarped(path, WarpedPicture(*pixels.picture, *pixels.rest, pixels.pose, pixels.view(), options));
}

/// The velocity field at a frame; empty, with a remark, where it cannot be had.
Points<3> velocityAt(const Project& project, const PosedFrame<3>& frame, QString& remark) {
    Points<3> velocity;
    try {
        velocity = VelocityProbe<3>(frame.rest, frame.material, project).at(frame.time, frame.pose);
        if (velocity.cols() == 0) remark = Exporter::tr("the velocity field cannot be solved for");
    } catch (const InputError& error) {
        remark = QString::fromUtf8(error.what());
    }
    return velocity;
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

QString Exporter::askName(const QString& title, const QString& suffix, const QString& filters,
                          QString* chosen) {
    const Document& document = m_session.document();
    const QString base = QFileInfo(document.displayName()).completeBaseName();
    const QString proposal = QDir(proposedFolder(document)).filePath(base + suffix);
    QString path = QFileDialog::getSaveFileName(&m_window, title, proposal, filters, chosen);
    if (!path.isEmpty() && QFileInfo(path).suffix().isEmpty()) path += '.' + QFileInfo(suffix).suffix();
    return path;
}

/// One at a time: the window is not blocked before the progress has been shown for a while.
bool Exporter::isFree() {
    if (!m_running.isRunning()) return true;
    emit failed(tr("Another export is still being written. Try again in a moment."));
    return false;
}

FramePtr Exporter::shownFrame() {
    if (!isFree()) return {};
    if (m_session.frame() && !m_session.isBusy() && !m_session.isStale()) return m_session.frame();
    emit failed(m_session.isBusy() ? tr("The shape is still being computed. Try again in a moment.")
                                   : tr("There is no shape to export: it could not be computed."));
    return {};
}

void Exporter::run(const QString& what, const QString& path, Job job,
                   const std::shared_ptr<const QString>& remark) {
    if (!isFree()) return;
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
    m_running.then(this, [this, finish, source, path, remark](const QString& error) {
        finish();
        const QString name = QDir::toNativeSeparators(path);
        if (!error.isEmpty())
            emit failed(tr("Nothing was written. %1").arg(error));
        else if (!source->stop_requested())
            emit done(remark && !remark->isEmpty()
                          ? tr("Written without velocities: %1 (%2)").arg(name, *remark)
                          : tr("Written: %1").arg(name));
    });
}

void Exporter::exportPicture() {
    const Pixels pixels(m_session.document(), posed<2>(shownFrame()));
    if (!pixels.picture) return;
    const QString path =
        askName(tr("Export Picture"), QStringLiteral("-bent.png"), QString::fromLatin1(kPictureFilter));
    if (path.isEmpty()) return;
    const int restMargin = restMarginOf(m_session.document().project()->domain);
    run(tr("Writing the picture …"), path, [=](const Progress& progress, std::stop_token stop) {
        writePicture(path.toStdString(), pixels, restMargin, progress, stop);
    });
}

void Exporter::exportMesh() {
    const FramePtr shown = shownFrame();
    if (!shown) return;
    const bool solid = shown->dimension == 3;
    QString chosen;
    const QString path =
        askName(tr("Export Mesh"), solid ? QStringLiteral("-bent.vtu") : QStringLiteral("-bent.obj"),
                QString::fromLatin1(solid ? kSolidFilter : kFlatFilter), &chosen);
    MeshWriteOptions options;
    options.gmshVersion = chosen.contains(QStringLiteral("2.2")) ? 2 : 4;
    if (!path.isEmpty()) writeMesh(path, options);
}

void Exporter::writeMesh(const QString& path, const MeshWriteOptions& options) {
    const FramePtr shown = shownFrame();
    if (!shown) return;
    try {
        requireShapeFormat(path.toStdString(), lowerExtension(path.toStdString()), shown->dimension);
    } catch (const InputError& error) {
        emit failed(tr("Nothing was written. %1").arg(QString::fromUtf8(error.what())));
        return;
    }
    if (const auto solid = posed<3>(shown)) writeSolid(path, solid, options);
    if (const auto flat = posed<2>(shown)) writeFlat(path, flat);
}

void Exporter::writeFlat(const QString& path, const PosedPtr<2>& frame) {
    Scene<2> scene;
    scene.rest = frame->rest;
    scene.source = frame->built->source;
    scene.picture = m_session.document().picture();
    if (scene.picture) scene.texture = textureOf(scene.picture, scene.rest, {});
    run(tr("Writing the mesh …"), path, [=](const Progress&, std::stop_token) {
        writeMeshFile(path.toStdString(), poseFile<2>(scene, frame->pose));
    });
}

/// Tetrahedra with all fields, or their surface where the format has only triangles: what `wend run` writes.
void Exporter::writeSolid(const QString& path, const PosedPtr<3>& frame, const MeshWriteOptions& options) {
    Scene<3> scene;
    scene.rest = frame->rest;
    scene.material = frame->material;
    scene.source = frame->built->source;
    scene.skin = frame->built->skin;
    scene.ride = frame->built->ride;
    const auto project = m_session.document().project();
    const auto remark = std::make_shared<QString>();
    const auto job = [=](const Progress&, std::stop_token stop) {
        std::vector<MeshField> fields;
        if (holdsFields(path.toStdString()))
            fields = shapeFields<3>(scene, frame->pose, velocityAt(*project, *frame, *remark));
        if (stop.stop_requested()) throw Cancelled();
        writeShape<3>(path.toStdString(), scene, frame->pose, fields, options);
    };
    run(tr("Writing the mesh …"), path, job, remark);
}

void Exporter::exportFrames() {
    const Document& document = m_session.document();
    const bool solid = document.dimension() == 3;
    const FramePtr frame = shownFrame();
    if (!frame || !(solid || Pixels(document, posed<2>(frame)).picture)) return;
    const double seconds = m_session.playback().end() * Playback::kSecondsPerUnit;
    bool ok = false;
    const int count =
        QInputDialog::getInt(&m_window, tr("Export Frames"),
                             solid ? tr("How many shapes, from the start to the end?")
                                   : tr("How many pictures, from the start to the end?"),
                             static_cast<int>(std::lround(24 * seconds)) + 1, 2, 100000, 1, &ok);
    if (!ok) return;
    const QString path =
        askName(tr("Export Frames"), solid ? QStringLiteral("-bent.glb") : QStringLiteral("_####.png"),
                QString::fromLatin1(solid ? kSolidFramesFilter : kPictureFilter));
    if (!path.isEmpty()) writeFrames(path, count);
}

void Exporter::writeFrames(QString path, int count) {
    const Document& document = m_session.document();
    const double seconds = m_session.playback().end() * Playback::kSecondsPerUnit;
    const bool animation = QFileInfo(path).suffix().toLower() == QStringLiteral("glb");
    if (!path.contains('#') && !animation)
        path.insert(path.size() - QFileInfo(path).suffix().size() - 1, QStringLiteral("_####"));
    RunOptions options;
    options.outputs.frames = path.toStdString();
    options.outputs.count = count;
    options.outputs.framesPerSecond = seconds > 0 ? (count - 1) / seconds : 24;
    const auto project = document.project();
    const std::string name = QDir(document.folder()).filePath(document.displayName()).toStdString();
    const QString what = document.dimension() == 3 ? tr("Writing %n shapes …", nullptr, count)
                                                   : tr("Writing %n pictures …", nullptr, count);
    run(what, path, [=](const Progress& progress, std::stop_token stop) {
        RunWatch watch;
        watch.progress = [&progress](const std::string&, double fraction) { progress(fraction); };
        watch.stop = stop;
        const AdvanceResult result = runProject(*project, name, options, watch);
        if (result.outcome != Outcome::Done) throw InputError(result.message);
    });
}

void Exporter::exportStMap() {
    const Pixels pixels(m_session.document(), posed<2>(shownFrame()));
    if (!pixels.picture) return;
    const QString path = askName(tr("Export ST Map"), QStringLiteral("-stmap.exr"),
                                 QStringLiteral("OpenEXR (*.exr);;TIFF (*.tif)"));
    if (path.isEmpty()) return;
    run(tr("Writing the map …"), path, [=](const Progress&, std::stop_token) {
        writeImage(path.toStdString(), stMap(*pixels.rest, pixels.pose, pixels.view(), pixels.picture->width,
                                             pixels.picture->height));
    });
}

}  // namespace wend
