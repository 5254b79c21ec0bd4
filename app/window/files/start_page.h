#pragma once

#include <QAbstractButton>
#include <QImage>
#include <QWidget>

#include "app/project/edits/recovery.h"

class QVBoxLayout;

namespace wend {

class FileWorkflow;

/// A file as a picture with its name and a line below: a sample with its lesson, a recent file with its
/// folder, or unsaved changes with their time. A click opens it. The picture is read in the background once
/// the card is visible.
class FileCard : public QAbstractButton {
    Q_OBJECT

  public:
    enum class Kind { Sample, Recent, Lost };
    /// `line`: text below the name; if empty, that of the kind.
    FileCard(const QString& path, Kind kind, QWidget* parent, const QString& line = {});
    /// Returns the width for title and line in pixels.
    int room() const { return width() - 2 * 8; }
    QSize sizeHint() const override { return {132, 172}; }
    const QString& path() const { return m_path; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void load();
    void paintPicture(QPainter& painter) const;
    void paintBadge(QPainter& painter) const;

    QString m_path, m_line;
    QImage m_picture;
    bool m_isAsked = false, m_isSolid = false;
};

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
