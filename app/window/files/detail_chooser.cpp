#include "app/window/files/detail_chooser.h"

#include <QFileDialog>
#include <QFileInfo>

#include "app/base/in_background.h"
#include "app/base/preferences.h"
#include "app/base/said.h"
#include "app/project/domain.h"
#include "core/base/error.h"
#include "core/mesh/mesh_formats.h"
#include "core/mesh/skin_file.h"

namespace wend {

namespace {

/// Returns the problem of a file; empty if it is usable.
QString problemOf(const QString& path) try {
    const Skin skin = readSkin(path.toStdString());
    if (skin.triangles.empty()) throw InputError(path.toStdString(), "has no triangle");
    if (!skin.points.allFinite())
        throw InputError(path.toStdString(), "has coordinates that are not finite numbers");
    return {};
} catch (const std::exception& error) {
    return said(error);
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
    const int ticket = ++m_ticket, generation = m_document.generation();
    const auto look = [path] { return problemOf(path); };
    inBackground(this, look, [this, path, ticket, generation](const QString& problem) {
        if (ticket != m_ticket || generation != m_document.generation()) return;
        if (!problem.isEmpty()) {
            emit failed(tr("This surface cannot be embedded in the solid. %1").arg(problem));
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
    ++m_ticket;
    Domain next = m_document.domain();
    next.detail.clear();
    m_document.changeDomain(tr("Remove skin"), std::move(next));
}

}  // namespace wend
