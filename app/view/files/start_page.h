#pragma once

#include <QWidget>

#include "app/document/edits/recovery.h"

class QVBoxLayout;

namespace wend {

class FileWorkflow;

/// What is seen before a file is open: where to drop one, what was open last, and samples to try.
class StartPage : public QWidget {
    Q_OBJECT

  public:
    explicit StartPage(QWidget* parent = nullptr);
    /// From now on its cards are those files, and what is pressed is done by them.
    void serve(FileWorkflow& files);
    void setRecent(const QStringList& paths);
    /// Work of programs that have ended without asking comes first.
    void setLost(const QList<LostWork>& lost);
    /// A file hangs over the window.
    void setDropHighlighted(bool highlighted);

  signals:
    void openRequested();
    void fileChosen(QString path);
    void recoverRequested(wend::LostWork work);
    void discardRequested(wend::LostWork work);
    void tutorialRequested();

  private:
    QWidget* makeHeader();
    QWidget* makeDropArea();
    QWidget* makeSamples();
    QWidget* makeCard(const QString& path, bool sample, QWidget* shelf);
    QWidget* makeLost(const LostWork& work, QWidget* shelf);

    QWidget* m_drop = nullptr;
    QWidget *m_recentBox = nullptr, *m_lostBox = nullptr;
    QVBoxLayout *m_recent = nullptr, *m_lost = nullptr;
};

}  // namespace wend
