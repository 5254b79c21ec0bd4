#include "app/window/export/exporter.h"

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPointer>
#include <QProgressDialog>
#include <QPushButton>
#include <algorithm>

#include "app/base/in_background.h"
#include "app/base/said.h"
#include "app/engine/motion/playback.h"
#include "app/output/own_files.h"
#include "app/output/run_options.h"
#include "app/output/shape_file.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/material_edits.h"
#include "app/session/opening.h"
#include "app/session/shape_motion.h"
#include "app/window/export/dialogs.h"
#include "app/window/export/export_panel.h"
#include "core/base/error.h"

namespace wend {

namespace {

constexpr QSize kSolidPreview(640, 640);  // empty parts are left out

/// Crops empty rows and columns.
QImage seenPart(const QImage& image) {
    QRect seen;
    for (int y = 0; y < image.height(); ++y) {
        const auto* row = reinterpret_cast<const QRgb*>(image.constScanLine(y));
        const auto isSeen = [](QRgb pixel) { return qAlpha(pixel) > 0; };
        const auto* end = row + image.width();
        const auto* first = std::find_if(row, end, isSeen);
        if (first == end) continue;
        const auto last = std::find_if(std::reverse_iterator(end), std::reverse_iterator(row), isSeen);
        seen |= QRect(QPoint(int(first - row), y), QPoint(int(last.base() - row) - 1, y));
    }
    return seen.isNull() ? image : image.copy(seen);
}

QString suffixOf(const ExportForm& form) {
    if (form.kind() == ExportKind::StMap) return QStringLiteral("-stmap") + form.extension();
    const bool numbered = form.kind() == ExportKind::Frames && !form.isFilm();
    return (numbered ? QStringLiteral("_####") : QStringLiteral("-bent")) + form.extension();
}

/// Inserts a place for the frame number.
QString withNumber(QString path) {
    if (!path.isEmpty() && !QFileInfo(path).fileName().contains('#'))
        path.insert(path.size() - QFileInfo(path).suffix().size() - 1, QStringLiteral("_####"));
    return path;
}

QString workOf(ExportKind kind, int count) {
    switch (kind) {
        case ExportKind::Picture:
            return Exporter::tr("Writing the picture …");
        case ExportKind::Film:
            return Exporter::tr("Writing the film …");
        case ExportKind::Frames:
            return Exporter::tr("Writing %n frames …", nullptr, count);
        case ExportKind::StMap:
            return Exporter::tr("Writing the ST map …");
        case ExportKind::Mesh:
            break;
    }
    return Exporter::tr("Writing the mesh …");
}

QString questionOf(OwnFile own, const QString& name) {
    switch (own) {
        case OwnFile::Project:
            return Exporter::tr("“%1” is this project itself. Replace it?").arg(name);
        case OwnFile::Picture:
            return Exporter::tr("“%1” is the picture that this project bends. Replace it?").arg(name);
        case OwnFile::Mesh:
            return Exporter::tr("“%1” is the mesh that this project bends. Replace it?").arg(name);
        case OwnFile::Sizes:
        case OwnFile::Detail:
        case OwnFile::Material:
        case OwnFile::Look:
        case OwnFile::States:
        case OwnFile::Motion:
        case OwnFile::Points:
        case OwnFile::Audio:
            break;
    }
    return Exporter::tr("“%1” belongs to this project. Replace it?").arg(name);
}

/// Returns how much of a run is done. Its progress within a step, which names both, does not count.
double wholePart(const std::string& work, double part, double deforming) {
    if (deforming == 0) return part;
    if (work == "deforming") return deforming * part;
    return work == "warping" ? deforming + (1 - deforming) * part : 0;
}

}  // namespace

Exporter::Exporter(const Playback& playback, const ShapeMotion& motion, QWidget& window)
    : QObject(&window),
      m_playback(playback),
      m_motion(motion),
      m_document(motion.document()),
      m_window(window) {
    connect(&m_document, &Document::opened, this, [this] {
        m_crop.set({});
        m_choices = {m_choices.formats};
    });
}

/// Waits, because background work reports to this object.
Exporter::~Exporter() {
    if (m_stop) m_stop->request_stop();
    m_running.wait();
}

/// Only one export runs at a time. Until its progress is shown, the window stays usable.
bool Exporter::isFree() {
    if (!m_running.isRunning()) return true;
    emit failed(tr("Another export is still being written. Try again in a moment."));
    return false;
}

QString Exporter::whyNot() const {
    if (m_motion.isBusy()) return tr("The shape is still being computed. Try again in a moment.");
    if (m_motion.frame() && !m_motion.isStale() && !m_motion.hasFailed()) return {};
    return tr("There is no shape to export: it could not be computed.");
}

FramePtr Exporter::shownFrame() {
    if (!isFree()) return {};
    const QString why = whyNot();
    if (why.isEmpty()) return m_motion.frame();
    emit failed(why);
    return {};
}

std::shared_ptr<const FrameExport> Exporter::shownShape() const {
    const double seconds = m_playback.end() * Playback::kSecondsPerUnit;
    return std::make_shared<const FrameExport>(m_document, m_motion.frame(), m_motion.track().frames(),
                                               seconds);
}

ExportSubject Exporter::subject(ExportKind kind) const {
    const auto shape = shownShape();
    const bool solid = shape->dimension() == 3 && m_looks.solid;
    return {kind, shape, solid ? seenPart(m_looks.solid(kSolidPreview)) : QImage(),
            m_looks.picture ? m_looks.picture() : nullptr, m_crop.now()};
}

void Exporter::ask(ExportKind kind) {
    if (!shownFrame()) return;
    const bool needsPicture = kind != ExportKind::Frames && kind != ExportKind::Mesh;
    const ExportSubject subject = this->subject(kind);
    if (needsPicture && !subject.shape->picture()) return;
    emit begun();
    const ExportChoices before = m_choices;
    ExportDialog dialog(subject, m_choices, &m_window);
    while (dialog.exec() == QDialog::Accepted)
        if (writeAs(dialog.form())) return;
    m_choices = before;
}

bool Exporter::writeAs(const ExportForm& form) {
    const RunOptions options = runOptionsFrom(form.values());
    const QString path = askName(form);
    if (path.isEmpty() || !mayReplace(form.kind(), path, options.outputs.count)) return false;
    write(form.kind(), path, options);
    return true;
}

QString Exporter::askName(const ExportForm& form) {
    const QString base = QFileInfo(m_document.displayName()).completeBaseName();
    const QString proposal = QDir(proposedFolder(m_document)).filePath(base + suffixOf(form));
    const QString path = askFileToWrite(&m_window, ExportDialog::title(form.kind()), proposal, form.filter());
    return form.kind() == ExportKind::Frames && !form.isFilm() ? withNumber(path) : path;
}

bool Exporter::mayReplace(ExportKind kind, const QString& path, int count) {
    const auto own = ownFileAt(m_document, path, count);
    const int frames = kind == ExportKind::Frames ? existingFrames(path, count) : 0;
    if (!own && frames == 0) return true;
    const QString name = QFileInfo(path).fileName();
    QMessageBox box(
        QMessageBox::Warning, tr("Wend"),
        own ? questionOf(*own, name) : tr("Replace the frames that already exist (%n)?", nullptr, frames),
        QMessageBox::Cancel, &m_window);
    box.setInformativeText(
        own ? tr("What it holds now will be lost, and the project will no longer open as it is.")
            : tr("What they hold now will be lost."));
    QPushButton* replace = box.addButton(tr("Replace"), QMessageBox::DestructiveRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == replace;
}

void Exporter::write(ExportKind kind, QString path, const RunOptions& options) {
    if (!shownFrame()) return;
    const auto shape = shownShape();
    if (kind == ExportKind::Frames && !isAnimation(path.toStdString())) path = withNumber(path);
    emit begun();
    // A canvas that fits is known when all frames are: only then are they painted.
    const double deforming = !isMotion(kind) ? 0 : options.canvas.kind == Canvas::Fit ? 0.5 : 1;
    run(workOf(kind, options.outputs.count), path, deforming,
        [=](const RunWatch& watch, std::string& remark) {
            RunWatch heard = watch;
            if (kind != ExportKind::Mesh) heard.notice = {};  // a mesh names what its format does not hold
            shape->write(kind, path.toStdString(), options, heard, remark);
        });
}

void Exporter::exportMaterial(MaterialPart part) {
    if (!shownFrame()) return;
    const QString base = QFileInfo(m_document.displayName()).completeBaseName();
    const QString name = base + (part == MaterialPart::Keep        ? QStringLiteral("-keep.png")
                                 : part == MaterialPart::Stiffness ? QStringLiteral("-stiffness.png")
                                                                   : QStringLiteral("-direction.png"));
    const QString path =
        askFileToWrite(&m_window, tr("Export Material"), QDir(proposedFolder(m_document)).filePath(name),
                       tr("Pictures (*.png *.tif *.exr)"));
    if (!path.isEmpty() && mayReplace(ExportKind::Picture, path, 0)) writeMaterial(part, path);
}

void Exporter::writeMaterial(MaterialPart part, const QString& path) {
    const auto shown = posed<2>(shownFrame());
    if (!shown) return;
    const auto picture = m_document.picture();
    emit begun();
    run(tr("Writing the picture …"), path, 0, [=](const RunWatch&, std::string&) {
        const PictureFrame frame =
            pictureFrame(picture ? picture->width : 0, picture ? picture->height : 0, *shown->rest);
        writeImage(path.toStdString(), materialPicture(part, frame, *shown->rest, *shown->material));
    });
}

/// `deforming` is the share of the work that it takes to deform the shape.
void Exporter::run(const QString& what, const QString& path, double deforming, Job job) {
    auto* dialog = new QProgressDialog(what, tr("Cancel"), 0, 1000, &m_window);
    dialog->setWindowModality(Qt::WindowModal);
    dialog->setMinimumDuration(400);
    dialog->setAutoReset(false);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setValue(0);
    auto source = std::make_shared<std::stop_source>();
    m_stop = source;
    connect(dialog, &QProgressDialog::canceled, this, [source] { source->request_stop(); });
    const auto show = [this, deforming, shown = QPointer<QProgressDialog>(dialog)](const std::string& work,
                                                                                   double part) {
        const double done = wholePart(work, part, deforming);
        m_out.call([shown, done] {
            if (shown) shown->setValue(std::max(shown->value(), static_cast<int>(1000 * done)));
        });
    };
    // Futures would slice an exception.
    const auto work = [job = std::move(job), show, source]() -> Result {
        std::string remark;
        QStringList notices;
        const auto hear = [&notices](const Message& text) { notices << said(text); };
        try {
            job({show, hear, source->get_token()}, remark);
            return {{}, QString::fromStdString(remark), source->stop_requested(), notices};
        } catch (const Cancelled&) {
            return {{}, {}, true};
        } catch (const std::exception& error) {
            return {said(error), {}, false};
        }
    };
    m_running = inBackground(this, work,
                             [this, shown = QPointer<QProgressDialog>(dialog), path](const Result& result) {
                                 if (shown) shown->deleteLater();
                                 tell(result, path);
                             });
}

void Exporter::tell(const Result& result, const QString& path) {
    const QString name = QDir::toNativeSeparators(path);
    if (!result.error.isEmpty())
        emit failed(tr("Nothing was written. %1").arg(result.error));
    else if (!result.stopped && !result.remark.isEmpty())
        emit done(tr("Written without velocities: %1 (%2)").arg(name, result.remark));
    else if (!result.stopped)
        emit done((QStringList{tr("Written: %1").arg(name)} + result.notices).join(QStringLiteral(". ")));
}

MaterialActions::MaterialActions(Document& document, const ShapeMotion& motion, Exporter& exporter,
                                 QObject* parent)
    : ActionMaker(parent), m_document(document), m_motion(motion), m_menu(new QMenu) {
    using enum MaterialPart;
    const auto take = [this](MaterialPart part) { return [this, part] { ask(part); }; };
    const auto give = [&exporter](MaterialPart part) {
        return [&exporter, part] { exporter.exportMaterial(part); };
    };
    bringIn[Keep] =
        add("importKeep",
            {tr("Import &Keep…"),
             tr("A grey picture over the whole, as a layer: black keeps area, white keeps angles")},
            {}, take(Keep));
    bringIn[Stiffness] =
        add("importStiffness",
            {tr("Import &Stiffness…"), tr("A grey picture over the whole, as a layer: black is the same as "
                                          "everywhere, white is 1000 times stiffer")},
            {}, take(Stiffness));
    bringIn[Direction] =
        add("importDirection",
            {tr("Import &Directions…"), tr("A grey picture over the whole, as a layer, of the direction of "
                                           "stiffness: black is level, middle grey upright")},
            {}, take(Direction));
    cells = add("cells",
                {tr("Import Values of &Cells…"),
                 tr("φ and B of every cell from a mesh file that contains them, such as an exported one")},
                {}, [this] { askCells(); });
    write[Keep] =
        add("exportKeep", {tr("Export K&eep…"), tr("As a grey picture, to be edited in a paint program")}, {},
            give(Keep));
    write[Stiffness] =
        add("exportStiffness",
            {tr("Export S&tiffness…"), tr("As a grey picture, to be edited in a paint program")}, {},
            give(Stiffness));
    write[Direction] =
        add("exportDirection",
            {tr("Export Di&rections…"), tr("As a grey picture, to be edited in a paint program")}, {},
            give(Direction));
    m_menu->setTitle(tr("&Material"));
    for (const auto& [part, action] : bringIn) m_menu->addAction(action);
    m_menu->addAction(cells);
    m_menu->addSeparator();
    for (const auto& [part, action] : write) m_menu->addAction(action);
    connect(&m_motion, &ShapeMotion::frameChanged, this, &MaterialActions::refresh);
    refresh();
}

void MaterialActions::refresh() {
    const bool solid = m_document.dimension() == 3;
    const bool has = m_motion.frame() != nullptr;
    const QString why = !has ? tr("Open a picture first.")
                             : tr("For a solid, these are values of cells; they are exported with its mesh.");
    for (const auto* actions : {&bringIn, &write})
        for (const auto& [part, action] : *actions) enable(action, has && !solid, why);
    const bool isMesh = has && m_document.domain().kind == DomainKind::Mesh;
    enable(cells, isMesh, has ? tr("Only the cells of a mesh file stay the same.") : why);
}

void MaterialActions::ask(MaterialPart part) {
    QString title = bringIn[part]->text().remove('&');
    const QString path =
        QFileDialog::getOpenFileName(QApplication::activeWindow(), title, proposedFolder(m_document),
                                     tr("Pictures (%1)").arg(pictureExtensions()));
    if (!path.isEmpty()) take(part, path);
}

void MaterialActions::take(MaterialPart part, const QString& path) try {
    readImageHeader(path.toStdString());
    const auto& picture = m_document.picture();
    const auto shown = m_motion.frame<2>();
    if (!shown) return;
    const PictureFrame frame =
        pictureFrame(picture ? picture->width : 0, picture ? picture->height : 0, *shown->rest);
    MaterialPictures pictures;
    pictures.*fileOf(part) = path.toStdString();
    pictures.up = frame.up;
    m_document.changeDesign(
        tr("Import %1").arg(QFileInfo(path).fileName()),
        withPictures(m_document.design(), QFileInfo(path).completeBaseName().toStdString(), frame.box,
                     pictures));
} catch (const InputError& error) {
    emit failed(said(error));
}

void MaterialActions::askCells() {
    const QString path =
        QFileDialog::getOpenFileName(QApplication::activeWindow(), cells->text().remove('&'),
                                     proposedFolder(m_document), tr("Values of cells (*.vtu *.vtk *.json)"));
    if (!path.isEmpty()) takeCells(path);
}

/// Hides all layers, because the values already include them and they would apply twice.
void MaterialActions::takeCells(const QString& path) {
    m_document.changeDesign(tr("Import %1").arg(QFileInfo(path).fileName()),
                            withCellsFile(withAllHidden(m_document.design()), path.toStdString()));
    m_document.notify(tr("The layers were switched off: what was imported lies below them."));
}

}  // namespace wend
