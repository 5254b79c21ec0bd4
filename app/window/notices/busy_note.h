#pragma once

#include <QLabel>
#include <QTimer>

namespace wend {

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

}  // namespace wend
