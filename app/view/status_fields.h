#pragma once

#include <QDeadlineTimer>
#include <QObject>

#include "app/panels/look/colour_map.h"
#include "app/view/canvas/seen_delay.h"

class QLabel;
class QStatusBar;

namespace wend {

/// The status bar: what the tool does, where the pointer is, and how well the shape keeps what it should.
/// Where it is short the numbers give way to the words.
class StatusFields : public QObject {
    Q_OBJECT

  public:
    StatusFields(QStatusBar& bar, ShapeSession& session);

    void setVisible(bool visible);
    /// The hint of a button or field under the pointer, as far as there is room for it: whole sentences, or
    /// the beginning of one. When the pointer leaves, what was told comes back; so it
    /// does when the hint is the one that stood there before, of the button that was pressed.
    void showTip(const QString& tip);
    /// What was told is of another document.
    void forgetTold() { m_toldUntil.setRemainingTime(0); }
    /// Of the views that it is to look at.
    SeenDelay& delay() { return m_delay; }

  public slots:
    void setHint(const QString& hint);
    /// A line that stays for a while, though hints come and go.
    void tell(const QString& text);
    /// What is under the pointer, in words of the view.
    void setPointer(const QString& text);
    /// What the worst place is worst of.
    void setMeasure(Measure measure);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    class HintLabel;
    QLabel* add(const QString& name, const QString& help, const QString& widest);
    void showFrame();
    void showTime(double milliseconds);
    void makeRoom(const QString& words);

    QStatusBar& m_bar;
    ShapeSession& m_session;
    SeenDelay m_delay;
    Measure m_measure = Measure::Length;
    HintLabel* m_hint;
    QString m_told, m_tip;  // the last ones
    QDeadlineTimer m_toldUntil;
    QList<QLabel*> m_numbers;  // from the left
    QLabel *m_time, *m_pointer, *m_pinError, *m_worst, *m_area;
    QString m_words;  // that room was made for
    int m_room = 0;   // for them, pixels
    bool m_isShown = false;
};

}  // namespace wend
