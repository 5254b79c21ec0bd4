#include "app/window/files/motion_chooser.h"

#include <QFileDialog>
#include <QFileInfo>

#include "app/base/in_background.h"
#include "app/base/preferences.h"
#include "app/base/said.h"
#include "app/engine/applied_motion.h"
#include "app/project/edits/document.h"
#include "core/base/error.h"

namespace wend {
namespace {

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
