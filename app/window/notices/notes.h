#pragma once

#include <QDeadlineTimer>
#include <QFrame>
#include <QObject>
#include <QTimer>

#include "app/engine/shape/shape_builder.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QStatusBar;

namespace wend {

class Document;
class ShapeMotion;

/// Shows long work over the view with its progress, and cancels it by a button or Esc.
class WorkNote : public QFrame {
    Q_OBJECT

  public:
    WorkNote(ShapeMotion& motion, QWidget& over);
    QString text() const;
    QPushButton* cancelButton() const { return m_cancel; }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void takeState();
    void follow();
    void showText();
    void place();
    ShapeInputs inputs() const;
    bool makesMesh() const;
    const PicturePart* filledPart() const;
    QString words(double part) const;
    bool isCancelKey(QObject* watched, QEvent* event) const;

    ShapeMotion& m_motion;
    const Document& m_document;
    QLabel* m_text;
    QProgressBar* m_bar;
    QPushButton* m_cancel;
    QTimer m_delay;
    double m_part = 0;     // of the motion that is there
    ShapeInputs m_meshed;  // the newest whose mesh is there; no project: none is
};

/// The status bar: the tool's hint, messages, the place under the pointer and how much the shape grew.
class StatusFields : public QObject {
    Q_OBJECT

  public:
    StatusFields(QStatusBar& bar, Document& document, const ShapeMotion& motion);

    void setVisible(bool visible);
    /// Shows the numbers anew.
    void refresh();
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
    void showPointer();
    QString fitted(const QString& text) const;

    QString m_pointed;  // the newest place of the pointer
    QStatusBar& m_bar;
    const ShapeMotion& m_motion;
    HintLabel* m_hint;
    QString m_message, m_tip;  // the last ones
    QDeadlineTimer m_messageUntil;
    QLabel *m_pointer, *m_growth;
};

}  // namespace wend
