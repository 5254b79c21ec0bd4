#include "app/window/files/project_watch.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

#include "app/base/connect_each.h"

namespace wend {

QByteArray stampOf(const QString& path) {
    QFile file(path);
    QCryptographicHash hash(QCryptographicHash::Sha1);
    if (path.isEmpty() || !QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly)) return {};
    return hash.addData(&file) ? hash.result() : QByteArray();
}

ProjectWatch::ProjectWatch(QObject* parent) : QObject(parent) {
    m_settle.setSingleShot(true);
    m_settle.setInterval(100);
    m_settle.callOnTimeout(this, &ProjectWatch::look);
    connectEach(
        this, [this] { m_settle.start(); }, &m_watcher, &QFileSystemWatcher::fileChanged, &m_watcher,
        &QFileSystemWatcher::directoryChanged);
}

/// Watches the folder, too, because most programs replace the old file by a new one.
void ProjectWatch::watch(const QString& path, const QByteArray& stamp) {
    if (const QStringList all = m_watcher.files() + m_watcher.directories(); !all.isEmpty())
        m_watcher.removePaths(all);
    m_path = path;
    m_stamp = stamp;
    m_reported = false;
    if (!path.isEmpty()) m_watcher.addPaths({path, QFileInfo(path).absolutePath()});
}

bool ProjectWatch::isChanged() const {
    const QByteArray now = stampOf(m_path);
    return !now.isEmpty() && now != m_stamp;
}

void ProjectWatch::look() {
    if (!m_watcher.files().contains(m_path) && QFileInfo::exists(m_path)) m_watcher.addPath(m_path);
    if (const bool isOther = isChanged(); isOther != m_reported) {
        m_reported = isOther;
        emit changed(isOther);
    }
}

}  // namespace wend
