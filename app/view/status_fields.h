#pragma once

#include <QObject>

#include "app/panels/colour_map.h"

class QLabel;
class QStatusBar;

namespace wend {

/// The status bar: what the tool does, where the pointer is, and how well the shape keeps what it should.
class StatusFields : public QObject {
    Q_OBJECT

  public:
    StatusFields(QStatusBar& bar, ShapeSession& session);

    void setVisible(bool visible);
    /// Of a hint, what there is room for beside the numbers: whole sentences, or the beginning of one.
    QString fitting(const QString& hint) const;

  public slots:
    void setHint(const QString& hint);
    void setPointer(double x, double y, bool inside);
    /// What is under the pointer, in words of the view.
    void setPointerText(const QString& text);
    /// What the worst place is worst of.
    void setMeasure(Measure measure);

  private:
    class HintLabel;
    QLabel* add(const QString& name, const QString& help, const QString& widest);
    void showFrame();

    QStatusBar& m_bar;
    ShapeSession& m_session;
    Measure m_measure = Measure::Length;
    HintLabel* m_hint;
    QLabel *m_pointer, *m_pinError, *m_worst, *m_area, *m_time;
};

}  // namespace wend
