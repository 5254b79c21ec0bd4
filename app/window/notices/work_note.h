#pragma once

#include <QFrame>
#include <QTimer>

#include "app/engine/shape/shape_builder.h"
#include "app/session/shape_session.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace wend {

/// Shows long work over the view with its progress, and cancels it by a button or Esc.
class WorkNote : public QFrame {
    Q_OBJECT

  public:
    WorkNote(ShapeSession& session, QWidget& over);
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

    ShapeSession& m_session;
    QLabel* m_text;
    QProgressBar* m_bar;
    QPushButton* m_cancel;
    QTimer m_delay;
    double m_part = 0;     // of the motion that is there
    ShapeInputs m_meshed;  // the newest whose mesh is there; no project: none is
};

}  // namespace wend
