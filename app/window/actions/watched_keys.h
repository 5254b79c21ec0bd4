#pragma once

#include <QAction>
#include <QWidget>

namespace wend {

/// A state that is active while a key is held anywhere in a window, whatever has the focus; not in text
/// fields.
class HeldKey : public QObject {
    Q_OBJECT

  public:
    HeldKey(Qt::Key key, QWidget& window);
    bool isHeld() const { return m_held; }

  signals:
    void heldChanged(bool held);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool begins(QObject* watched, const QEvent& event) const;
    void setHeld(bool held);

    Qt::Key m_key;
    QWidget& m_window;
    bool m_held = false;
};

/// A tap of the space bar in a window: pressed and released without anything in between. Holding it until it
/// repeats is no tap, nor is it where the focused widget uses the key: a text, a button, a list.
class SpaceTap : public QObject {
    Q_OBJECT

  public:
    /// `action`: is triggered.
    SpaceTap(QWidget& window, QAction& action);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool isOurs(const QObject* watched) const;
    void press(const QKeyEvent& key);
    void release(const QKeyEvent& key);

    QWidget& m_window;
    QAction& m_action;
    Qt::MouseButtons m_buttons;  // of the mouse, that are down
    bool m_down = false;
};

}  // namespace wend
