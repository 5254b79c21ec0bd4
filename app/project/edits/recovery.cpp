#include "app/project/edits/recovery.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>
#include <QUuid>

#include "app/base/said.h"
#include "app/project/file/project_writer.h"
#include "app/project/file/text_file.h"
#include "core/base/error.h"

namespace wend {

namespace {

// Returns the files beside a copy NAME.wend: NAME.ini, which names its document, and NAME.lock, which exists
// while the program runs.
QString besides(const QString& copy, const char* extension) {
    const QFileInfo info(copy);
    return info.dir().filePath(info.completeBaseName() + QLatin1String(extension));
}

constexpr auto kPrivate = QFile::ReadOwner | QFile::WriteOwner;

bool isRunning(const QString& copy) {
    QLockFile lock(besides(copy, ".lock"));
    lock.setStaleLockTime(0);  // a lock is stale only if its process is dead, however old it is
    return !lock.tryLock();
}

QString tryToWrite(const QString& copy, const Project& project) {
    try {
        writeTextFile(copy.toStdString(), toJson(project), Access::Private);
        return {};
    } catch (const InputError& error) {
        return said(error);
    }
}

}  // namespace

QString nameOf(const LostWork& work) {
    return QFileInfo(work.path.isEmpty() ? work.source : work.path).fileName();
}

Recovery::Recovery(Document& document, const QString& folder, int delayMs)
    : m_document(document), m_folder(folder), m_name(QUuid::createUuid().toString(QUuid::WithoutBraces)) {
    m_timer.setSingleShot(true);
    m_timer.setInterval(delayMs);
    connect(&m_timer, &QTimer::timeout, this, &Recovery::write);
    connect(&document, &Document::projectChanged, this, &Recovery::follow);
    connect(&document, &Document::titleChanged, this, &Recovery::follow);
}

Recovery::~Recovery() {
    m_writing.wait();
    remove();
}

QString Recovery::standardFolder() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation))
        .filePath(QStringLiteral("recovery"));
}

QString Recovery::copy() const {
    return QDir(m_folder).filePath(m_name + QStringLiteral(".wend"));
}

void Recovery::follow() {
    if (m_document.isEmpty() || !m_document.isModified()) {
        m_timer.stop();
        m_writing.wait();
        remove();
    } else if (!m_timer.isActive()) {
        m_timer.start();
    }
}

/// Unsaved work is private, whatever the permissions of the file that it will be saved to.
void Recovery::makeFolder() {
    QDir().mkpath(m_folder);
    QFile::setPermissions(m_folder, kPrivate | QFile::ExeOwner);
}

void Recovery::write() {
    if (m_writing.isRunning()) return m_timer.start();
    makeFolder();
    if (!m_lock) {
        m_lock = std::make_unique<QLockFile>(besides(copy(), ".lock"));
        m_lock->setStaleLockTime(0);
        m_lock->tryLock();
        QFile::setPermissions(m_lock->fileName(), kPrivate);
    }
    QSettings origin(besides(copy(), ".ini"), QSettings::IniFormat);
    origin.setValue("path", m_document.path());
    origin.setValue("source", m_document.source());
    origin.sync();
    QFile::setPermissions(origin.fileName(), kPrivate);
    const auto work = [copy = copy(), project = m_document.project()] { return tryToWrite(copy, *project); };
    m_writing = inBackground(this, work, [this](const QString& error) { finish(error); });
}

void Recovery::finish(const QString& error) {
    if (error.isEmpty()) return emit written();
    if (m_complained == m_document.generation()) return;
    m_complained = m_document.generation();
    emit failed(error);
}

void Recovery::remove() {
    QFile::remove(copy());
    QFile::remove(besides(copy(), ".ini"));
    m_lock.reset();
}

QList<LostWork> Recovery::lostIn(const QString& folder) {
    QList<LostWork> lost;
    for (const QFileInfo& info :
         QDir(folder).entryInfoList({QStringLiteral("*.wend")}, QDir::Files, QDir::Time)) {
        const QString copy = info.absoluteFilePath();
        if (isRunning(copy)) continue;
        const QSettings origin(besides(copy, ".ini"), QSettings::IniFormat);
        lost << LostWork{copy, origin.value("path").toString(), origin.value("source").toString(),
                         info.lastModified()};
    }
    return lost;
}

void Recovery::discard(const QString& copy) {
    QFile::remove(copy);
    QFile::remove(besides(copy, ".ini"));
    QFile::remove(besides(copy, ".lock"));
}

}  // namespace wend
