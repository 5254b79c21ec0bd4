#pragma once

#include <QDeadlineTimer>
#include <QObject>

class QLabel;
class QStatusBar;

namespace wend {

class ShapeSession;

/// The status bar: the tool's hint, messages, the place under the pointer and how much the shape grew.
class StatusFields : public QObject {
    Q_OBJECT

  public:
    StatusFields(QStatusBar& bar, ShapeSession& session);

    void setVisible(bool visible);
    /// Shows the status tip of a widget under the pointer, shortened to whole sentences if it does not fit.
    /// The last message returns when the pointer leaves, and when the tip is that of the button that was
    /// pressed.
    void showTip(const QString& tip);
    /// Drops the last message, which belongs to another document.
    void forgetMessage() { m_messageUntil.setRemainingTime(0); }

  public slots:
    void setHint(const QString& hint);
    /// Shows a message for ten seconds, even if tips appear and disappear meanwhile; an empty text removes
    /// it.
    void showMessage(const QString& text);
    /// Shows the view's description of the place under the pointer.
    void setPointer(const QString& text);

  private:
    class HintLabel;
    QLabel* add(const QString& name, const QString& help, const QString& widest);
    void showFrame();
    void showPointer();
    QString fitted(const QString& text) const;

    QString m_pointed;  // the newest place of the pointer
    QStatusBar& m_bar;
    ShapeSession& m_session;
    HintLabel* m_hint;
    QString m_message, m_tip;  // the last ones
    QDeadlineTimer m_messageUntil;
    QLabel *m_pointer, *m_growth;
};

}  // namespace wend
