#pragma once

#include <QObject>
#include <QWidget>

namespace wend {

/// The space bar tapped in a window: pressed and let go with nothing in between, by a hand that is not at the
/// mouse. Held until it repeats it is no tap, nor where the focus is on what has a use of its own for it: a
/// text, a button, a list.
class SpaceTap : public QObject {
    Q_OBJECT

  public:
    explicit SpaceTap(QWidget& window);

  signals:
    void tapped();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool isOurs(const QObject* watched) const;
    void press(const QKeyEvent& key);
    void release(const QKeyEvent& key);

    QWidget& m_window;
    Qt::MouseButtons m_buttons;  // of the mouse, that are down
    bool m_down = false;
};

}  // namespace wend
