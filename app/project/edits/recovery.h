#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QTimer>
#include <memory>

#include "app/base/in_background.h"
#include "app/project/edits/document.h"

namespace wend {

/// Unsaved work of a program that has ended without asking.
struct LostWork {
    QString copy;    // a project file
    QString path;    // where the project is saved; empty if it never was
    QString source;  // the file that had been opened
    QDateTime time;  // of the last change in the copy
};
/// Returns the name of the file that was being edited.
QString nameOf(const LostWork& work);

/// Keeps a copy of a changed document in a folder of its own until it is saved or closed, so that a crash
/// loses no more than the last seconds. Copies of running programs are locked.
class Recovery : public QObject {
    Q_OBJECT

  public:
    Recovery(Document& document, const QString& folder, int delayMs = 2000);
    /// Removes the copy: the program ended normally.
    ~Recovery() override;

    static QString standardFolder();
    /// Returns copies whose program no longer runs, newest first.
    static QList<LostWork> lostIn(const QString& folder);
    static void discard(const QString& copy);

    /// Returns the path of this document's copy; empty if there is none.
    QString copy() const;

  signals:
    /// Emitted when the copy is up to date.
    void written();
    /// Emitted once per document if the copy cannot be written.
    void failed(QString why);

  private:
    void follow();
    void makeFolder();
    void write();
    void finish(const QString& error);
    void remove();

    Document& m_document;
    QString m_folder, m_name;
    std::unique_ptr<QLockFile> m_lock;
    QTimer m_timer;
    BackgroundWork m_writing;
    int m_complained = -1;  // generation of the document whose failure was reported
};

}  // namespace wend
