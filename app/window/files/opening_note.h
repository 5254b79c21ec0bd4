#pragma once

#include <QLabel>
#include <QString>
#include <QTimer>

namespace wend {

class FileWorkflow;
class ShapeCanvas;

/// A line in the middle of a widget that names work that takes more than a moment.
class BusyNote : public QLabel {
    Q_OBJECT

  public:
    explicit BusyNote(QWidget& over);
    /// An empty text takes it away.
    void showText(const QString& text);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void place();

    QTimer m_delay;
};

/// Names the file that is being opened until its picture is visible; later work is shown by WorkNote.
class OpeningNote : public BusyNote {
    Q_OBJECT

  public:
    OpeningNote(FileWorkflow& files, ShapeCanvas& canvas, QWidget& over);

  private:
    void refresh();

    ShapeCanvas& m_canvas;
    bool m_reads = false;
    QString m_name;
};

}  // namespace wend
