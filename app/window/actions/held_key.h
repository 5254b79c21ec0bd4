#pragma once

#include <QObject>

class QWidget;

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

}  // namespace wend
