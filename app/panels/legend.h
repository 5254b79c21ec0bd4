#pragma once

#include <QToolButton>

#include "app/style/colour_map.h"

namespace wend {

/// A bar with the colours of a measure and the values at its ends and middle; above it how much of the shape
/// has which, and perhaps had at rest. "≥" and "≤" at the ends say that values lie beyond.
class Legend : public QWidget {
    Q_OBJECT

  public:
    explicit Legend(QWidget* parent = nullptr);
    void set(Measure measure, const MeasureRange& range, int dimension = 2,
             const std::vector<double>& values = {}, const std::vector<double>& before = {});
    static constexpr int kParts = 48;  // of the histogram
    const std::vector<int>& histogram() const { return m_histogram; }
    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    Measure m_measure = Measure::Length;
    MeasureRange m_range;
    std::vector<int> m_histogram, m_before;  // of the shape, and of that at rest as a line
};

/// Paints the bar and its values into a rectangle, in the painter's font.
void paintLegend(QPainter& painter, const QRect& where, Measure measure, const MeasureRange& range,
                 const QColor& textColour);

/// Paints the same on a card at the lower right of a view of that size.
void paintLegendCard(QPainter& painter, const QSize& view, Measure measure, const MeasureRange& range,
                     const QPalette& palette, int dimension);

/// A lock at the card's upper right, for the panel's own action: the colours keep their range.
class LegendLock : public QToolButton {
  public:
    LegendLock(QAction& keep, QWidget& view);

  protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void showIcons();
    void place();
};

}  // namespace wend
