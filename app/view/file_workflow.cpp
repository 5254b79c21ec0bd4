#include "app/view/file_workflow.h"

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QWindow>
#include <QtConcurrent>

#include "app/session/opening.h"
#include "core/mesh/printable.h"

namespace wend {

namespace {

constexpr int kMostRecent = 10;

QString said(const std::exception& error) {
    return QString::fromStdString(messageOf(error));
}

/// What came of reading a file in the background. (Futures would slice the exception.)
struct Reading {
    OpenedFile file;
    QString error;
};

Reading tryToRead(const std::function<OpenedFile()>& reader) {
    try {
        return {reader(), {}};
    } catch (const std::exception& error) {
        return {{}, said(error)};
    }
}

}  // namespace

FileWorkflow::FileWorkflow(Document& document, QWidget& window)
    : QObject(&window), m_document(document), m_window(window) {}

void FileWorkflow::askOpen() {
    const QString all = QStringLiteral("*.wend ") + pictureExtensions() + ' ' + meshExtensions();
    const QString filters = tr("All that Wend opens (%1)").arg(all) + QStringLiteral(";;") +
                            tr("Pictures (%1)").arg(pictureExtensions()) + QStringLiteral(";;") +
                            tr("Projects (*.wend)") + QStringLiteral(";;") +
                            tr("Meshes (%1)").arg(meshExtensions());
    QSettings settings;
    const QString path =
        QFileDialog::getOpenFileName(&m_window, tr("Open"), settings.value("folder").toString(), filters);
    if (!path.isEmpty()) open(path);
}

void FileWorkflow::open(const QString& path) {
    if (mayLeave()) read(QFileInfo(path).fileName(), [path] { return openFile(path); });
}

void FileWorkflow::read(const QString& name, std::function<OpenedFile()> reader) {
    const int ticket = ++m_ticket;
    emit openingChanged(name);
    const auto before = m_document.project();
    QtConcurrent::run([reader = std::move(reader)] {
        return tryToRead(reader);
    }).then(this, [this, ticket, before](const Reading& reading) {
        emit openingChanged({});
        if (!reading.error.isEmpty()) {
            emit failed(tr("This file cannot be opened. %1").arg(reading.error));
        } else if (ticket == m_ticket) {
            const bool changedMeanwhile = m_document.project() != before;
            if (!changedMeanwhile || mayLeave()) take(reading.file);
        }
    });
}

bool FileWorkflow::guardWork(const QString& folder, const QString& instead) {
    m_recovery = new Recovery(m_document, folder);
    m_recovery->setParent(this);
    connect(m_recovery, &Recovery::failed, this, [this](const QString& why) {
        emit failed(tr("There is no copy of your changes if the program crashes: please save. %1").arg(why));
    });
    // The copy that was recovered goes when there is a new one, or when the work is saved.
    const auto discardRecovered = [this] {
        if (!m_recoveredFrom.isEmpty()) Recovery::discard(m_recoveredFrom);
        m_recoveredFrom.clear();
    };
    connect(m_recovery, &Recovery::written, this, discardRecovered);
    connect(&m_document, &Document::saved, this, discardRecovered);
    const QList<LostWork> lost = Recovery::lostIn(folder);
    return !lost.isEmpty() && offer(lost.first(), instead);
}

/// Only when a window is shown does the window manager place it: what is asked later stands in its middle.
void FileWorkflow::waitForPlace() const {
    const QDeadlineTimer patience(1000);
    const auto waits = [this] { return m_window.windowHandle() && !m_window.windowHandle()->isExposed(); };
    while (m_window.isVisible() && waits() && !patience.hasExpired())
        QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    QCoreApplication::processEvents();
}

/// One at a time: others are offered at the next start.
bool FileWorkflow::offer(const LostWork& work, const QString& instead) {
    waitForPlace();
    const QString name = QFileInfo(work.path.isEmpty() ? work.source : work.path).fileName();
    QMessageBox box(QMessageBox::NoIcon, tr("Wend"), tr("Recover unsaved changes to “%1”?").arg(name),
                    QMessageBox::NoButton, &m_window);
    box.setTextFormat(Qt::PlainText);
    QString more = tr("Wend was not closed properly. The last change was on %1.")
                       .arg(QLocale().toString(work.time, QLocale::ShortFormat));
    if (!instead.isEmpty()) more += ' ' + tr("“%1” is not opened then.").arg(QFileInfo(instead).fileName());
    box.setInformativeText(more);
    QPushButton* recover = box.addButton(tr("Recover"), QMessageBox::AcceptRole);
    QPushButton* discard = box.addButton(tr("Discard"), QMessageBox::DestructiveRole);
    box.addButton(tr("Later"), QMessageBox::RejectRole);
    box.setDefaultButton(recover);
    box.exec();
    if (box.clickedButton() == discard) Recovery::discard(work.copy);
    if (box.clickedButton() != recover) return false;
    read(name, [work] { return openLost(work); });
    return true;
}

void FileWorkflow::take(OpenedFile file) {
    const QStringList warnings = file.warnings;
    const QString source = file.source;
    m_recoveredFrom = file.recoveredFrom;
    m_document.open(std::move(file));
    if (m_recoveredFrom.isEmpty()) addRecent(source);
    if (!warnings.isEmpty()) emit failed(warnings.join('\n'));
}

bool FileWorkflow::save() {
    if (m_document.path().isEmpty()) return saveAs();
    return !m_document.isModified() || saveTo(m_document.path());
}

/// Beside the project's or the picture's file, but not among the samples.
QString FileWorkflow::proposedPath() const {
    if (!m_document.path().isEmpty()) return m_document.path();
    return QDir(proposedFolder(m_document))
        .filePath(QFileInfo(m_document.source()).completeBaseName() + QStringLiteral(".wend"));
}

bool FileWorkflow::saveAs() {
    QString path =
        QFileDialog::getSaveFileName(&m_window, tr("Save Project"), proposedPath(), tr("Projects (*.wend)"));
    if (path.isEmpty()) return false;
    if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".wend");
    return saveTo(path);
}

bool FileWorkflow::saveTo(const QString& path) {
    try {
        m_document.save(path);
    } catch (const InputError& error) {
        emit failed(tr("The project was not saved. %1").arg(said(error)));
        return false;
    }
    addRecent(path);
    return true;
}

void FileWorkflow::close() {
    if (!mayLeave()) return;
    ++m_ticket;
    m_document.close();
}

bool FileWorkflow::mayLeave() {
    if (m_document.isEmpty() || !m_document.isModified()) return true;
    QMessageBox box(QMessageBox::NoIcon, tr("Wend"),
                    tr("Save the changes to “%1”?").arg(m_document.displayName()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &m_window);
    box.setTextFormat(Qt::PlainText);
    box.setInformativeText(tr("If you do not save, they are lost."));
    box.setDefaultButton(QMessageBox::Save);
    const int answer = box.exec();
    if (answer == QMessageBox::Save) return save();
    if (answer != QMessageBox::Discard) return false;
    if (!m_recoveredFrom.isEmpty()) Recovery::discard(m_recoveredFrom);
    return true;
}

QStringList FileWorkflow::recent() const {
    QStringList existing;
    for (const QString& path : QSettings().value("recent").toStringList())
        if (QFileInfo::exists(path)) existing << path;
    return existing;
}

void FileWorkflow::addRecent(const QString& path) {
    QSettings settings;
    settings.setValue("folder", QFileInfo(path).absolutePath());
    if (samplePaths().contains(path)) return;
    QStringList paths = recent();
    paths.removeAll(path);
    paths.prepend(path);
    settings.setValue("recent", paths.mid(0, kMostRecent));
    emit recentChanged();
}

void FileWorkflow::fillRecent(QMenu& menu) {
    menu.clear();
    for (const QString& path : recent()) {
        QAction* action = menu.addAction(QFileInfo(path).fileName(), this, [this, path] { open(path); });
        action->setStatusTip(QDir::toNativeSeparators(path));
    }
    menu.setEnabled(!menu.isEmpty());
}

void FileWorkflow::fillSamples(QMenu& menu) {
    menu.clear();
    for (const QString& path : samplePaths())
        menu.addAction(QFileInfo(path).completeBaseName(), this, [this, path] { open(path); });
    menu.setEnabled(!menu.isEmpty());
}

}  // namespace wend
