#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

namespace wend {

/// Returns a hash of a file's contents, since times may be misleading. Empty if it cannot be read.
QByteArray stampOf(const QString& path);

/// Watches the project's file: another program, or another window, may write it too.
class ProjectWatch : public QObject {
    Q_OBJECT

  public:
    explicit ProjectWatch(QObject* parent = nullptr);

    /// Watches a file with the stamp that it had when it was read or written; an empty path stops watching.
    void watch(const QString& path, const QByteArray& stamp);
    /// Returns whether the contents differ. A deleted file does not count: saving restores it.
    bool isChanged() const;
    /// Accepts the current contents.
    void accept() { watch(m_path, stampOf(m_path)); }

  signals:
    /// Emitted when the contents differ from the known ones, or match them again.
    void changed(bool isOther);

  private:
    void look();

    QFileSystemWatcher m_watcher;
    QTimer m_settle;  // a file is often written in several steps
    QString m_path;
    QByteArray m_stamp;
    bool m_reported = false;
};

}  // namespace wend
