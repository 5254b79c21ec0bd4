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

    bool isOpening() const { return m_opening > 0; }
    QStringList recent() const;
    void fillRecent(QMenu& menu);
    void fillSamples(QMenu& menu);

    /// From now on unsaved changes are copied to this folder. Offers what crashed programs have left there.
    void guardWork(const QString& folder);

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
    void opened();
    void recentChanged();

  private:
    bool saveTo(const QString& path);
    void addRecent(const QString& path);
    void offer(const LostWork& work);
    void read(const QString& name, std::function<OpenedFile()> reader);
    void take(OpenedFile file);

    Document& m_document;
    QWidget& m_window;
    Recovery* m_recovery = nullptr;
    int m_opening = 0;
    int m_ticket = 0;  // of the newest opening; older ones come too late
};

}  // namespace wend
