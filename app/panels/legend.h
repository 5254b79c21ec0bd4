#pragma once

#include <QWidget>

#include "app/panels/colour_map.h"

namespace wend {

/// A bar with the colours of a measure and the values at its ends and middle.
class Legend : public QWidget {
    Q_OBJECT

  public:
    explicit Legend(QWidget* parent = nullptr);
    void set(Measure measure, const MeasureRange& range, int dimension = 2);
    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    Measure m_measure = Measure::Length;
    MeasureRange m_range;
};

/// The bar and its values in a rectangle, in the painter's font.
void paintLegend(QPainter& painter, const QRect& where, Measure measure, const MeasureRange& range,
                 const QColor& textColour);

}  // namespace wend
