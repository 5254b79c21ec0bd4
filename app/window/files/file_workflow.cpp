#include "app/window/files/file_workflow.h"

#include <QAbstractSpinBox>
#include <QCoreApplication>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <memory>

#include "app/base/preferences.h"
#include "app/base/said.h"
#include "app/output/own_files.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/project_fwd.h"
#include "app/session/opening.h"
#include "app/views/canvas/canvas.h"
#include "app/window/export/dialogs.h"
#include "app/window/files/project_watch.h"
#include "core/base/error.h"
#include "core/base/printable.h"

namespace wend {

namespace {

// Names in the samples.
[[maybe_unused]] constexpr const char* kNames[] = {
    QT_TRANSLATE_NOOP("SampleNames", "back"),
    QT_TRANSLATE_NOOP("SampleNames", "body"),
    QT_TRANSLATE_NOOP("SampleNames", "chest"),
    QT_TRANSLATE_NOOP("SampleNames", "face"),
    QT_TRANSLATE_NOOP("SampleNames", "far front hoof"),
    QT_TRANSLATE_NOOP("SampleNames", "far hand"),
    QT_TRANSLATE_NOOP("SampleNames", "far heel"),
    QT_TRANSLATE_NOOP("SampleNames", "far hind hoof"),
    QT_TRANSLATE_NOOP("SampleNames", "far toe"),
    QT_TRANSLATE_NOOP("SampleNames", "front hoof"),
    QT_TRANSLATE_NOOP("SampleNames", "head"),
    QT_TRANSLATE_NOOP("SampleNames", "hind hoof"),
    QT_TRANSLATE_NOOP("SampleNames", "left elbow"),
    QT_TRANSLATE_NOOP("SampleNames", "left end"),
    QT_TRANSLATE_NOOP("SampleNames", "left eye"),
    QT_TRANSLATE_NOOP("SampleNames", "left foot"),
    QT_TRANSLATE_NOOP("SampleNames", "left hand"),
    QT_TRANSLATE_NOOP("SampleNames", "left lower arm"),
    QT_TRANSLATE_NOOP("SampleNames", "left middle arm"),
    QT_TRANSLATE_NOOP("SampleNames", "left upper arm"),
    QT_TRANSLATE_NOOP("SampleNames", "left wing"),
    QT_TRANSLATE_NOOP("SampleNames", "near hand"),
    QT_TRANSLATE_NOOP("SampleNames", "near heel"),
    QT_TRANSLATE_NOOP("SampleNames", "near toe"),
    QT_TRANSLATE_NOOP("SampleNames", "right end"),
    QT_TRANSLATE_NOOP("SampleNames", "right eye"),
    QT_TRANSLATE_NOOP("SampleNames", "right foot"),
    QT_TRANSLATE_NOOP("SampleNames", "right lower arm"),
    QT_TRANSLATE_NOOP("SampleNames", "right middle arm"),
    QT_TRANSLATE_NOOP("SampleNames", "right upper arm"),
    QT_TRANSLATE_NOOP("SampleNames", "right wing"),
    QT_TRANSLATE_NOOP("SampleNames", "rump"),
    QT_TRANSLATE_NOOP("SampleNames", "shadow"),
    QT_TRANSLATE_NOOP("SampleNames", "shoulder"),
    QT_TRANSLATE_NOOP("SampleNames", "stiff"),
    QT_TRANSLATE_NOOP("SampleNames", "tail"),
};

/// Returns a sample with translated names of pins and layers; the same project in English.
std::shared_ptr<const Project> withSpokenNames(const std::shared_ptr<const Project>& sample) {
    return withNames(sample, [](const std::string& name) {
        return QCoreApplication::translate("SampleNames", name.c_str()).toStdString();
    });
}

using Topic = InfoBanner::Topic;

constexpr int kMostRemembered = 10;

QString words(const std::exception& error) {
    return said(error);
}

constexpr int kBusyDelay = 150;  // milliseconds

}  // namespace

/// The result of reading a file in the background, or its error.
struct Reading {
    QString path;
    OpenedFile file;
    QByteArray stamp;  // of the file when it was read
    QString error;
    QStringList missing;   // missing files that the project names
    bool isBlank = false;  // the picture is transparent everywhere
};

namespace {

/// Returns a sentence about the file if the error is a predicate of it, such as "is empty"; else that it
/// cannot be opened, with the error.
QString openingError(const QString& path, const std::exception& error) {
    const QString text = QString::fromStdString(messageOf(error).text()),
                  subject = QFileInfo(path).absoluteFilePath() + QStringLiteral(": ");
    const QString reason = text.startsWith(subject) ? text.mid(subject.size()) : QString();
    const auto* input = dynamic_cast<const InputError*>(&error);
    static const QRegularExpression verb(QStringLiteral("^(is|does|has|holds|cannot) "));
    if (!verb.match(reason).hasMatch())
        return FileWorkflow::tr("This file cannot be opened. %1").arg(words(error));
    return FileWorkflow::tr("“%1” %2.", "a file, and what is wrong with it")
        .arg(QFileInfo(path).fileName(), input && !input->file().empty() ? said(InputError(input->message()))
                                                                         : said(reason.toStdString()));
}

Reading tryToRead(const QString& path, const QMap<QString, QString>& found,
                  const std::function<OpenedFile()>& reader) {
    Reading reading{path, {}, stampOf(path), {}, {}, false};
    if (path.endsWith(QStringLiteral(".wend"), Qt::CaseInsensitive))
        for (const QString& missing : missingFiles(path))
            if (!found.contains(missing)) reading.missing << missing;
    try {
        if (reading.missing.isEmpty()) reading.file = reader();
    } catch (const NothingToSee& error) {
        reading.isBlank = true;
        reading.error = words(error);
    } catch (const std::exception& error) {
        reading.error = openingError(path, error);
    }
    return reading;
}

}  // namespace

FileWorkflow::FileWorkflow(Document& document, InfoBanner& banner, QWidget& window)
    : QObject(&window),
      m_document(document),
      m_banner(banner),
      m_window(window),
      m_watch(new ProjectWatch(this)) {
    connect(&document, &Document::opened, this, [this] {
        m_watch->watch({}, {});
        emit lostChanged();
    });
    connect(&document, &Document::saved, this, &FileWorkflow::takeBackSaved);
    connect(m_watch, &ProjectWatch::changed, this, &FileWorkflow::watchDisk);
}

void FileWorkflow::askOpen() {
    const QString all = QStringLiteral("*.wend ") + pictureExtensions() + ' ' + meshExtensions();
    const QString filters =
        tr("All that Wend opens (%1)").arg(all) + QStringLiteral(";;") +
        tr("Pictures (%1)").arg(pictureExtensions()) + QStringLiteral(";;") +
        tr("Pictures with layers (%1)").arg(QStringLiteral("*.psd *.psb *.ora *.kra *.svg")) +
        QStringLiteral(";;") + tr("Projects (*.wend)") + QStringLiteral(";;") +
        tr("Meshes (%1)").arg(meshExtensions());
    openAll(QFileDialog::getOpenFileNames(&m_window, tr("Open"), preferences::folder.value(), filters));
}

void FileWorkflow::openAll(const QStringList& paths) {
    if (paths.size() == 1) open(paths.first());
    if (paths.size() < 2 || !mayLeave()) return;
    m_found.clear();
    read(paths.first(), [paths] { return openTogether(paths); });
}

void FileWorkflow::open(const QString& path) {
    if (!mayLeave()) return;
    m_found.clear();
    read(path, [path] { return openFile(path); });
}

void FileWorkflow::read(const QString& path, std::function<OpenedFile()> reader) {
    m_banner.clear(Topic::Opening);
    emit openingChanged(QFileInfo(path).fileName());
    const auto before = m_document.project();
    const auto work = [path, found = m_found, reader = std::move(reader)] {
        return tryToRead(path, found, reader);
    };
    m_opening.ask(work, [this, before](const Answer<Reading>& answer) {
        const Reading& reading = answer.value;
        emit openingChanged({});
        if (!reading.error.isEmpty() || !reading.missing.isEmpty()) return tellOf(reading);
        const bool changedMeanwhile = m_document.project() != before;
        if (!changedMeanwhile || mayLeave()) take(reading);
    });
}

/// Explains why a file could not be opened, and what the user can do.
void FileWorkflow::tellOf(const Reading& reading) {
    const QString path = reading.path;
    if (!reading.missing.isEmpty()) {
        const QString missing = reading.missing.first();
        return m_banner.tell(Topic::Opening, tr("%1 has moved.").arg(QFileInfo(missing).fileName()),
                             {{tr("Find It…"), [this, path, missing] { openFound(path, missing); }}});
    }
    const InfoBanner::Remedy another{tr("Open Another…"), [this] { askOpen(); }};
    if (!reading.isBlank) return m_banner.tell(Topic::Opening, reading.error, {another});
    const auto whole = [this, path] {
        if (mayLeave()) read(path, [path] { return openFile(path, true); });
    };
    m_banner.tell(Topic::Opening, tr("Nothing to see in this picture."),
                  {{tr("Use Whole Frame"), whole}, another});
}

void FileWorkflow::openFound(const QString& project, const QString& missing) {
    const QString name = QFileInfo(missing).fileName();
    const QString filter = QStringLiteral("%1 (%1);;%2 (*)").arg(name, tr("All files"));
    const QString found = QFileDialog::getOpenFileName(&m_window, tr("Find %1").arg(name),
                                                       QFileInfo(project).absolutePath(), filter);
    if (found.isEmpty() || !mayLeave()) return;
    m_found[missing] = found;
    read(project, [project, all = m_found] { return openMoved(project, all); });
}

void FileWorkflow::guardWork(const QString& folder) {
    m_copies = folder;
    m_recovery = new Recovery(m_document, folder);
    m_recovery->setParent(this);
    connect(m_recovery, &Recovery::failed, this, [this](const QString& why) {
        m_banner.tell(Topic::Copy,
                      tr("Your changes cannot be recovered if the program crashes: please save. %1").arg(why),
                      {{tr("Save"), [this] { save(); }}});
    });
    connect(m_recovery, &Recovery::written, this, [this] {
        m_banner.clear(Topic::Copy);
        discardRecovered();
    });
    emit lostChanged();
}

/// Removes the recovered copy once there is a new one or the work is saved.
void FileWorkflow::discardRecovered() {
    if (!m_recoveredFrom.isEmpty()) Recovery::discard(m_recoveredFrom);
    m_recoveredFrom.clear();
}

QList<LostWork> FileWorkflow::lost() const {
    QList<LostWork> all = m_copies.isEmpty() ? QList<LostWork>() : Recovery::lostIn(m_copies);
    all.removeIf([this](const LostWork& work) { return work.copy == m_recoveredFrom; });
    return all;
}

void FileWorkflow::tellLostWhenOpened() {
    const auto tell = [this] {
        const QList<LostWork> all = lost();
        if (all.isEmpty() || m_document.isEmpty()) return;
        const LostWork& work = all.first();
        m_banner.tell(
            Topic::Lost,
            tr("Wend was not closed properly: there are unsaved changes to “%1”.").arg(nameOf(work)),
            {{tr("Recover"), [this, work] { recover(work); }}});
    };
    connect(&m_document, &Document::opened, this, tell, Qt::SingleShotConnection);
}

void FileWorkflow::recover(const LostWork& work) {
    if (!mayLeave()) return;
    m_found.clear();
    read(work.path.isEmpty() ? work.source : work.path, [work] { return openLost(work); });
}

void FileWorkflow::discard(const LostWork& work) {
    const auto answer = QMessageBox::question(
        &m_window, tr("Wend"),
        tr("Discard the unsaved changes to “%1”? They cannot be brought back.").arg(nameOf(work)),
        QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Cancel);
    if (answer != QMessageBox::Discard) return;
    Recovery::discard(work.copy);
    emit lostChanged();
}

void FileWorkflow::take(const Reading& reading) {
    OpenedFile file = reading.file;
    if (file.path.isEmpty() && samplePaths().contains(file.source))
        file.project = withSpokenNames(file.project);
    m_recoveredFrom = file.recoveredFrom;
    m_document.open(file);
    if (!m_found.isEmpty()) m_document.undoStack()->resetClean();  // its file names the old places
    if (!file.path.isEmpty()) m_watch->watch(file.path, reading.stamp);
    if (m_recoveredFrom.isEmpty()) addRecent(file.source);
    if (!file.warnings.isEmpty()) m_banner.tell(Topic::Remark, file.warnings.join('\n'));
}

/// Withdraws messages about saving.
void FileWorkflow::takeBackSaved() {
    discardRecovered();
    m_watch->watch(m_document.path(), stampOf(m_document.path()));
    for (const Topic topic : {Topic::Saving, Topic::Disk, Topic::Copy}) m_banner.clear(topic);
}

void FileWorkflow::watchDisk(bool isOther) {
    if (!isOther) return m_banner.clear(Topic::Disk);
    const auto keep = [this] {
        m_watch->accept();
        m_document.undoStack()->resetClean();  // there is something to save
        m_banner.clear(Topic::Disk);
    };
    m_banner.tell(Topic::Disk,
                  tr("“%1” was changed by another program or window.").arg(m_document.displayName()),
                  {{tr("Reload"), [this] { reload(); }}, {tr("Keep Mine"), keep}, {tr("Save As…"), [this] {
                                                                                       saveAs();
                                                                                   }}});
}

void FileWorkflow::reload() {
    const QString path = m_document.path();
    if (m_document.isModified()) {
        QMessageBox box(QMessageBox::NoIcon, tr("Wend"), tr("Reload “%1”?").arg(m_document.displayName()),
                        QMessageBox::Cancel, &m_window);
        box.setInformativeText(tr("Your changes since it was saved will be lost."));
        QPushButton* yes = box.addButton(tr("Reload"), QMessageBox::DestructiveRole);
        box.exec();
        if (box.clickedButton() != yes) return;
    }
    m_found.clear();
    read(path, [path] { return openFile(path); });
}

/// Asks, because another program has changed the project's file.
bool FileWorkflow::mayOverwrite() {
    QMessageBox box(QMessageBox::NoIcon, tr("Wend"),
                    tr("“%1” was changed by another program or window.").arg(m_document.displayName()),
                    QMessageBox::Cancel, &m_window);
    box.setInformativeText(tr("Saving replaces those changes; reloading discards yours."));
    QPushButton* keep = box.addButton(tr("Keep Mine"), QMessageBox::DestructiveRole);
    QPushButton* other = box.addButton(tr("Reload"), QMessageBox::DestructiveRole);
    QPushButton* as = box.addButton(tr("Save As…"), QMessageBox::AcceptRole);
    box.setDefaultButton(as);
    box.exec();
    if (box.clickedButton() == other) reload();
    if (box.clickedButton() == as) saveAs();
    return box.clickedButton() == keep;
}

/// Returns false, with a notice, if the project would overwrite the picture or mesh that it bends.
bool FileWorkflow::mayTakePlace(const QString& path) {
    const auto own = ownFileAt(m_document, path);
    if (!own || *own == OwnFile::Project) return true;
    tellNotSaved(tr("The project was not saved: it needs the file “%1” itself. Choose another name.")
                     .arg(QFileInfo(path).fileName()));
    return false;
}

void FileWorkflow::tellNotSaved(const QString& text) {
    m_banner.tell(Topic::Saving, text, {{tr("Save As…"), [this] { saveAs(); }}});
}

bool FileWorkflow::save() {
    takeTyped();
    if (m_document.path().isEmpty()) return saveAs();
    const bool isSaved = !m_document.isModified() && !m_document.hasOtherView();
    return isSaved || saveTo(m_document.path());
}

/// Proposes a path beside the project or picture, but never among the samples.
QString FileWorkflow::proposedPath() const {
    if (!m_document.path().isEmpty()) return m_document.path();
    return QDir(proposedFolder(m_document))
        .filePath(QFileInfo(m_document.source()).completeBaseName() + QStringLiteral(".wend"));
}

bool FileWorkflow::saveAs() {
    takeTyped();
    const QString path =
        askFileToWrite(&m_window, tr("Save Project"), proposedPath(), tr("Projects (*.wend)"));
    return !path.isEmpty() && mayTakePlace(path) && write(path);
}

/// Returns false if something is still unsaved.
bool FileWorkflow::saveTo(const QString& path) {
    if (m_watch->isChanged() && !mayOverwrite()) return !m_document.isModified();
    return write(path);
}

bool FileWorkflow::write(const QString& path) {
    try {
        m_document.save(path);
    } catch (const InputError& error) {
        tellNotSaved(tr("The project was not saved. %1").arg(words(error)));
        return false;
    }
    addRecent(path);
    return true;
}

void FileWorkflow::close() {
    if (!mayLeave()) return;
    m_opening.drop();
    emit openingChanged({});
    m_document.close();
}

/// Applies text that is still being typed: a number, or a name in a list, which is applied when its editor
/// closes.
void FileWorkflow::takeTyped() {
    QWidget* const field = m_window.focusWidget();
    if (auto* number = qobject_cast<QAbstractSpinBox*>(field)) number->interpretText();
    if (!qobject_cast<QLineEdit*>(field)) return;
    field->clearFocus();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::MetaCall);
}

bool FileWorkflow::mayLeave() {
    takeTyped();
    if (m_document.isEmpty() || !m_document.isModified() || (m_isPractice && m_isPractice())) return true;
    const bool isNew = m_document.path().isEmpty();
    QMessageBox box(QMessageBox::NoIcon, tr("Wend"),
                    (isNew ? tr("Save what you made of “%1”?") : tr("Save the changes to “%1”?"))
                        .arg(m_document.displayName()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &m_window);
    box.setTextFormat(Qt::PlainText);
    box.setInformativeText(isNew ? tr("It becomes a project of its own; the file stays as it is. If you do "
                                      "not save, what you made will be lost.")
                                 : tr("If you do not save, they will be lost."));
    box.setDefaultButton(QMessageBox::Save);
    const int answer = box.exec();
    if (answer == QMessageBox::Save) return save();
    if (answer != QMessageBox::Discard) return false;
    if (!m_recoveredFrom.isEmpty()) Recovery::discard(m_recoveredFrom);
    return true;
}

QStringList FileWorkflow::recent() const {
    QStringList existing;
    for (const QString& path : preferences::recentFiles.value())
        if (QFileInfo::exists(path)) existing << path;
    return existing;
}

/// Ignores the samples and their pictures.
void FileWorkflow::addRecent(const QString& path) {
    const QString folder = QFileInfo(path).absolutePath();
    const QStringList samples = samplePaths();
    if (!samples.isEmpty() && folder == QFileInfo(samples.first()).absolutePath()) return;
    preferences::folder.set(folder);
    QStringList paths = recent();
    paths.removeAll(path);
    paths.prepend(path);
    preferences::recentFiles.set(paths.mid(0, kMostRemembered));
    fillRecent();
    emit recentChanged();
}

void FileWorkflow::fillMenus(QMenu& recent, QMenu& samples) {
    m_recentMenu = &recent;
    fillRecent();
    for (const QString& path : samplePaths())
        samples.addAction(QFileInfo(path).completeBaseName(), this, [this, path] { open(path); });
    samples.setEnabled(!samples.isEmpty());
}

void FileWorkflow::fillRecent() {
    if (!m_recentMenu) return;
    m_recentMenu->clear();
    for (const QString& path : recent())
        m_recentMenu->addAction(QFileInfo(path).fileName(), this, [this, path] { open(path); })
            ->setStatusTip(QDir::toNativeSeparators(path));
    m_recentMenu->setEnabled(!m_recentMenu->isEmpty());
}

/// Queues the refresh, because a file is opened in the same turn of the event loop as it is read; so the note
/// stays visible in between.
OpeningNote::OpeningNote(FileWorkflow& files, ShapeCanvas& canvas, QWidget& over)
    : QLabel(&over), m_canvas(canvas) {
    setObjectName(QStringLiteral("busyNote"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAlignment(Qt::AlignCenter);
    setMargin(14);
    setTextFormat(Qt::PlainText);
    hide();
    over.installEventFilter(this);
    m_delay.setSingleShot(true);
    m_delay.setInterval(kBusyDelay);
    m_delay.callOnTimeout(this, [this] {
        place();
        show();
        raise();
    });
    connect(&files, &FileWorkflow::openingChanged, this, [this](const QString& name) {
        m_reads = !name.isEmpty();
        if (m_reads) m_name = name;
        QMetaObject::invokeMethod(this, &OpeningNote::refresh, Qt::QueuedConnection);
    });
    connect(&m_canvas.shape(), &DrawnShape::prepared, this, &OpeningNote::refresh);
}

void OpeningNote::showText(const QString& text) {
    setText(text);
    setAccessibleName(text);
    if (text.isEmpty()) {
        m_delay.stop();
        hide();
    } else if (isHidden() && !m_delay.isActive()) {
        m_delay.start();
    }
    place();
    raise();  // over a page that came
}

void OpeningNote::place() {
    resize(sizeHint().boundedTo(parentWidget()->size()));
    move((parentWidget()->width() - width()) / 2, (parentWidget()->height() - height()) / 2);
}

bool OpeningNote::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) place();
    return QLabel::eventFilter(watched, event);
}

void OpeningNote::refresh() {
    showText(m_reads || m_canvas.shape().isPreparing() ? tr("Opening %1 …").arg(m_name) : QString());
}

}  // namespace wend
