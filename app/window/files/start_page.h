#pragma once

#include <QAbstractButton>
#include <QImage>
#include <QWidget>

#include "app/project/edits/recovery.h"

class QAction;
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
    StartPage(FileWorkflow& files, QAction& tutorial, QWidget* parent = nullptr);
    /// Highlights the drop area while a file is dragged over the window.
    void setDropHighlighted(bool highlighted);

  private:
    QWidget* makeHeader(QAction& tutorial);
    QWidget* makeDropArea();
    QWidget* makeSamples();
    QWidget* makeCard(const QString& path, bool sample, QWidget* shelf);
    QWidget* makeLost(const LostWork& work, QWidget* shelf);
    void showRecent();
    void showLost();

    FileWorkflow& m_files;
    QWidget* m_drop = nullptr;
    QWidget *m_recentBox = nullptr, *m_lostBox = nullptr;
    QVBoxLayout *m_recent = nullptr, *m_lost = nullptr;
};

}  // namespace wend
