#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

namespace wend {

/// What a file holds, to tell whether it is still the same: not its time, which may stay or change for
/// nothing. Empty if it cannot be read.
QByteArray stampOf(const QString& path);

/// Watches the project's file: another program, or another window, may write it too.
class ProjectWatch : public QObject {
    Q_OBJECT

  public:
    explicit ProjectWatch(QObject* parent = nullptr);

    /// From now on that file, which held this when it was read or written; an empty path: none.
    void watch(const QString& path, const QByteArray& stamp);
    /// True if the file holds something else now. One that is gone does not: saving brings it back.
    bool isChanged() const;
    /// What it holds now is known, too.
    void accept() { watch(m_path, stampOf(m_path)); }

  signals:
    /// It holds something else, or again what was known.
    void changed(bool isOther);

  private:
    void look();

    QFileSystemWatcher m_watcher;
    QTimer m_settle;  // a file is often written in several steps
    QString m_path;
    QByteArray m_stamp;
    bool m_told = false;
};

}  // namespace wend
