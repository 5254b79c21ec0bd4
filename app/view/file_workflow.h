#pragma once

#include <QObject>
#include <functional>

#include "app/document/recovery.h"

class QMenu;
class QWidget;

namespace wend {

/// Opening, saving and closing with all their questions: files are read in the background, changes are never
/// lost unasked.
class FileWorkflow : public QObject {
    Q_OBJECT

  public:
    FileWorkflow(Document& document, QWidget& window);

    QStringList recent() const;
    void fillRecent(QMenu& menu);
    void fillSamples(QMenu& menu);

    /// From now on unsaved changes are copied to this folder. Offers what crashed programs have left there;
    /// true if the user takes it, and then `instead`, a file that was to be opened, is not.
    bool guardWork(const QString& folder, const QString& instead = {});

  public slots:
    void askOpen();
    void open(const QString& path);
    bool save();
    bool saveAs();
    void close();
    /// False if the user wants to go on after all.
    bool mayLeave();

  signals:
    void failed(QString text);
    void openingChanged(QString fileName);
    void recentChanged();

  private:
    QString proposedPath() const;
    bool saveTo(const QString& path);
    void addRecent(const QString& path);
    void waitForPlace() const;
    bool offer(const LostWork& work, const QString& instead);
    void read(const QString& name, std::function<OpenedFile()> reader);
    void take(OpenedFile file);

    Document& m_document;
    QWidget& m_window;
    Recovery* m_recovery = nullptr;
    QString m_recoveredFrom;  // the copy that the document came from, until there is a new one
    int m_ticket = 0;         // of the newest opening; older ones come too late
};

}  // namespace wend
