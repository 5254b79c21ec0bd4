#include "app/window/files/choosers.h"

#include <QFileDialog>
#include <QFileInfo>

#include "app/base/in_background.h"
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

/// A project with another motion, or why there is none.
struct Applied {
    TransferredMotion motion;
    QString error;
};

Applied tryToApply(const QString& path, const Project& project, const QString& folder) {
    Applied outcome;
    try {
        outcome.motion = withMotionOf(path.toStdString(), project, folder.toStdString());
    } catch (const std::exception& error) {
        outcome.error = said(error);
    }
    return outcome;
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
    const int ticket = ++m_ticket;
    const auto before = m_document.project();
    const auto work = [path, before, folder = m_document.folder()] {
        return tryToApply(path, *before, folder);
    };
    inBackground(this, work, [this, ticket, before, path](const Applied& outcome) {
        if (ticket != m_ticket || m_document.project() != before) return;
        if (!outcome.error.isEmpty()) {
            emit failed(tr("This motion cannot be applied. %1").arg(outcome.error));
            return;
        }
        m_document.change(tr("Apply motion of %1").arg(QFileInfo(path).fileName()), outcome.motion.project);
        QStringList remarks;
        for (const Message& notice : outcome.motion.notices) remarks << said(notice);
        emit applied(remarks.join('\n'));
    });
}

}  // namespace wend
