#pragma once

#include <QWidget>

class QVBoxLayout;

namespace wend {

/// What is seen before a file is open: where to drop one, what was open last, and samples to try.
class StartPage : public QWidget {
    Q_OBJECT

  public:
    explicit StartPage(QWidget* parent = nullptr);
    void setRecent(const QStringList& paths);
    /// A file hangs over the window.
    void setDropHighlighted(bool highlighted);

  signals:
    void openRequested();
    void fileChosen(QString path);
    void tutorialRequested();

  private:
    QWidget* makeHeader();
    QWidget* makeDropArea();
    QWidget* makeSamples();
    QWidget* makeCard(const QString& path, bool sample, QWidget* shelf);

    QWidget* m_drop = nullptr;
    QWidget* m_recentBox = nullptr;
    QVBoxLayout* m_recent = nullptr;
};

}  // namespace wend
