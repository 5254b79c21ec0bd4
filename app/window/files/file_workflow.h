#pragma once

#include <QLabel>
#include <QMap>
#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>

#include "app/base/latest.h"
#include "app/project/edits/recovery.h"
#include "app/window/notices/info_banner.h"

class QMenu;
class QWidget;

namespace wend {

class ProjectWatch;
struct Reading;
class ShapeCanvas;

/// Opening, saving and closing with all their questions: files are read in the background, changes are never
/// lost unasked.
class FileWorkflow : public QObject {
    Q_OBJECT

  public:
    /// `banner`: shows what went wrong, and what can be done.
    FileWorkflow(Document& document, InfoBanner& banner, QWidget& window);

    QStringList recent() const;
    /// Lists recent files and samples in two menus.
    void fillMenus(QMenu& recent, QMenu& samples);

    /// Copies unsaved changes to this folder from now on. Copies of crashed programs are returned by lost().
    void guardWork(const QString& folder);
    QList<LostWork> lost() const;
    /// Sets a test for practice work, which is closed without a question.
    void setPractice(std::function<bool()> isPractice) { m_isPractice = std::move(isPractice); }
    /// Offers recovery beside the next opened file, when the start page is not shown.
    void tellLostWhenOpened();

  public slots:
    void askOpen();
    void recover(const wend::LostWork& work);
    /// Deletes the copy after the user confirmed twice.
    void discard(const wend::LostWork& work);
    void open(const QString& path);
    /// Opens several pictures as the parts of one.
    void openAll(const QStringList& paths);
    bool save();
    bool saveAs();
    void close();
    /// Returns false if the user cancelled.
    bool mayLeave();

  signals:
    void openingChanged(QString fileName);
    void recentChanged();
    void lostChanged();

  private:
    void takeTyped();
    QString proposedPath() const;
    bool saveTo(const QString& path);
    bool write(const QString& path);
    bool mayOverwrite();
    bool mayTakePlace(const QString& path);
    void reload();
    void watchDisk(bool isOther);
    void tellNotSaved(const QString& text);
    void takeBackSaved();
    void discardRecovered();
    void tellOf(const Reading& reading);
    void openFound(const QString& project, const QString& missing);
    void addRecent(const QString& path);
    void fillRecent();
    void read(const QString& path, std::function<OpenedFile()> reader);
    void take(const Reading& reading);

    Document& m_document;
    InfoBanner& m_banner;
    QWidget& m_window;
    ProjectWatch* m_watch;
    QMenu* m_recentMenu = nullptr;
    QMap<QString, QString> m_found;  // files that a project missed, and where they are
    Recovery* m_recovery = nullptr;
    QString m_copies;         // the folder of unsaved changes
    QString m_recoveredFrom;  // the copy that the document came from, until there is a new one
    std::function<bool()> m_isPractice;
    Latest m_opening{this};
};

/// Names the file that is being opened, in the middle of a widget, if that takes more than a moment, until
/// its picture is visible; later work is shown by WorkNote.
class OpeningNote : public QLabel {
    Q_OBJECT

  public:
    OpeningNote(FileWorkflow& files, ShapeCanvas& canvas, QWidget& over);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void refresh();
    /// Shows the text, or hides the note if it is empty.
    void showText(const QString& text);
    void place();

    ShapeCanvas& m_canvas;
    bool m_reads = false;
    QString m_name;
    QTimer m_delay;
};

}  // namespace wend
