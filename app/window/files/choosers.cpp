#include "app/window/files/choosers.h"

#include <QFileDialog>
#include <QFileInfo>

#include "app/base/preferences.h"
#include "app/base/said.h"
#include "app/engine/motion_transfer.h"
#include "app/project/domain.h"
#include "app/project/edits/document.h"
#include "core/base/error.h"
#include "core/mesh/mesh_formats.h"
#include "core/mesh/skin_file.h"

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

}  // namespace

DetailChooser::DetailChooser(Document& document, QWidget& window)
    : QObject(&window), m_document(document), m_window(window) {}

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
        if (!skin.problem.isEmpty()) {
            emit failed(tr("This surface cannot be embedded in the solid. %1").arg(skin.problem));
            return;
        }
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

MotionChooser::MotionChooser(Document& document, QWidget& window)
    : QObject(&window), m_document(document), m_window(window) {}

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
        if (!motion.problem.isEmpty()) {
            emit failed(tr("This motion cannot be applied. %1").arg(motion.problem));
            return;
        }
        m_document.change(tr("Apply motion of %1").arg(QFileInfo(path).fileName()), motion.value.project);
        QStringList remarks;
        for (const Message& notice : motion.value.notices) remarks << said(notice);
        emit applied(remarks.join('\n'));
    });
}

}  // namespace wend
