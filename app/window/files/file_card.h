#pragma once

#include <QAbstractButton>
#include <QImage>

namespace wend {

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

}  // namespace wend
