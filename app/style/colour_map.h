#pragma once

#include <QColor>
#include <QString>
#include <vector>

#include "app/engine/measure.h"
#include "app/session/shape_motion.h"

namespace wend {

struct Distortion;

/// Default opacity of a map over a picture.
inline constexpr double kMapOpacity = 0.65;

/// Returns whether a measure describes the distance from rest.
bool isDistortion(Measure measure);
/// Returns all measures of this dimension in the order of the list.
std::vector<Measure> measuresOf(int dimension);

/// The range of a legend; for Area it is symmetric about 1 in the logarithm.
struct MeasureRange {
    double low = 0, high = 1;
    int dimension = 2;
    bool logarithmic = false;           // where the measure leaves the choice, and low is positive
    bool below = false, above = false;  // some values are beyond its ends

    bool operator==(const MeasureRange&) const = default;
};

/// Returns the motion's field that a measure needs: velocity, influence or none.
Eigen::MatrixXd fieldOf(const ShapeMotion& motion, Measure measure);
/// Returns the field to solve for: that of the map if one is shown, otherwise that of arrows.
ShapeMotion::FieldKind wantedField(bool map, Measure measure, bool arrows);
/// Returns the values of the shown frame.
std::vector<double> shownValues(const ShapeMotion& motion, Measure measure);
/// Returns the value of the material where nothing is painted; nothing for other measures.
std::optional<double> plainValue(const ShapeMotion& motion, Measure measure);
/// Returns the opacity of paint at a position in the range: 0 at the plain value, up to 1.
double paintedPart(double place, double plainPlace);
/// Returns a range without the largest hundredth of the values, never empty. φ always has the same range.
MeasureRange rangeOf(const std::vector<double>& values, Measure measure, int dimension = 2);
/// Returns whether a measure is even unless its range is logarithmic.
bool leavesScale(Measure measure);
/// Sets whether values lie beyond the ends.
void findBeyond(const std::vector<double>& values, MeasureRange& range);
/// Returns the values of a quality of cells at rest; none for other measures.
std::vector<double> restValues(const ShapeMotion& motion, Measure measure);
/// Returns the position of a value in the range, in [0, 1]; area, stiffness and cell size are logarithmic,
/// area with 1 in the middle; φ as on the energy slider.
double positionIn(const MeasureRange& range, Measure measure, double value);
double valueAt(const MeasureRange& range, Measure measure, double position);
/// Counts values in equal parts of the range; values beyond it count in the last part.
std::vector<int> histogramOf(const std::vector<double>& values, Measure measure, const MeasureRange& range,
                             int parts);

/// Returns the colour of a position in [0, 1]: for φ those of the four energies, for stiffness from cream to
/// brown, for errors perceptually uniform from light yellow over red to dark violet, for ratios blue
/// (shrunk), near white (kept) and orange (grown). Safe for colour-blind users.
QRgb colourAt(Measure measure, double position);

QString measureName(Measure measure, int dimension = 2);
/// Returns a value as the legend writes it: "×1.25" for area, "0.031" for errors.
QString measureText(Measure measure, double value);

/// The cell that is farthest from rest by a measure, or by length for measures without that meaning.
struct WorstPlace {
    int cell = -1;  // −1 if the shape has none
    double value = 0;
};
WorstPlace worstOf(const Distortion& distortion, Measure measure);
/// Returns false if the worst value is rounding.
bool isDistorted(const Distortion& distortion, Measure measure);
/// Returns the value with its meaning, such as "area ×1.38".
QString worstText(const Distortion& distortion, Measure measure, int dimension = 2);
/// Returns a warning such as "Stretched too far here · 12.3" if that cell is more than twice or less than
/// half its rest size; null otherwise and for other measures.
QString worstWarning(const Distortion& distortion, Measure measure);

}  // namespace wend
