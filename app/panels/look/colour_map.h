#pragma once

#include <QColor>
#include <QString>
#include <vector>

#include "app/session/measure.h"
#include "app/session/shape_session.h"

namespace wend {

struct Distortion;

/// How much a map covers the picture below it, unless another amount is chosen.
inline constexpr double kMapOpacity = 0.65;

/// True for those that tell how far the shape is from rest.
bool isDistortion(Measure measure);
/// All that such a shape has, in the order of the list from which one is chosen.
std::vector<Measure> measuresOf(int dimension);

/// The range of a legend; for Area it is symmetric about 1 in the logarithm.
struct MeasureRange {
    double low = 0, high = 1;
    int dimension = 2;
};

/// The field that a measure is made of, in the session as it stands: the velocity, the influence, or none.
template <int Dim>
Points<Dim> fieldOf(const ShapeSession& session, Measure measure);
/// What is to be solved for: for a map, where one is shown, otherwise for arrows.
ShapeSession::FieldKind wantedField(bool map, Measure measure, bool arrows);
/// The value of one cell: the errors of docs/method.md for angle and length, the ratio det F for area.
/// Without a field (no columns) nothing has a speed or an influence.
template <int Dim>
double cellValue(const PosedFrame<Dim>& frame, const Points<Dim>& velocity, Measure measure, int cell);
/// Of all cells.
template <int Dim>
std::vector<double> cellValues(const PosedFrame<Dim>& frame, Measure measure,
                               const Points<Dim>& velocity = {});
/// Of the frame that is shown.
std::vector<double> shownValues(const ShapeSession& session, Measure measure);
/// The value of the material where nothing is painted; nothing for other measures.
std::optional<double> plainValue(const ShapeSession& session, Measure measure);
/// How wholly what is painted is seen at a place of the range, from 0 at that of the plain value to 1.
double paintedPart(double place, double plainPlace);
/// From the values that occur, the largest hundredth left out; never empty. φ has the same range always.
MeasureRange rangeOf(const std::vector<double>& values, Measure measure, int dimension = 2);
/// Where a value stands in the range, in [0, 1]; area, stiffness and the size of cells on a logarithmic
/// scale, area with 1 in the middle; φ as on the slider of energies.
double positionIn(const MeasureRange& range, Measure measure, double value);
double valueAt(const MeasureRange& range, Measure measure, double position);
/// How many of the values stand in each of that many equal parts of the range; those beyond it in the last.
std::vector<int> histogramOf(const std::vector<double>& values, Measure measure, const MeasureRange& range,
                             int parts);

/// A colour for a position in [0, 1]: for φ those of the four energies, for stiffness from cream to brown,
/// for errors a scale of even perceived steps from light yellow over red to dark violet; for the ratio blue
/// (shrunk), near white (kept) and orange (grown). Both are safe for colour-blind eyes.
QRgb colourAt(Measure measure, double position);

QString measureName(Measure measure, int dimension = 2);
/// A value as the legend writes it: "×1.25" for area, "0.031" for errors.
QString measureText(Measure measure, double value);

/// Where the shape is farthest from rest by a measure; of measures that tell nothing of that, by length.
struct WorstPlace {
    int cell = -1;  // −1 if the shape has none
    double value = 0;
};
WorstPlace worstOf(const Distortion& distortion, Measure measure);
/// False where that is no more than rounding.
bool isDistorted(const Distortion& distortion, Measure measure);
/// Its value and what that is, such as "area ×1.38".
QString worstText(const Distortion& distortion, Measure measure, int dimension = 2);
/// Where that is more than twice as long or large as at rest, or less than half as large, in words with the
/// value, such as "Stretched too far here · 12.3"; else, and by other measures, null.
QString worstWarning(const Distortion& distortion, Measure measure);

}  // namespace wend
