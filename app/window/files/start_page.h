#pragma once

#include <QWidget>

#include "app/project/edits/recovery.h"

class QVBoxLayout;

namespace wend {

class FileWorkflow;

/// The page without a file: a drop area, recent files and samples.
class StartPage : public QWidget {
    Q_OBJECT

  public:
    explicit StartPage(QWidget* parent = nullptr);
    /// Shows the files of `files` and forwards clicks to it.
    void serve(FileWorkflow& files);
    void setRecent(const QStringList& paths);
    /// Shows recovered work first.
    void setLost(const QList<LostWork>& lost);
    /// Highlights the drop area while a file is dragged over the window.
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
