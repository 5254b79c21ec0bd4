#pragma once

#include <QColor>
#include <QString>
#include <vector>

#include "core/energy/distortion.h"

namespace wend {

/// Which measure of distortion is shown over the shape.
enum class Measure { Angle, Area, Length };

/// The range of a legend; for Area it is symmetric about 1 in the logarithm.
struct MeasureRange {
    double low = 0, high = 1;
};

/// The value of each cell: the errors of method.md for angle and length, the ratio det F for area.
const std::vector<double>& valuesOf(const Distortion& distortion, Measure measure);
/// From the values that occur, the greatest hundredth left out; never empty.
MeasureRange rangeOf(const std::vector<double>& values, Measure measure);
/// Where a value stands in the range, in [0, 1]; area on a logarithmic scale with 1 in the middle.
double positionIn(const MeasureRange& range, Measure measure, double value);
double valueAt(const MeasureRange& range, Measure measure, double position);

/// A colour for a position in [0, 1]: for errors a scale of even perceived steps from light yellow over red
/// to dark violet; for the ratio blue (shrunk), near white (kept) and orange (grown). Both are safe for
/// colour-blind eyes.
QRgb colourAt(Measure measure, double position);

QString measureName(Measure measure);

}  // namespace wend
