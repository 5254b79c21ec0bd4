#include "app/view/exporter.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QProgressDialog>
#include <QtConcurrent>

#include "core/mesh/error.h"
#include "core/mesh/mesh_file.h"
#include "warp/warp.h"

namespace wend {

namespace {

const char* const kPictureFilter = "PNG (*.png);;TIFF (*.tif);;OpenEXR (*.exr);;JPEG (*.jpg);;WebP (*.webp)";

void writePicture(const std::string& path, const Image& source, const ShapeFrame& frame,
                  const std::function<void(double)>& progress, std::stop_token stop) {
    View view;
    view.width = source.width;
    view.height = source.height;
    WarpOptions options;
    options.stop = stop;
    options.progress = progress;
    const Image image = warpImage(source, *frame.rest, frame.pose, view, options);
    if (!stop.stop_requested()) writeImage(path, image);
}

/// "dir/name_####.png" with the number in place of the marks.
std::string numbered(const QString& path, int number) {
    const QFileInfo info(path);
    const QString digits = QStringLiteral("%1").arg(number, 4, 10, QLatin1Char('0'));
    return QDir(info.path())
        .filePath(info.completeBaseName() + '_' + digits + '.' + info.suffix())
        .toStdString();
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
    connect(dialog, &QProgressDialog::canceled, this, [source] { source->request_stop(); });
    const Progress progress = [this, dialog = QPointer<QProgressDialog>(dialog)](double part) {
        QMetaObject::invokeMethod(this, [dialog, part] {
            if (dialog) dialog->setValue(static_cast<int>(1000 * part));
        });
    };
    const auto finish = [dialog = QPointer<QProgressDialog>(dialog)] {
        if (dialog) dialog->deleteLater();
    };
    QtConcurrent::run([job = std::move(job), progress, source] {
        return errorOf(job, progress, source->get_token());
    }).then(this, [this, finish, source, path](const QString& error) {
        finish();
        if (!error.isEmpty())
            emit failed(tr("Nothing was written. %1").arg(error));
        else if (!source->stop_requested())
            emit done(tr("Written: %1").arg(QDir::toNativeSeparators(path)));
    });
}

void Exporter::exportPicture() {
    const FramePtr frame = shownFrame();
    const auto picture = m_session.document().picture();
    if (!frame || !picture) return;
    const QString path =
        askName(tr("Export Picture"), QStringLiteral("-bent.png"), QString::fromLatin1(kPictureFilter));
    if (path.isEmpty()) return;
    run(tr("Writing the picture …"), path, [=](const Progress& progress, std::stop_token stop) {
        writePicture(path.toStdString(), *picture, *frame, progress, stop);
    });
}

void Exporter::exportMesh() {
    const FramePtr frame = shownFrame();
    if (!frame) return;
    const QString path =
        askName(tr("Export Mesh"), QStringLiteral("-bent.obj"),
                QStringLiteral("Wavefront OBJ (*.obj);;PLY (*.ply);;OFF (*.off);;VTU (*.vtu);;VTK (*.vtk)"));
    if (path.isEmpty()) return;
    const auto picture = m_session.document().picture();
    run(tr("Writing the mesh …"), path, [=](const Progress&, std::stop_token) {
        SimplicialMesh<2> posed = *frame->rest;
        posed.points = frame->pose;
        MeshFile file = toMeshFile<2>(posed);
        if (picture) {  // texture coordinates: where the vertex is in the picture, from the bottom left
            file.uv = frame->rest->points;
            file.uv.row(0) /= picture->width;
            file.uv.row(1) = (1 - file.uv.row(1).array() / picture->height).matrix();
        }
        writeMeshFile(path.toStdString(), file);
    });
}

void Exporter::exportFrames() {
    const auto picture = m_session.document().picture();
    if (!shownFrame() || !picture) return;
    const QString path =
        askName(tr("Export Frames"), QStringLiteral(".png"), QString::fromLatin1(kPictureFilter));
    if (path.isEmpty()) return;
    const std::vector<FramePtr> frames = m_session.track().frames();
    run(tr("Writing %n pictures …", nullptr, static_cast<int>(frames.size())), path,
        [=](const Progress& progress, std::stop_token stop) {
            for (std::size_t i = 0; i < frames.size() && !stop.stop_requested(); ++i) {
                writePicture(numbered(path, static_cast<int>(i) + 1), *picture, *frames[i], {}, stop);
                progress(static_cast<double>(i + 1) / static_cast<double>(frames.size()));
            }
        });
}

void Exporter::exportStMap() {
    const FramePtr frame = shownFrame();
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
