#pragma once

#include <QObject>

class QWidget;

namespace wend {

/// While a key is held anywhere in a window, whichever of its widgets has the focus, something is so. Where
/// text is typed the key is a letter.
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
