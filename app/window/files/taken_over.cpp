#include "app/window/files/taken_over.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <cmath>

#include "app/base/preferences.h"
#include "app/base/said.h"
#include "app/engine/motion_transfer.h"
#include "app/engine/shape/flat_shape.h"
#include "app/project/domain.h"
#include "app/project/edits/document.h"
#include "app/project/edits/scaled_project.h"
#include "app/project/file/named_files.h"
#include "app/project/project.h"
#include "app/session/opening.h"
#include "app/window/export/dialogs.h"
#include "app/window/files/project_watch.h"
#include "core/base/error.h"
#include "core/mesh/mesh_formats.h"
#include "core/mesh/skin_file.h"
#include "warp/image.h"

namespace wend {

namespace {

/// Throws InputError for what cannot be embedded.
Skin readDetail(const std::string& path) {
    Skin skin = readSkin(path);
    if (skin.triangles.empty()) throw InputError(path, "has no triangle");
    if (!skin.points.allFinite()) throw InputError(path, "has coordinates that are not finite numbers");
    return skin;
}

QString surfacePatterns() {
    QStringList patterns;
    for (const MeshFormatFacts& format : meshFormatFacts())
        if (!format.holdsTetrahedra)
            for (const auto& extension : format.extensions)
                patterns << '*' + QString::fromUtf8(extension.data(), extension.size());
    return patterns.join(' ');
}

QSpinBox* sideBox(int now, int other, QWidget* parent) {
    auto* box = new QSpinBox(parent);
    const double longest = std::sqrt(1e6 * kMaxMegapixels * now / other);
    box->setRange(1, static_cast<int>(longest));
    box->setValue(now);
    box->setSuffix(DrawingSizeDialog::tr(" px"));
    box->setSingleStep(100);
    return box;
}

QDoubleSpinBox* percentBox(const DrawnSize& now, const DrawnSize& first, QWidget* parent) {
    auto* box = new QDoubleSpinBox(parent);
    box->setDecimals(1);
    box->setRange(0.1, 100 * std::sqrt(1e6 * kMaxMegapixels / first[0] / first[1]));
    box->setValue(100.0 * now[0] / first[0]);
    box->setSuffix(DrawingSizeDialog::tr(" %"));
    box->setSingleStep(50);
    return box;
}

using Topic = InfoBanner::Topic;

/// Returns the paths of all picture files of the document.
QStringList picturesOf(const Document& document) {
    QStringList files;
    if (document.isEmpty() || document.dimension() != 2) return files;
    const auto add = [&](const std::string& file) {
        if (file.empty()) return;
        const QString path = QString::fromStdString(pathIn(document.folder().toStdString(), file));
        if (!files.contains(path)) files << path;
    };
    const Domain& domain = document.domain();
    if (domain.kind == DomainKind::Image) add(domain.path);
    add(domain.texture);
    for (const PicturePart& part : domain.parts) add(part.path);
    return files;
}

}  // namespace

DetailChooser::DetailChooser(Document& document, InfoBanner& banner, QWidget& window)
    : QObject(&window), m_document(document), m_banner(banner), m_window(window) {}

void DetailChooser::ask() {
    const QString path =
        QFileDialog::getOpenFileName(&m_window, tr("Choose Skin"), preferences::folder.value(),
                                     tr("Surfaces (%1)").arg(surfacePatterns()));
    if (path.isEmpty()) return;
    preferences::folder.set(QFileInfo(path).absolutePath());
    read(QFileInfo(path).absoluteFilePath());
}

/// Reads in the background, because the file may be large.
void DetailChooser::read(const QString& path) {
    const auto look = [path] { return readDetail(path.toStdString()); };
    m_reading.ask(look, [this, path, generation = m_document.generation()](const Answer<Skin>& skin) {
        if (generation != m_document.generation()) return;
        if (!skin.problem.isEmpty())
            return m_banner.tell(Topic::Export,
                                 tr("This surface cannot be embedded in the solid. %1").arg(skin.problem));
        Domain next = m_document.domain();
        next.detail = path.toStdString();
        m_document.changeDomain(tr("Choose skin"), std::move(next));
        emit chosen();
    });
}

void DetailChooser::remove() {
    if (m_document.isEmpty() || m_document.domain().detail.empty()) return;
    m_reading.drop();
    Domain next = m_document.domain();
    next.detail.clear();
    m_document.changeDomain(tr("Remove skin"), std::move(next));
}

MotionChooser::MotionChooser(Document& document, InfoBanner& banner, QWidget& window)
    : QObject(&window), m_document(document), m_banner(banner), m_window(window) {}

void MotionChooser::ask() {
    const QString path = QFileDialog::getOpenFileName(&m_window, tr("Apply Motion of Another Project"),
                                                      preferences::folder.value(), tr("Projects (*.wend)"));
    if (path.isEmpty()) return;
    preferences::folder.set(QFileInfo(path).absolutePath());
    apply(QFileInfo(path).absoluteFilePath());
}

void MotionChooser::apply(const QString& path) {
    if (m_document.isEmpty()) return;
    const auto before = m_document.project();
    const auto work = [path, before, folder = m_document.folder()](const std::stop_token& stop) {
        return withMotionOf(path.toStdString(), *before, folder.toStdString(), stop);
    };
    m_applying.ask(work, [this, before, path](const Answer<TransferredMotion>& motion) {
        if (m_document.project() != before) return;
        if (!motion.problem.isEmpty())
            return m_banner.tell(Topic::Opening, tr("This motion cannot be applied. %1").arg(motion.problem));
        m_document.change(tr("Apply motion of %1").arg(QFileInfo(path).fileName()), motion.value.project);
        QStringList remarks;
        for (const Message& notice : motion.value.notices) remarks << said(notice);
        m_banner.clear(Topic::Opening);
        m_banner.tell(Topic::Remark, remarks.join('\n'));
    });
}

DrawingSizeDialog::DrawingSizeDialog(const DrawnSize& now, const DrawnSize& first, QWidget* parent)
    : QDialog(parent),
      m_first(first),
      m_width(sideBox(now[0], now[1], this)),
      m_height(sideBox(now[1], now[0], this)),
      m_percent(percentBox(now, first, this)) {
    setWindowTitle(tr("Drawing Size"));
    auto* help =
        new QLabel(tr("The drawing becomes a picture of this size. Pins, paths and regions are scaled with "
                      "it; exported SVG files keep the drawing's own units."),
                   this);
    help->setWordWrap(true);
    auto* form = new QFormLayout(this);
    form->addRow(help);
    form->addRow(tr("&Width"), m_width);
    form->addRow(tr("&Height"), m_height);
    form->addRow(tr("&Scale"), m_percent);
    m_percent->setToolTip(tr("Of the size at which the drawing is opened"));
    form->addRow(dialogButtons(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this));
    const double proportion = static_cast<double>(now[1]) / now[0];
    tie(m_width, m_height, proportion);
    tie(m_height, m_width, 1 / proportion);
    connect(m_percent, &QDoubleSpinBox::valueChanged, this, &DrawingSizeDialog::takePercent);
    m_width->selectAll();
}

/// Lets the other side follow one, and the percent.
void DrawingSizeDialog::tie(QSpinBox* side, QSpinBox* other, double proportion) {
    connect(side, &QSpinBox::valueChanged, this, [=, this](int value) {
        const QSignalBlocker blocker(other), also(m_percent);
        other->setValue(static_cast<int>(std::lround(value * proportion)));
        m_percent->setValue(100.0 * m_width->value() / m_first[0]);
    });
}

void DrawingSizeDialog::takePercent(double percent) {
    const QSignalBlocker blocker(m_width), also(m_height);
    m_width->setValue(static_cast<int>(std::lround(percent / 100 * m_first[0])));
    m_height->setValue(static_cast<int>(std::lround(percent / 100 * m_first[1])));
}

DrawnSize DrawingSizeDialog::size() const {
    return {m_width->value(), m_height->value()};
}

PictureKeeper::PictureKeeper(Document& document, InfoBanner& banner, QAction& fit, QWidget& window)
    : QObject(&window), m_document(document), m_banner(banner), m_fit(fit), m_window(window) {
    connect(&document, &Document::opened, this, [this] {
        m_files.clear();  // of another document, though perhaps the same ones
        m_reading.drop();
        follow();
    });
    connect(&document, &Document::projectChanged, this, &PictureKeeper::follow);
}

/// Watches the pictures that the project names now.
void PictureKeeper::follow() {
    const QStringList files = picturesOf(m_document);
    if (files == m_files) return;
    m_files = files;
    qDeleteAll(m_watch);
    m_watch.clear();
    m_banner.clear(Topic::Picture);
    for (const QString& file : files) {
        auto* watch = new ProjectWatch(this);
        m_watch << watch;
        watch->watch(file, stampOf(file));
        connect(watch, &ProjectWatch::changed, this, [this, watch, file](bool isOther) {
            isOther ? tellChanged(*watch, file) : m_banner.clear(Topic::Picture);
        });
    }
}

void PictureKeeper::tellChanged(ProjectWatch& watch, const QString& file) {
    const auto keep = [this, &watch] {
        watch.accept();
        m_banner.clear(Topic::Picture);
    };
    m_banner.tell(Topic::Picture,
                  tr("The picture “%1” was changed by another program.").arg(QFileInfo(file).fileName()),
                  {{tr("Reload"), [this] { reload(); }}, {tr("Keep"), keep}});
}

void PictureKeeper::reload() {
    if (m_document.isEmpty()) return;
    for (ProjectWatch* watch : std::as_const(m_watch)) watch->accept();
    m_banner.clear(Topic::Picture);
    Project next = *m_document.project();
    ++next.domain.readings;
    exchange(next, tr("Reload picture"), true);
}

void PictureKeeper::askReplace() {
    const QString path =
        QFileDialog::getOpenFileName(&m_window, tr("Replace Picture"), preferences::folder.value(),
                                     tr("Pictures (%1)").arg(pictureExtensions()));
    if (path.isEmpty()) return;
    preferences::folder.set(QFileInfo(path).absolutePath());
    replace(QFileInfo(path).absoluteFilePath());
}

void PictureKeeper::replace(const QString& path) {
    if (m_document.isEmpty() || !m_document.picture()) return;
    Project next = *m_document.project();
    next.domain.path = path.toStdString();
    next.domain.readings = 0;
    exchange(next, tr("Replace picture"), false);
}

void PictureKeeper::askSize() {
    if (m_document.isEmpty()) return;
    const std::string folder = m_document.folder().toStdString();
    try {
        const DrawnSize now = drawnSize(m_document.domain(), folder);
        Domain first = m_document.domain();
        first.size = {};
        DrawingSizeDialog dialog(now, drawnSize(first, folder), &m_window);
        if (dialog.exec() == QDialog::Accepted && dialog.size() != now) redraw(dialog.size());
    } catch (const std::exception& error) {
        m_banner.tell(Topic::Picture, tr("The picture cannot be read. %1").arg(wend::said(error)));
    }
}

void PictureKeeper::redraw(const DrawnSize& size) {
    Project next = *m_document.project();
    next.domain.size = size;
    ++next.domain.readings;
    exchange(next, tr("Change drawing size"), true);
}

/// Reads the picture of a project that is to follow, and changes to it. `mayDiffer`: it stays as it is if the
/// proportions of the pictures differ.
void PictureKeeper::exchange(const Project& next, const QString& name, bool mayDiffer) {
    using Picture = std::shared_ptr<const Image>;
    const auto before = m_document.project();
    const auto work = [domain = next.domain, folder = m_document.folder()]() -> Picture {
        return loadPicture(domain, folder.toStdString());
    };
    m_reading.ask(work, [this, before, next, name, mayDiffer](const Answer<Picture>& reading) {
        if (m_document.project() != before) return;
        const auto tell = [this](const QString& text) { m_banner.tell(Topic::Picture, text); };
        if (!reading.problem.isEmpty())
            return tell(tr("The picture cannot be read. %1").arg(reading.problem));
        const Picture& picture = reading.value;
        const auto was = m_document.picture();
        Project fitted = next;
        QString note;
        const bool isSized = next.domain.parts.empty() || next.domain.size != before->domain.size;
        if (was && picture && next.domain.kind == DomainKind::Image && isSized) {
            const double factor = factorBetween({was->width, was->height}, {picture->width, picture->height});
            const QString sizes = tr("It has %1 × %2 pixels, and the picture before had %3 × %4.")
                                      .arg(picture->width)
                                      .arg(picture->height)
                                      .arg(was->width)
                                      .arg(was->height);
            if (factor == 0 && !mayDiffer)
                return tell(tr("This picture has other proportions. %1").arg(sizes));
            if (factor == 0) note = tr("The picture has other proportions now. %1").arg(sizes);
            if (factor != 0 && factor != 1) note = tr("Pins and paths are scaled with it. %1").arg(sizes);
            if (factor != 0) scalePixels(fitted, factor);
            if (fitted.domain.size[0] > 0)  // old projects stay without it
                fitted.domain.size = {picture->width, picture->height};
        }
        m_document.keepPicture(fitted.domain.path, fitted.domain.readings, picture);
        const bool isResized =
            picture && was && (was->width != picture->width || was->height != picture->height);
        m_document.change(name, std::move(fitted));
        if (isResized) m_fit.trigger();
        if (!note.isEmpty()) tell(note);  // the change takes earlier lines back
    });
}

}  // namespace wend
